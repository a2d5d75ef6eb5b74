#include "control/guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "control/set_point_track.h"
#include "robot/collision_pairs.h"
#include "robot/index.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr double kStride = 0.02;  // most that any point moves between two looks ahead [m]
// As it moves on with every tick, the end of the way passes every posture of it: a few looks suffice.
constexpr int kLooksObeyed = 3, kLooksMasked = 3, kLooksBraked = 2;
constexpr int kMostRounds = 4;  // of masking more joints because those masked first are not enough
// A pair at the margin may still come this much nearer before it rests, against flicker; inside of
// it the less the nearer it is, so that it never arrives [m].
constexpr double kNearer = 1e-4;
// A joint that runs on farther than its set-point says, by this much, is looked at as it is measured
// [rad or m].
constexpr double kRunsOn = 0.01;
constexpr double kShare = 0.02;  // of the approach: joints that do less of it are not masked
constexpr int kKeepTicks = 5;    // a mask outlives its cause by this, against flicker
// Deeper than this a model says nothing about which way is out, and nothing is held [m].
constexpr double kLost = 0.03;
constexpr double kAnywhere = 100.0;  // [m]
constexpr double kNever = 1e3;       // time to contact of a pair that parts [s]

}  // namespace

struct Guard::Impl {
  const Model* model;
  GuardConfig config;
  Collision collision;
  SetPointTrack track;
  Kinematics now_kinematics, then_kinematics;
  Configuration now, then;
  std::vector<int> leg;  // [joint_count], 1 for leg joints
  std::vector<std::uint8_t>
      moves;  // [link_count x joint_count]: the joint is on the way from the base to the link
  using Courses = std::vector<Course>;  // [joint_count]
  Courses braked, obeyed, masked;
  Eigen::VectorXd rests;          // of a course [joint_count]
  Collision::Ahead ahead_of_now;  // all courses that this tick may look along
  std::array<PairDistance, kMaxPairs> pairs{}, ahead{};
  int pair_count = 0;
  double least_share = kShare;
  std::int64_t all_but_legs = 0;
  std::array<int, kMaxJoints> keep{};  // ticks left of a mask
  std::int64_t run_id = 0;
  GuardReport report;

  Impl(const Model& robot, const GuardConfig& wanted);
  bool moves_link(int joint, int link) const noexcept {
    return link < model->link_count() && moves[at(link * model->joint_count() + joint)] != 0;
  }

  void predict(const RobotState& state, const JointCommand* command) noexcept;
  void predict_masked(std::int64_t mask) noexcept;
  void spread_to_mimics(Courses& courses) const noexcept;
  bool runs_on() noexcept;
  void bound_moves() noexcept;
  double bound_travel(const Courses& courses) noexcept;
  void measure_then(PairDistance& pair) noexcept;
  bool pair_now(const PairDistance& pair, PairDistance& found) noexcept;
  void look_along(const Courses& courses, int most_looks, std::int64_t& mask, bool& leg_hit,
                  bool& danger) noexcept;
  bool comes_too_near(const PairDistance& before, const PairDistance& after) const noexcept;
  double approach(const Kinematics& kinematics, const PairDistance& pair, int joint,
                  double step) const noexcept;
  void blame(const PairDistance& before, const PairDistance& after, const Courses& courses,
             std::int64_t& mask, bool& leg_hit) noexcept;
  bool blame_at(const Kinematics& kinematics, const PairDistance& pair, const Courses& courses,
                std::int64_t& mask, bool& leg_hit) const noexcept;
  void mask_joint(int joint, std::int64_t& mask) const noexcept;
  void fill_rows() noexcept;
};

Guard::Impl::Impl(const Model& robot, const GuardConfig& wanted)
    : model(&robot),
      config(wanted),
      collision(robot),
      track(robot, wanted.delay_ticks, wanted.servo_lag),
      now_kinematics(robot),
      then_kinematics(robot),
      now(robot),
      then(robot) {
  const auto joints = robot.joints.size();
  leg.assign(joints, 0);
  for (const int joint : robot.leg_joints) leg[at(joint)] = 1;
  for (int k = 0; k < std::min(robot.bus_count(), kMaxJoints); ++k) {
    if (leg[at(robot.bus_joints[at(k)])] == 0) all_but_legs |= bit(k);
  }
  braked.assign(joints, {});
  obeyed = masked = braked;
  rests = ahead_of_now.moves = Eigen::VectorXd::Zero(robot.joint_count());
  ahead_of_now.near = wanted.margin;
  for (int link = 0; link < robot.link_count(); ++link) {
    for (int joint = 0; joint < robot.joint_count(); ++joint) {
      moves.push_back(joint_moves_pair(robot, joint, link, -1) ? 1 : 0);
    }
  }
}

