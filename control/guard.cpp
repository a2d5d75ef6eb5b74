#include "control/guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "control/course_way.h"
#include "control/set_point_track.h"
#include "robot/collision_pairs.h"
#include "robot/index.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr int kMostOpen = 128;  // pairs that are looked at one by one at once
constexpr int kMostParts =
    3;  // a stretch that is not proved is looked at in parts, and so are these
constexpr int kMostStretches = 24, kMostLooks = 150;  // of a tick
constexpr double kProved = 0.5;  // of the margin or what is left of it: nothing comes nearer unseen
constexpr unsigned kDepths = 1U << 1U | 1U << 7U;  // places where those that touch are looked at
constexpr double kBarely = 1e-3;  // of pairs nearer than this nothing is proved on the way [m]
constexpr int kMostRounds = 8;  // of masking more joints because those masked first are not enough
// A pair at the margin may still come this much nearer before it rests, against flicker; inside of
// it the less the nearer it is, so that it never arrives [m].
constexpr double kNearer = 1e-4;
// A joint that runs on this much farther than its set-point says is looked at as it is measured.
constexpr double kRunsOn = 0.01;  // [rad or m]
constexpr double kShare = 0.02;   // of the approach: joints that do less of it are not masked
constexpr int kKeepTicks = 5;     // a mask outlives its cause by this, against flicker
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
  Eigen::VectorXd rests;              // of a course [joint_count]
  Eigen::VectorXd reaches;            // of joints [joint_count]
  Eigen::VectorXd changes;            // of a distance, by joints [joint_count, m]
  std::vector<std::int64_t> bits_of;  // of a joint, or of the one it follows, on the bus
  Collision::Ahead ahead_of_now;      // all courses that this tick may look along
  SweptShapes::Way places;
  std::array<PairDistance, kMaxPairs> pairs{};
  int pair_count = 0;
  std::array<std::array<Collision::OnWay, kMostOpen>, kMostParts> open;
  int suspect = -1;  // shapes that came too near when a way was looked along last
  int stretches_left = 0, looks_left = 0;
  std::int64_t unproved = 0;
  std::int64_t mask = 0;  // the answer of this tick, like the next two
  bool leg_hit = false, danger = false;
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
  void predict_masked(std::int64_t held) noexcept;
  bool runs_on() noexcept;
  void bound_moves() noexcept;
  const PairDistance* near_now(int link_a, int link_b) const noexcept;
  bool look_along(const Courses& courses) noexcept;
  double travel(const Courses& courses, const Courses* other) noexcept;
  void go_to(const CourseWay& way, double share) noexcept;
  bool judge(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses,
             Collision::OnWay& pair) noexcept;
  bool look(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses, int part,
            int count) noexcept;
  bool hold_all() noexcept;
  void prove_mask() noexcept;
  bool comes_too_near(const PairDistance& before, const PairDistance& after) const noexcept;
  double approach(const Kinematics& kinematics, const PairDistance& pair, int joint,
                  double step) const noexcept;
  void blame(const PairDistance& before, const PairDistance& after, const CourseWay& way,
             double share, const Courses& courses) noexcept;
  bool blame_at(const Kinematics& kinematics, const PairDistance& pair,
                const Courses& courses) noexcept;
  double approach_speed(const PairDistance& pair) const noexcept;
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
  for (std::size_t j = 0; j < joints; ++j) {
    const int driver = robot.joints[j].mimic >= 0 ? robot.joints[j].mimic : static_cast<int>(j);
    std::int64_t bits = 0;
    for (int k = 0; k < std::min(robot.bus_count(), kMaxJoints); ++k) {
      if (robot.bus_joints[at(k)] == driver) bits |= bit(k);
    }
    bits_of.push_back(bits);
  }
  braked.assign(joints, {});
  obeyed = masked = braked;
  ahead_of_now.q = now.q;
  rests = ahead_of_now.moves = reaches = changes = Eigen::VectorXd::Zero(robot.joint_count());
  for (int joint = 0; joint < robot.joint_count(); ++joint)
    reaches[joint] = collision.reach().farthest(joint);
  places.q.resize(joints);
  places.bend.resize(joints);
  places.asked.assign(joints, 1);
  ahead_of_now.near = wanted.margin;
  ahead_of_now.enough = kGuardPairs;
  for (int link = 0; link < robot.link_count(); ++link) {
    for (int joint = 0; joint < robot.joint_count(); ++joint) {
      moves.push_back(joint_moves_pair(robot, joint, link, -1) ? 1 : 0);
    }
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
  spread_to_mimics(*model, braked);
  spread_to_mimics(*model, obeyed);
}

// What is held braked, the others obeyed: what will happen with this mask.
void Guard::Impl::predict_masked(std::int64_t held) noexcept {
  masked = obeyed;
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    if ((held & bit(k)) != 0) masked[at(model->bus_joints[at(k)])] = track.if_held(at(k));
  }
  spread_to_mimics(*model, masked);
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

// No two links come nearer by more than this on these courses, or other than on others [m].
double Guard::Impl::travel(const Courses& courses, const Courses* other) noexcept {
  apart(courses, other, rests);
  return rests.dot(reaches);
}

