#include "control/guard/guard.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <utility>

#include "control/guard/guard_parts.h"
#include "robot/collision/collision_pairs.h"
#include "robot/collision/thing_name.h"
#include "common/math/index.h"
#include "common/time/part_clock.h"

namespace twinbus::inline control {

namespace {

using Eigen::Vector3d;

// A joint that runs on this much farther than its set-point says is looked at as it is measured.
constexpr double kRunsOn = 0.01;     // [rad or m]
constexpr double kPastRange = 0.05;  // that a stop gives way [rad or m]
constexpr std::int64_t kHandoverTicks = 5;  // between the states of two sources, at most
constexpr double kHandoverStep = 0.1;       // of a joint between them, at most [rad or m]
constexpr int kKeepTicks = 5;     // a mask outlives its cause by this, against flicker
constexpr double kNever = 1e3;    // time to contact of a pair that parts [s]
constexpr double kRestsBy = 0.002;  // that what a hand holds sinks into what it stands on [m]

}  // namespace

Guard::Impl::Impl(const Model& robot, const GuardConfig& wanted)
    : model(&robot),
      config(wanted),
      collision(robot),
      margin_shares(robot),
      track(robot, wanted.delay_ticks, wanted.servo_lag),
      servos(robot, wanted.delay_ticks, wanted.servo_lag),
      own_kinematics(robot),
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
  find_reaches();
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
  if (command != nullptr) {
    if (const std::int64_t last = std::exchange(commanded_run_id, command->run_id); last != 0 && last != command->run_id) {
      track.change_source();
      servos.change_source();
    }
    track.follow(state, *command, report.hold_mask & ~servos.soft());
    servos.follow(state, *command, report.hold_mask, *now_kinematics, now, kept(), track.on_hold());
  }
  const int count = std::min({model->bus_count(), kMaxJoints, static_cast<int>(state.joint_count)});
  for (int k = 0; k < count; ++k) {
    const auto joint = at(model->bus_joints[at(k)]);
    braked[joint] = track.if_braked(at(k), static_cast<double>(state.qd[at(k)]));
    obeyed[joint] = command != nullptr ? track.if_obeyed(at(k)) : braked[joint];
    if (command != nullptr && servos.is_soft(at(k))) obeyed[joint] = braked[joint] = servos.if_obeyed(at(k));
  }
  keep_in_ranges(braked);
  keep_in_ranges(obeyed);
  spread_to_mimics(*model, braked);
  spread_to_mimics(*model, obeyed);
}

// A joint goes no farther than its stops.
void Guard::Impl::keep_in_ranges(Courses& courses) const noexcept {
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    const int j = model->bus_joints[at(k)];
    const Joint& joint = model->joints[at(j)];
    courses[at(j)].keep_between(joint.lower - kPastRange - now.q[j], joint.upper + kPastRange - now.q[j]);
  }
}

// What is held braked, the others obeyed: what will happen with this mask.  next: the one that is asked for next, if any is.
void Guard::Impl::predict_masked(std::int64_t held, std::int64_t next) noexcept {
  masked = obeyed;
  if (servos.soft() != 0) servos.look_masked(held, next);
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    Course& course = masked[at(model->bus_joints[at(k)])];
    if (servos.is_soft(at(k))) {
      course = servos.if_masked(at(k));
    } else if ((held & bit(k)) != 0) {
      course = track.if_held(at(k));
    }
  }
  keep_in_ranges(masked);
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
    most = longer(most, if_held(k));
  }
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[at(j)];
    if (joint.mimic >= 0) farthest[j] = std::abs(joint.mimic_multiplier) * farthest[joint.mimic];
  }
}

