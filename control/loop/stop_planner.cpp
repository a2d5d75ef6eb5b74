#include "control/loop/stop_planner.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr double kEvery = 0.030;         // a plan is begun [s]
constexpr double kEveryResting = 0.040;  // of a robot that stands still [s]
constexpr double kSpacing = 0.040;  // from knot to knot [s]
constexpr double kStep = 0.010;     // of the walk that is run ahead [s]
constexpr double kGoesOn = 0.050;   // before it stops [s]
constexpr int kWalkKnots = 39;      // 1.52 s: stands after at most 0.9 s, and then shares its weight
constexpr int kArmKnots = 11;       // 0.4 s
constexpr int kRestKnots = kPlanKnotsPerPiece;  // 0.16 s
constexpr double kDown = 0.16;   // in which feet in the air come down [s]
constexpr double kRateFilter = 0.03;  // of joints that follow what is measured [s]
constexpr int kKnotsPerTick = 3;
constexpr int kRounds = 2;        // of the inverse kinematics per knot
constexpr int kLastJoints = 10;   // ticks before a resumed walk goes on, from which its joints count

std::int64_t ticks_of(double seconds, double period) { return std::max<std::int64_t>(1, std::llround(seconds / period)); }

const Foothold& place_of(const WalkPattern& pattern, int foot) noexcept {
  return pattern.swings(foot) ? pattern.swing().place() : pattern.foot(foot);
}
}  // namespace

StopPlanner::StopPlanner(const Model& model, const Walk* walk, std::int32_t first_number)
    : model_(model),
      torque_(model),
      every_(ticks_of(kEvery, model.period())),
      every_resting_(ticks_of(kEveryResting, model.period())),
      spacing_(ticks_of(kSpacing, model.period())),
      step_(std::min(spacing_, ticks_of(kStep, model.period()))),
      going_on_(ticks_of(kGoesOn, model.period())),
      number_(first_number),
      arm_(model),
      down_q_(Eigen::VectorXd::Zero(model.joint_count())),
      down_torque_(down_q_),
      q_given_(Eigen::VectorXd::Zero(model.joint_count())),
      qdd_(q_given_),
      tau_(q_given_),
      configuration_(model),
      kinematics_(model),
      dynamics_(model),
      wrench_(2) {
  for (Begun& begun : begun_) {
    begun.q_given = q_given_;
    begun.plan.head.number = -1;
  }
  for (Knot& k : knot_) k.q = q_given_;
  for (std::size_t f = 0; f < 2; ++f) wrench_[f].link = model.soles[f].link;
  age_ = every_resting_;
  if (walk == nullptr) return;
  for (Begun& begun : begun_) begun.walk = *walk;
  ahead_ = *walk;
  resumed_ = *walk;
}

std::size_t StopPlanner::find(std::int32_t number) const noexcept {
  std::size_t i = 0;
  while (i < kKept && begun_[i].plan.head.number != number) ++i;
  return i;
}

const StopPlan* StopPlanner::plan(std::int32_t number) const noexcept {
  const std::size_t i = find(number);
  return i < kKept ? &begun_[i].plan : nullptr;
}

void StopPlanner::begin(const PlannedMotion& motion) noexcept {
  now_ = (now_ + 1) % kKept;
  Begun& begun = begun_[now_];
  begun.walks = motion.walk != nullptr && ahead_.has_value();
  if (begun.walks) ahead_ = begun.walk = *motion.walk;
  begun.q_given = q_given_ = motion.q_given;
  command_ = motion.command;
  follow_ = motion.follow;
  down_ = motion.down != nullptr && motion.down_torque != nullptr;
  if (down_) {
    down_q_ = *motion.down;
    down_torque_ = *motion.down_torque;
  }
  arm_.start(motion.posture, motion.arm);
  for (int j = 0; j < model_.bus_count(); ++j) started_[at(j)] = motion.posture.q(j);
  StopPlanHead& head = begun.plan.head;
  head.run_id = command_.run_id;
  head.model_hash = command_.model_hash;
  head.controller_id = command_.controller_id;
  head.tick = command_.tick;
  head.joints = motion.joints;
  head.term = command_.term;
  head.number = ++number_;
  head.knot_count = static_cast<std::int16_t>(begun.walks ? kWalkKnots : motion.rests ? kRestKnots : kArmKnots);
  head.pieces = static_cast<std::int16_t>((head.knot_count + kPlanKnotsPerPiece - 1) / kPlanKnotsPerPiece);
  head.spacing = static_cast<std::int16_t>(spacing_);
  head.joint_count = command_.joint_count;
  head.walks = begun.walks;
  making_ = true;
  halted_ = false;
  knots_ = done_ = sent_ = 0;
  age_ = 0;
  if (!begun.walks) return;
  const Walk& walk = *ahead_;
  const Foothold& left = place_of(walk.pattern(), 0);
  origin_ = left.position;
  heading_ = left.yaw();
  cosine_ = std::cos(heading_);
  sine_ = std::sin(heading_);
  head.omega = static_cast<float>(walk.omega());
  head.mass = static_cast<float>(walk.carried_mass());
  const Gait& gait = walk.gait();
  for (std::size_t d = 0; d < 2; ++d) {
    head.sole_low[d] = static_cast<float>(gait.sole_low[static_cast<Eigen::Index>(d)]);
    head.sole_high[d] = static_cast<float>(gait.sole_high[static_cast<Eigen::Index>(d)]);
  }
  head.sole_zmp = {static_cast<float>(gait.zmp_forward), static_cast<float>(gait.zmp_inward)};
}