// The same pair as it is now; null when it is farther apart than any that is kept.
const PairDistance* Guard::Impl::near_now(int link_a, int link_b) const noexcept {
  for (int p = 0; p < pair_count; ++p) {
    const PairDistance& pair = pairs[at(p)];
    if (pair.link_a == link_a && pair.link_b == link_b) return &pair;
  }
  return nullptr;
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
  if (step == 0.0) return 0.0;
  const bool with_a = moves_link(joint, pair.link_a);
  const bool with_b = moves_link(joint, pair.link_b);
  if (with_a == with_b) return 0.0;
  const Vector3d& point = with_a ? pair.point_a : pair.point_b;
  const Vector3d& axis = kinematics.axis_in_world(joint);
  const Vector3d motion =
      model->joints[at(joint)].kind == JointKind::kPrismatic
          ? axis
          : Vector3d(axis.cross(point - kinematics.link_in_world(joint + 1).translation()));
  return (with_b ? step : -step) * pair.normal.dot(motion);
}

// Masks the joints that bring the pair together as seen from this posture; false if none does.
bool Guard::Impl::blame_at(const Kinematics& kinematics, const PairDistance& pair,
                           const Courses& courses) noexcept {
  double together = 0.0;
  double by_legs = 0.0;
  for (int j = 0; j < model->joint_count(); ++j) {
    const double change = approach(kinematics, pair, j, courses[at(j)].rest());
    changes[j] = change;
    if (!(change < 0.0)) continue;
    together -= change;
    if (leg[at(j)] != 0) by_legs -= change;
  }
  if (!(together > kNearer)) return false;
  for (int j = 0; j < model->joint_count(); ++j) {
    if (leg[at(j)] == 0 && changes[j] < -least_share * together) mask |= bits_of[at(j)];
  }
  leg_hit = leg_hit || by_legs > 0.5 * together;
  return true;
}

void Guard::Impl::go_to(const CourseWay& way, double share) noexcept {
  then.base = now.base;
  then.q = now.q;
  way.go_on(share, then.q);
  then_kinematics.update(then);
}

void Guard::Impl::blame(const PairDistance& before, const PairDistance& after, const CourseWay& way,
                        double share, const Courses& courses) noexcept {
  if (blame_at(now_kinematics, before, courses)) return;
  go_to(way, share);
  PairDistance then_pair = after;
  if (!(after.distance > 0.0) &&  // depth, points and normal, which a look leaves out
      !collision.pair_nearer_than(then_kinematics, after.link_a, after.link_b, config.margin,
                                  then_pair))
    then_pair = after;
  if (blame_at(then_kinematics, then_pair, courses)) return;
  // A curved way in: whatever moves either of them.
  for (int j = 0; j < model->joint_count(); ++j) {
    if (moves_link(j, before.link_a) == moves_link(j, before.link_b) ||
        courses[at(j)].rest() == 0.0)
      continue;
    if (leg[at(j)] != 0) {
      leg_hit = true;
    } else {
      mask |= bits_of[at(j)];
    }
  }
}

// What cannot be proved is answered by a brake of all, which was safe when it was looked at last.
bool Guard::Impl::hold_all() noexcept {
  ++unproved;
  mask |= all_but_legs;
  return true;
}

// Does the pair come too near at one of these places?  If not, pair.open says what is not proved.
bool Guard::Impl::judge(const CourseWay& way, const CourseWay::Shares& shares,
                        const Courses& courses, Collision::OnWay& pair) noexcept {
  const PairDistance* before = near_now(pair.link_a, pair.link_b);
  const double distance = before != nullptr ? before->distance : config.margin;
  pair.clear = kProved * std::min(distance, config.margin);
  collision.begin(pair);
  if (distance < kBarely) pair.open = 0;
  if (!(distance > 0.0)) pair.asked = ~kDepths;
  PairDistance found, far;
  for (int place;
       (place = collision.nearer_on_way(pair, !(distance > 0.0), looks_left, found)) >= 0;) {
    if (before == nullptr &&
        collision.pair_nearer_than(now_kinematics, pair.link_a, pair.link_b, kAnywhere, far))
      before = &far;
    if (before == nullptr || !comes_too_near(*before, found)) continue;
    suspect = pair.pair;
    blame(*before, found, way, shares[at(place)], courses);
    return true;
  }
  return false;
}