// How fast the pair comes together now, at one point: what moves both does not count [m/s].
double Guard::Impl::approach_speed(const PairDistance& pair) const noexcept {
  const auto velocity = [&](int link) {
    const int by = collision.carrier(link);
    return by >= 0 ? now_kinematics->point_velocity(by, pair.point_a) : Vector3d(Vector3d::Zero());
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
const GuardCause& Guard::cause() const noexcept { return impl_->cause; }

void describe(const Model& model, const std::vector<Obstacle>& obstacles, const GuardCause& cause,
              std::span<char> text) noexcept {
  if (cause.link_a < 0) {
    std::snprintf(text.data(), text.size(), "a way to rest took more looks than a tick has: all was braked");
    return;
  }
  int used = std::snprintf(text.data(), text.size(), "%s and %s, %.1f mm apart, would come to %.1f mm",
                           thing_name(model, obstacles, cause.link_a).data(),
                           thing_name(model, obstacles, cause.link_b).data(), 1e3 * cause.now, 1e3 * cause.then);
  if (cause.joint >= 0 && used > 0 && used < static_cast<int>(text.size())) {
    const Joint& joint = model.joints[at(cause.joint)];
    used += std::snprintf(text.data() + used, text.size() - at(used), " by %s at %.2f %s", joint.name.c_str(),
                          cause.speed, joint.kind == JointKind::kPrismatic ? "m/s" : "rad/s");
  }
  if (used > 0 && used < static_cast<int>(text.size()))
    std::snprintf(text.data() + used, text.size() - at(used), "; %.3g mm are kept", 1e3 * cause.margin);
}
const PairDistance* Guard::pairs() const noexcept { return impl_->pairs.data(); }
int Guard::pair_count() const noexcept { return impl_->pair_count; }
const GuardWork& Guard::work() const noexcept { return impl_->work; }
std::int64_t Guard::unproved() const noexcept { return impl_->unproved; }
void Guard::set_obstacles(const std::vector<Obstacle>& obstacles) {
  impl_->set_obstacles(obstacles);
}
const std::vector<Obstacle>& Guard::obstacles() const noexcept { return impl_->obstacles; }

// What a hand holds reaches farther than it.
void Guard::Impl::set_obstacles(const std::vector<Obstacle>& given) {
  obstacles = given;
  collision.set_obstacles(given);
  parting.fill({});
  find_reaches();
}

void Guard::Impl::find_reaches() noexcept {
  for (int joint = 0; joint < model->joint_count(); ++joint)
    reaches[joint] = collision.reach().farthest(joint);
}

void Guard::Impl::forget() noexcept {
  track.reset();
  servos.reset();
  keep.fill(0);
  report = GuardReport{};
  cause = GuardCause{};
}

// What a hand holds may stand on something when it is gripped and let go.
bool Guard::Impl::stands_on(const PairDistance& pair) const noexcept {
  const auto held = [&](int link) { return link >= model->link_count() && collision.carrier(link) >= 0; };
  const bool stands = collision.carrier(pair.link_a) < 0 || collision.carrier(pair.link_b) < 0;
  return stands && (held(pair.link_a) || held(pair.link_b)) && pair.distance > -kRestsBy;
}

// Of another source: whether it took over in mid-motion, from where the last one was, and with its set-points.
bool Guard::Impl::goes_on(const RobotState& state) const noexcept {
  const std::int64_t passed = state.tick - seen_tick;
  if (!(passed >= 1 && passed <= kHandoverTicks)) return false;
  for (std::size_t k = 0; k < at(std::min(model->bus_count(), kMaxJoints)); ++k) {
    if (!(std::abs(state.q[k] - seen_q[k]) < kHandoverStep)) return false;
  }
  return true;
}

void Guard::reset() noexcept { impl_->forget(); }

const GuardReport& Guard::check(const RobotState& state, const JointCommand* command,
                                const Configuration& base) noexcept {
  Impl& i = *impl_;
  i.now.base = base.base;
  set_joints(*i.model, state, i.now);
  i.own_kinematics.update(i.now);
  i.now_kinematics = &i.own_kinematics;
  return i.check(state, command);
}

const GuardReport& Guard::check(const RobotState& state, const JointCommand* command,
                                const Estimator& seen) noexcept {
  const PartScope part("guard");
  Impl& i = *impl_;
  i.now = seen.configuration();
  i.now_kinematics = &seen.kinematics();
  return i.check(state, command);
}

const GuardReport& Guard::Impl::check(const RobotState& state,
                                      const JointCommand* command) noexcept {
  if (state.run_id != run_id && !goes_on(state)) forget();  // another source: its set-points are not ours
  run_id = state.run_id;
  seen_tick = state.tick;
  seen_q = state.q;
  predict(state, command);
  bound_moves();
  ahead_of_now.q = now.q;
  ahead = collision.near_pairs(*now_kinematics, std::max(config.near, config.margin), pairs.data(), kMaxPairs,
                               ahead_of_now, pair_count);

  look_what_parts();

  mask = 0, leg_hit = danger = false;
  const GuardCause last = std::exchange(cause, GuardCause{});
  least_share = kShare;
  const bool other_way = runs_on();
  suspect = -1;
  stretches_left = kMostStretches;
  looks_left = kMostLooks;
  work = {};
  look_along(obeyed);
  if (other_way) look_along(braked);
  if (command != nullptr) prove_mask();
  work.looks = kMostLooks - looks_left;
  work.stretches = kMostStretches - stretches_left;
  const bool leads = danger || (command != nullptr && leads_nearer(*command));
  for (std::size_t k = 0; k < at(kMaxJoints); ++k) {
    // Soft servos are let go together, once none of them leads into anything: what is let go while others are held moves them.
    const bool stays = leads && keep[k] > 0 && servos.is_soft(k);
    const bool caused = ((mask >> k) & 1) != 0 || stays;
    keep[k] = caused ? kKeepTicks : std::max(0, keep[k] - 1);
    if (keep[k] > 0) mask |= std::int64_t{1} << k;
  }

  if (!cause.found) cause = last;  // the mask of an earlier tick is still held
  report.tick = state.tick;
  report.run_id = state.run_id;
  report.guard_id = config.guard_id;
  report.hold_mask = mask;
  report.compute_ns = 0;
  report.stop_asked = leg_hit;
  report.pairs_checked = static_cast<std::int16_t>(std::min<std::size_t>(
      static_cast<std::size_t>(collision.pair_count()), std::numeric_limits<std::int16_t>::max()));
  fill_rows();
  const bool touching = std::any_of(pairs.begin(), pairs.begin() + pair_count, [&](const PairDistance& pair) {
    return !(pair.distance > 0.0) && !stands_on(pair);
  });
  report.verdict = touching                ? GuardVerdict::kInCollision
                   : danger                ? GuardVerdict::kWillCollide
                   : report.pairs_near > 0 ? GuardVerdict::kNear
                                           : GuardVerdict::kClear;
  return report;
}

}  // namespace twinbus::control