// What the torques of knot k need of the walk as it is now.
void StopPlanner::keep(int k) noexcept {
  const Walk& walk = *ahead_;
  Knot& n = knot(k);
  n.q = walk.posture().q;
  n.base = walk.posture().base;
  n.velocity = walk.reference_velocity();
  n.acceleration = walk.reference_acceleration();
  for (std::size_t f = 0; f < 2; ++f) {
    n.force[f] = walk.wrenches()[f].force;
    n.torque[f] = walk.wrenches()[f].torque;
  }
}

bool StopPlanner::write_joints(int k) noexcept {
  StopPlan& plan = begun_[now_].plan;
  const Begun& begun = begun_[now_];
  bool fits = true;
  for (int j = 0; j < model_.bus_count(); ++j) {
    const int joint = model_.bus_joints[at(j)];
    const bool leg = begun.walks && ahead_->is_leg(joint);
    double q = command_.q[at(j)] + arm_.posture().q(j) - started_[at(j)];
    if (leg) q = knot(k).q[joint];
    double tau = static_cast<double>(command_.tau[at(j)]);
    if ((follow_ & bit(j)) != 0) {
      q = command_.q[at(j)] + rate_[at(j)] * arm_.gone();
      if (down_ && k > 0) {
        const double done = std::min(1.0, static_cast<double>((k - 1) * spacing_) * model_.period() / kDown);
        const double share = done * done * (3.0 - 2.0 * done);
        q += share * (down_q_[joint] - q);
        tau += share * (down_torque_[joint] - tau);
      }
    }
    fits = to_plan(q, kPlanPosition, plan.q[at(k)][at(j)]) && fits;
    fits = to_plan(tau, kPlanTorque, plan.tau[at(k)][at(j)]) && fits;
    if (!leg) q_given_[joint] = arm_.posture().q(j);
  }
  return fits;
}

bool StopPlanner::write_balance(int k) noexcept {
  const Walk& walk = *ahead_;
  const WalkPattern& pattern = walk.pattern();
  StopPlan& plan = begun_[now_].plan;
  PlanBalanceRow& row = plan.balance[at(k)];
  bool fits = true;
  const auto put = [&](int column, double value) { fits = to_plan(value, kPlanBalance, row[at(column)]) && fits; };
  const auto put_point = [&](int column, const Eigen::Vector2d& point) {
    const Eigen::Vector2d p = point - origin_;
    put(column, cosine_ * p.x() + sine_ * p.y());
    put(column + 1, cosine_ * p.y() - sine_ * p.x());
  };
  put_point(kPlanDcm, walk.dcm());
  put_point(kPlanCom, walk.stabilizer().com());
  put_point(kPlanZmp, walk.stabilizer().share().zmp);
  const Eigen::Vector3d attitude = rotation_vector(rotation_z(-heading_) * walk.posture().base.linear());
  for (int d = 0; d < 3; ++d) put(kPlanAttitude + d, attitude[d]);
  put(kPlanLeft, walk.stabilizer().share().left);
  for (int f = 0; f < 2; ++f) {
    const Foothold& place = place_of(pattern, f);
    put_point(kPlanSoles + 3 * f, place.position);
    put(kPlanSoles + 3 * f + 2, wrap_angle(place.yaw() - heading_));
  }
  plan.phase[at(k)] = static_cast<std::int8_t>((pattern.single() ? kPlanSingle : 0) |
                                               (pattern.single() && pattern.support() == 1 ? kPlanOnRight : 0));
  return fits;
}