void Guard::Impl::spread_to_mimics(Courses& courses) const noexcept {
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[at(j)];
    if (joint.mimic < 0 || joint.mimic_multiplier == 0.0) continue;
    const Course& of = courses[at(joint.mimic)];
    const double m = joint.mimic_multiplier;
    courses[at(j)] = {m * of.first, m * of.speed, std::abs(m) * of.brake};
  }
}

void Guard::Impl::predict(const RobotState& state, const JointCommand* command) noexcept {
  if (command != nullptr) track.follow(state, *command, report.hold_mask);
  const int count = std::min({model->bus_count(), kMaxJoints, static_cast<int>(state.joint_count)});
  for (int k = 0; k < count; ++k) {
    const auto joint = at(model->bus_joints[at(k)]);
    braked[joint] = track.if_braked(at(k), static_cast<double>(state.qd[at(k)]));
    obeyed[joint] = command != nullptr ? track.if_obeyed(at(k)) : braked[joint];
  }
  spread_to_mimics(braked);
  spread_to_mimics(obeyed);
}

// The masked joints braked, the others obeyed: what will happen with this mask.
void Guard::Impl::predict_masked(std::int64_t mask) noexcept {
  masked = obeyed;
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    if ((mask & bit(k)) != 0) masked[at(model->bus_joints[at(k)])] = track.if_held(at(k));
  }
  spread_to_mimics(masked);
}

// A joint that runs on farther than its set-point says is obeyed as it is measured.  Does one run
// on the other way?
bool Guard::Impl::runs_on() noexcept {
  bool other_way = false;
  for (std::size_t j = 0; j < braked.size(); ++j) {
    const double way = braked[j].rest(), told = obeyed[j].rest();
    if (way * told > 0.0) {
      if (std::abs(way) > std::abs(told)) obeyed[j] = braked[j];
    } else {
      other_way = other_way || std::abs(way) > kRunsOn;
    }
  }
  return other_way;
}

// The most that a joint moves from here on any course that is looked along.
void Guard::Impl::bound_moves() noexcept {
  Eigen::VectorXd& farthest = ahead_of_now.moves;
  const auto longer = [](double most, const Course& c) {
    return std::max({most, std::abs(c.first), std::abs(c.rest())});
  };
  for (std::size_t j = 0; j < obeyed.size(); ++j)
    farthest[static_cast<Eigen::Index>(j)] = longer(longer(0.0, obeyed[j]), braked[j]);
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    double& most = farthest[model->bus_joints[at(k)]];
    most = longer(most, track.if_held(at(k)));
  }
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[at(j)];
    if (joint.mimic >= 0) farthest[j] = std::abs(joint.mimic_multiplier) * farthest[joint.mimic];
  }
}

// The most that two links come nearer on these courses [m].
double Guard::Impl::bound_travel(const Courses& courses) noexcept {
  for (int j = 0; j < model->joint_count(); ++j) rests[j] = std::abs(courses[at(j)].rest());
  double most = 0.0, second = 0.0;
  for (int link = 1; link < model->link_count(); ++link) {
    const double travel = collision.reach().between(link, 0, rests);
    second = std::max(second, std::min(travel, most));
    most = std::max(most, travel);
  }
  return most + second;
}

// The same pair as it is now.
bool Guard::Impl::pair_now(const PairDistance& pair, PairDistance& found) noexcept {
  for (int p = 0; p < pair_count; ++p) {
    found = pairs[at(p)];
    if (found.link_a == pair.link_a && found.link_b == pair.link_b) return true;
  }
  return collision.pair_nearer_than(now_kinematics, pair.link_a, pair.link_b, kAnywhere, found);
}

bool Guard::Impl::comes_too_near(const PairDistance& before,
                                 const PairDistance& after) const noexcept {
  const double inside = std::clamp(before.distance / config.margin, 0.0, 1.0);
  return after.distance < config.margin &&
         after.distance < before.distance - kNearer * inside * inside && before.distance > -kLost;
}

// Change of the distance of the pair when `joint` moves by `step`, to first order [m].
double Guard::Impl::approach(const Kinematics& kinematics, const PairDistance& pair, int joint,
                             double step) const noexcept {
  const bool with_a = moves_link(joint, pair.link_a);
  const bool with_b = moves_link(joint, pair.link_b);
  if (with_a == with_b || step == 0.0) return 0.0;
  const Vector3d& point = with_a ? pair.point_a : pair.point_b;
  const Vector3d& axis = kinematics.axis_in_world(joint);
  const Vector3d motion =
      model->joints[at(joint)].kind == JointKind::kPrismatic
          ? axis
          : Vector3d(axis.cross(point - kinematics.link_in_world(joint + 1).translation()));
  return (with_b ? step : -step) * pair.normal.dot(motion);
}