// Looks at these pairs at these places, then between them at what is not proved to stay apart; true when
// one comes too near.
bool Guard::Impl::look(const CourseWay& way, const CourseWay::Shares& shares,
                       const Courses& courses, int part, int count) noexcept {
  auto& pairs_open = open[at(part)];
  for (int p = 1; p < count; ++p) {
    if (pairs_open[at(p)].pair == suspect) std::swap(pairs_open[0], pairs_open[at(p)]);
  }
  const Collision::OnWay* found = nullptr;
  for (int p = 0; p < count; ++p) {
    Collision::OnWay& pair = pairs_open[at(p)];
    const bool again =
        found != nullptr && found->link_a == pair.link_a && found->link_b == pair.link_b;
    if (!again && judge(way, shares, courses, pair)) found = &pair;
  }
  if (found != nullptr) return true;
  for (int stretch = SweptShapes::kPlaces - 2; stretch >= 0; --stretch) {
    const auto is_open = [&](const Collision::OnWay& pair) {
      return (pair.open >> static_cast<unsigned>(stretch) & 1U) != 0;
    };
    if (std::none_of(pairs_open.begin(), pairs_open.begin() + count, is_open)) continue;
    if (part + 1 == kMostParts || stretches_left == 0 || looks_left == 0) return hold_all();
    --stretches_left;
    const auto next_end = std::copy_if(pairs_open.begin(), pairs_open.begin() + count,
                                       open[at(part + 1)].begin(), is_open);
    const auto parts = CourseWay::between(shares[at(stretch)], shares[at(stretch + 1)]);
    way.go(now.q, parts, places);
    collision.go(now.base, places);
    if (look(way, parts, courses, part + 1,
             static_cast<int>(next_end - open[at(part + 1)].begin())))
      return true;
  }
  return false;
}

// Masks more joints until nothing comes too near with this mask.  Those that are still held are let go
// with it, or stay where they are: both may come.
void Guard::Impl::prove_mask() noexcept {
  for (int round = 0; round < kMostRounds; ++round) {
    const std::int64_t before = mask, stay = mask | track.on_hold();
    if (mask != 0) {
      predict_masked(mask);
      least_share = 0.0;
      look_along(masked);
    }
    if (stay != before && mask == before) {
      predict_masked(stay);
      look_along(masked);
    }
    if (mask == 0) {  // commands may change at once, and then all is braked
      predict_masked(all_but_legs);
      if (travel(masked, &obeyed) > (1.0 - kProved) * config.margin) look_along(masked);
    }
    if (mask == before) return;
  }
  mask |= all_but_legs;  // a brake of all was safe when it was looked at last
}

// Looks along the way from here to rest; true when something comes too near.
bool Guard::Impl::look_along(const Courses& courses) noexcept {
  if (!(travel(courses, nullptr) > kNearer)) return false;
  if (!collision.narrow(rests, config.margin, places.asked)) return false;
  const CourseWay way(courses, track.delay());
  const CourseWay::Shares shares = way.shares();
  way.go(now.q, shares, places);
  collision.go(now.base, places);
  const int count =
      collision.open_on_way(config.margin, kProved * config.margin, open[0].data(), kMostOpen);
  const bool found = count > kMostOpen ? hold_all() : look(way, shares, courses, 0, count);
  danger = danger || found;
  return found;
}

// How fast the pair comes together now, at one point: what moves both does not count [m/s].
double Guard::Impl::approach_speed(const PairDistance& pair) const noexcept {
  const auto velocity = [&](int link) {
    return link < model->link_count() ? now_kinematics.point_velocity(link, pair.point_a)
                                      : Vector3d(Vector3d::Zero());
  };
  return pair.normal.dot(velocity(pair.link_a) - velocity(pair.link_b));
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
    const double speed = p < near ? approach_speed(pair) : 0.0;  // [m/s]
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
std::int64_t Guard::unproved() const noexcept { return impl_->unproved; }
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
  i.ahead_of_now.q = i.now.q;
  i.pair_count = i.collision.near_pairs(i.now_kinematics, std::max(i.config.near, i.config.margin),
                                        i.pairs.data(), kMaxPairs, &i.ahead_of_now);

  i.mask = 0, i.leg_hit = i.danger = false;
  i.least_share = kShare;
  const bool other_way = i.runs_on();
  i.suspect = -1;
  i.stretches_left = kMostStretches;
  i.looks_left = kMostLooks;
  i.look_along(i.obeyed);
  if (other_way) i.look_along(i.braked);
  if (command != nullptr) i.prove_mask();
  for (std::size_t k = 0; k < at(kMaxJoints); ++k) {
    const bool caused = ((i.mask >> k) & 1) != 0;
    i.keep[k] = caused ? kKeepTicks : std::max(0, i.keep[k] - 1);
    if (i.keep[k] > 0) i.mask |= std::int64_t{1} << k;
  }

  GuardReport& report = i.report;
  report.tick = state.tick;
  report.run_id = state.run_id;
  report.guard_id = i.config.guard_id;
  report.hold_mask = i.mask;
  report.compute_ns = 0;
  report.stop_asked = i.leg_hit;
  report.pairs_checked = static_cast<std::int16_t>(
      std::min<std::size_t>(static_cast<std::size_t>(i.collision.pair_count()),
                            std::numeric_limits<std::int16_t>::max()));
  i.fill_rows();
  const bool touching = i.pair_count > 0 && !(i.pairs[0].distance > 0.0);
  report.verdict = touching                ? GuardVerdict::kInCollision
                   : i.danger              ? GuardVerdict::kWillCollide
                   : report.pairs_near > 0 ? GuardVerdict::kNear
                                           : GuardVerdict::kClear;
  return report;
}

}  // namespace twinbus