// Rates and accelerations are differences to the knots before and after.
bool StopPlanner::write_torque(int k) noexcept {
  StopPlan& plan = begun_[now_].plan;
  const int last = plan.head.knot_count - 1;
  const Knot &n = knot(k), &a = knot(std::max(k - 1, 0)), &b = knot(std::min(k + 1, last));
  const double h = static_cast<double>(spacing_) * model_.period();
  configuration_.base = n.base;
  configuration_.q = n.q;
  configuration_.qd = (b.q - a.q) / (k == 0 || k == last ? h : 2.0 * h);
  configuration_.base_velocity = n.velocity;
  configuration_.base_angular_velocity.setZero();
  kinematics_.update(configuration_);
  if (k == 0 || k == last) {
    qdd_.setZero();
  } else {
    qdd_ = (b.q - 2.0 * n.q + a.q) / (h * h);
  }
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_.soles[f];
    wrench_[f].point = (kinematics_.link_in_world(sole.link) * sole.frame).translation();
    wrench_[f].force = n.force[f];
    wrench_[f].torque = n.torque[f];
  }
  (void)dynamics_.solve(kinematics_, configuration_, qdd_, n.acceleration, Eigen::Vector3d::Zero(), wrench_, tau_);
  bool fits = true;
  PerJoint<double> q{}, tau{};
  for (int j = 0; j < model_.bus_count(); ++j) {
    const int joint = model_.bus_joints[at(j)];
    const double most = model_.joints[at(joint)].effort;
    q[at(j)] = configuration_.q[joint];
    tau[at(j)] = std::clamp(tau_[joint], -most, most);
  }
  torque_.limit(q, tau);
  for (int j = 0; k > 0 && j < model_.bus_count(); ++j)  // knot 0 has the torques of the command
    fits = to_plan(tau[at(j)], kPlanTorque, plan.tau[at(k)][at(j)]) && fits;
  return fits;
}

bool StopPlanner::make_knot() noexcept {
  Begun& begun = begun_[now_];
  const int k = knots_;
  for (std::int64_t i = 0; k > 0 && i < spacing_; i += step_) {
    const std::int64_t tick = (k - 1) * spacing_ + i;
    const double dt = static_cast<double>(std::min(step_, spacing_ - i)) * model_.period();
    const bool stops = tick >= going_on_;
    if (!arm_.advance(stops, dt)) return false;
    if (!begun.walks) continue;
    if (stops && !halted_) {
      ahead_->halt();
      halted_ = true;
    }
    ahead_->foresee(dt);
  }
  if (begun.walks) {
    if (k > 0) ahead_->foresee_joints(q_given_, kRounds);
    keep(k);
    if (!write_balance(k)) return false;
  }
  if (!write_joints(k)) return false;
  ++knots_;
  if (!begun.walks) {
    done_ = knots_;
    return true;
  }
  if (knots_ > 1) {
    if (!write_torque(knots_ - 2)) return false;
    done_ = knots_ - 1;
  }
  if (knots_ == begun.plan.head.knot_count) {
    if (!write_torque(knots_ - 1)) return false;
    done_ = knots_;
  }
  return true;
}

void StopPlanner::advance(const PlannedMotion& motion) noexcept {
  ++age_;
  const double share = model_.period() / (model_.period() + kRateFilter);
  for (int j = 0; j < model_.bus_count(); ++j)
    rate_[at(j)] += share * (static_cast<double>(motion.command.qd[at(j)]) - rate_[at(j)]);
  if (!motion.steered) {
    making_ = false;
    return;
  }
  if (!making_ && age_ >= (motion.rests ? every_resting_ : every_)) begin(motion);
  if (!making_) return;
  const int count = begun_[now_].plan.head.knot_count;
  for (int i = 0; i < kKnotsPerTick && making_ && knots_ < count; ++i) making_ = make_knot();
}

bool StopPlanner::take(StopPlanPiece& out) noexcept {
  if (!making_) return false;
  const StopPlan& plan = begun_[now_].plan;
  const int needed = std::min<int>((sent_ + 1) * kPlanKnotsPerPiece, plan.head.knot_count);
  if (done_ < needed) return false;
  plan.copy_to(sent_, out);
  if (++sent_ == plan.head.pieces) making_ = false;
  return true;
}

const Walk* StopPlanner::walk_at(std::int32_t number, std::int64_t tick) noexcept {
  const std::size_t i = find(number);
  if (i == kKept || !begun_[i].walks || begun_[i].plan.head.tick > tick) return nullptr;
  const Begun& begun = begun_[i];
  if (resumed_number_ != number || resumed_tick_ > tick) {
    resumed_ = begun.walk;
    resumed_number_ = number;
    resumed_tick_ = begun.plan.head.tick;
  }
  for (; resumed_tick_ < tick; ++resumed_tick_) {
    if (resumed_tick_ - begun.plan.head.tick == going_on_) resumed_->halt();
    resumed_->foresee(model_.period());
    if (tick - resumed_tick_ <= kLastJoints) resumed_->foresee_joints(begun.q_given, kRounds);
  }
  return &*resumed_;
}

}  // namespace twinbus::control