void Guard::Impl::mask_joint(int joint, std::int64_t& mask) const noexcept {
  const int driver = model->joints[at(joint)].mimic >= 0 ? model->joints[at(joint)].mimic : joint;
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    if (model->bus_joints[at(k)] == driver) mask |= std::int64_t{1} << k;
  }
}

// Masks the joints that bring the pair together as seen from this posture; false if none does.
bool Guard::Impl::blame_at(const Kinematics& kinematics, const PairDistance& pair,
                           const Courses& courses, std::int64_t& mask,
                           bool& leg_hit) const noexcept {
  double together = 0.0;
  double by_legs = 0.0;
  for (int j = 0; j < model->joint_count(); ++j) {
    const double change = approach(kinematics, pair, j, courses[at(j)].rest());
    if (!(change < 0.0)) continue;
    together -= change;
    if (leg[at(j)] != 0) by_legs -= change;
  }
  if (!(together > kNearer)) return false;
  for (int j = 0; j < model->joint_count(); ++j) {
    if (leg[at(j)] != 0) continue;
    if (approach(kinematics, pair, j, courses[at(j)].rest()) < -least_share * together)
      mask_joint(j, mask);
  }
  leg_hit = leg_hit || by_legs > 0.5 * together;
  return true;
}

void Guard::Impl::blame(const PairDistance& before, const PairDistance& after,
                        const Courses& courses, std::int64_t& mask, bool& leg_hit) noexcept {
  if (blame_at(now_kinematics, before, courses, mask, leg_hit)) return;
  PairDistance then_pair = after;
  if (!(after.distance > 0.0)) measure_then(then_pair);
  if (blame_at(then_kinematics, then_pair, courses, mask, leg_hit)) return;
  // A curved way in: whatever moves either of them.
  for (int j = 0; j < model->joint_count(); ++j) {
    if (moves_link(j, before.link_a) == moves_link(j, before.link_b) ||
        courses[at(j)].rest() == 0.0)
      continue;
    if (leg[at(j)] != 0) {
      leg_hit = true;
    } else {
      mask_joint(j, mask);
    }
  }
}

// Depth, points and normal at the posture looked at, which a look leaves out.
void Guard::Impl::measure_then(PairDistance& pair) noexcept {
  PairDistance measured;
  if (collision.pair_nearer_than(then_kinematics, pair.link_a, pair.link_b, config.margin,
                                 measured))
    pair = measured;
}

// Looks at postures on the way from here to rest, near enough to each other that nothing slips
// between them.
void Guard::Impl::look_along(const Courses& courses, int most_looks, std::int64_t& mask,
                             bool& leg_hit, bool& danger) noexcept {
  if (!collision.any_ahead()) return;
  const double farthest = bound_travel(courses);
  if (!(farthest > kNearer)) return;
  const int looks = std::clamp(static_cast<int>(std::ceil(farthest / kStride)), 1, most_looks);
  double longest = 0.0;  // brake [s]
  for (const Course& c : courses) longest = std::max(longest, std::abs(c.speed) / c.brake);
  then.base = now.base;
  for (int look = 1; look <= looks; ++look) {
    // The first when the brake comes, the others evenly along what is braked evenly.
    const double share = looks == 1 ? 1.0 : static_cast<double>(look - 1) / (looks - 1);
    const double braked_for = longest * (1.0 - std::sqrt(1.0 - share));
    for (int j = 0; j < model->joint_count(); ++j)
      then.q[j] = now.q[j] + courses[at(j)].at(1.0, braked_for);
    then_kinematics.update(then);
    const int count = collision.near_pairs_ahead(then_kinematics, ahead.data(), kMaxPairs);
    bool found = false;
    for (int p = 0; p < count; ++p) {
      PairDistance& pair = ahead[at(p)];
      PairDistance before;
      if (!pair_now(pair, before)) continue;
      if (!(before.distance > 0.0) && !(pair.distance > 0.0)) measure_then(pair);
      if (!comes_too_near(before, pair)) continue;
      found = true;
      blame(before, pair, courses, mask, leg_hit);
    }
    if (!found) continue;
    danger = true;
    return;  // what else is on the way shows when this has been held
  }
}

void Guard::Impl::fill_rows() noexcept {
  const Eigen::Isometry3d to_base = now.base.inverse();
  int near = 0;
  for (int p = 0; p < pair_count; ++p) near += pairs[at(p)].distance <= config.near ? 1 : 0;
  near = std::min(near, kGuardPairs);
  report.pairs_near = static_cast<std::int16_t>(near);
  for (int p = 0; p < kGuardPairs; ++p) {
    const auto i = at(p);
    const PairDistance pair = p < near ? pairs[i] : PairDistance{};
    const Vector3d a = p < near ? Vector3d(to_base * pair.point_a) : Vector3d::Zero();
    const Vector3d b = p < near ? Vector3d(to_base * pair.point_b) : Vector3d::Zero();
    double speed = 0.0;  // of approach [m/s]
    for (int j = 0; p < near && j < model->joint_count(); ++j)
      speed -= approach(now_kinematics, pair, j, now.qd[j]);
    const double time =
        speed > 1e-6 ? std::min(std::max(pair.distance, 0.0) / speed, kNever) : kNever;
    report.link_a[i] = static_cast<std::int16_t>(pair.link_a);
    report.link_b[i] = static_cast<std::int16_t>(pair.link_b);
    report.distance[i] = static_cast<float>(pair.distance);
    report.time_to_contact[i] = p < near ? static_cast<float>(time) : 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      report.point_a[i][k] = static_cast<float>(a[static_cast<int>(k)]);
      report.point_b[i][k] = static_cast<float>(b[static_cast<int>(k)]);
    }
  }
}

Guard::Guard(const Model& model, const GuardConfig& config)
    : impl_(std::make_unique<Impl>(model, config)) {}
Guard::~Guard() = default;

const GuardReport& Guard::report() const noexcept { return impl_->report; }
const PairDistance* Guard::pairs() const noexcept { return impl_->pairs.data(); }
int Guard::pair_count() const noexcept { return impl_->pair_count; }
void Guard::set_obstacles(const std::vector<Obstacle>& obstacles) {
  impl_->collision.set_obstacles(obstacles);
}

void Guard::reset() noexcept {
  impl_->track.reset();
  impl_->keep.fill(0);
  impl_->report = GuardReport{};
}

const GuardReport& Guard::check(const RobotState& state, const JointCommand* command,
                                const Configuration& base) noexcept {
  Impl& i = *impl_;
  if (state.run_id != i.run_id) reset();  // another source: its set-points are not ours
  i.run_id = state.run_id;

  i.now.base = base.base;
  set_joints(*i.model, state, i.now);
  i.now_kinematics.update(i.now);
  i.predict(state, command);
  i.bound_moves();
  i.pair_count = i.collision.near_pairs(i.now_kinematics, std::max(i.config.near, i.config.margin),
                                        i.pairs.data(), kMaxPairs, &i.ahead_of_now);

  std::int64_t mask = 0;
  bool leg_hit = false;
  bool danger = false;
  i.least_share = kShare;
  const bool other_way = i.runs_on();
  i.look_along(i.obeyed, kLooksObeyed, mask, leg_hit, danger);
  if (other_way) i.look_along(i.braked, kLooksBraked, mask, leg_hit, danger);
  for (int round = 0; command != nullptr && mask != 0; ++round) {
    const std::int64_t before = mask;
    i.predict_masked(mask);
    i.least_share = 0.0;
    i.look_along(i.masked, kLooksMasked, mask, leg_hit, danger);
    if (mask == before) break;
    if (round + 1 < kMostRounds) continue;
    mask |= i.all_but_legs;  // a brake of all was safe when it was looked at last
    break;
  }
  for (std::size_t k = 0; k < at(kMaxJoints); ++k) {
    const bool caused = ((mask >> k) & 1) != 0;
    i.keep[k] = caused ? kKeepTicks : std::max(0, i.keep[k] - 1);
    if (i.keep[k] > 0) mask |= std::int64_t{1} << k;
  }

  GuardReport& report = i.report;
  report.tick = state.tick;
  report.run_id = state.run_id;
  report.guard_id = i.config.guard_id;
  report.hold_mask = mask;
  report.compute_ns = 0;
  report.stop_asked = leg_hit;
  report.pairs_checked = static_cast<std::int16_t>(
      std::min<std::size_t>(static_cast<std::size_t>(i.collision.pair_count()),
                            std::numeric_limits<std::int16_t>::max()));
  i.fill_rows();
  const bool touching = i.pair_count > 0 && !(i.pairs[0].distance > 0.0);
  report.verdict = touching                ? GuardVerdict::kInCollision
                   : danger                ? GuardVerdict::kWillCollide
                   : report.pairs_near > 0 ? GuardVerdict::kNear
                                           : GuardVerdict::kClear;
  return report;
}

}  // namespace twinbus
