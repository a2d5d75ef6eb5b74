#include "robot/stop_plan/plan_follower.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline robot {

namespace {
constexpr double kRamp = 0.05;     // in which the law comes in [s]
constexpr double kDcm = 6.0;       // k [1/s]
constexpr double kIntegral = 0.5;  // k_i [1/s]
constexpr double kLeak = 3.0;      // of the integral [s]
constexpr double kFilter = 0.015;  // of what a sole gives way, twice: once makes a kick [s]
constexpr double kAnkle = 50.0;      // admittance to the moment that is missed [1/s]
constexpr double kAnkleLeak = 0.5;   // in which it becomes the slope of the ground [s]
constexpr double kFlat = 20.0;       // in which that slope is forgotten [s]
constexpr double kMostTurn = 0.2;    // [rad]
constexpr double kForce = 90.0;      // admittance to the difference of the feet's forces [1/s]
constexpr double kForceLeak = 0.3;   // [s]
constexpr double kMostLift = 0.04;   // [m]
constexpr double kLoaded = 0.05;     // of the weight: a sole admits
constexpr double kWanted = 0.02;     // share of the load from which on it has something to admit
constexpr double kFriction = 0.8;    // of the sole's, that a horizontal force may use
constexpr double kMostMove = 0.3;    // of a leg joint [rad]
constexpr double kDamping = 1e-3;    // of the 6 x 6 solve

double filtered(double from, double to, double share) noexcept { return from + share * (to - from); }
}  // namespace

PlanFollower::PlanFollower(const Model& model) : model_(&model), weight_(kGravity * model.total_mass()) {
  const std::array<LegChain, 2> chain{leg_chain(model, 0), leg_chain(model, 1)};
  for (const LegChain& leg : chain) {
    const bool driven = std::all_of(leg.begin(), leg.end(), [&](int joint) { return model.bus_index[at(joint)] >= 0; });
    if (!model.floating_base || !leg.balances() || !driven) return;
  }
  legs_ = {LegMotion(model, 0), LegMotion(model, 1)};
  for (int f = 0; f < 2; ++f) {
    Foot& foot = feet_[at(f)];
    for (int j = 0; j < chain[at(f)].count; ++j) foot.bus_joint[at(j)] = model.bus_index[at(chain[at(f)].joint[at(j)])];
    const Sole& sole = model.soles[at(f)];
    const double half_width = 0.5 * (sole.left + sole.right), half_length = 0.5 * (sole.front + sole.back);
    foot.stiffness = std::max(1e3, sole.stiffness);
    foot.turning = foot.stiffness * Eigen::Vector2d(half_width * half_width, half_length * half_length);
    foot.centre << 0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right);
  }
}

void PlanFollower::start(const StopPlan& plan, std::int64_t tick, const Estimator& robot) noexcept {
  for (Foot& foot : feet_) {
    foot.bend_slow.setZero();
    foot.bend.setZero();
    foot.admitted.setZero();
    foot.slope.setZero();
    foot.force.setZero();
    foot.moment.setZero();
    foot.sink_slow = foot.sink = 0.0;
    foot.moved = {};
  }
  since_ = lift_ = error_ = 0.0;
  integral_.setZero();
  if (!plan.head.walks || !legs_) return;
  const PlanBalance p = balance_at(plan, tick);
  const int stands = p.single ? p.support : p.left >= 0.5 ? 0 : 1;
  const double turn = yaw_of(robot.sole_in_world(stands).linear()) - p.sole[at(stands)].yaw;
  cosine_ = std::cos(turn);
  sine_ = std::sin(turn);
}

// com: how far the centre of mass is from the plan, relative to the soles that carry.
Eigen::Vector2d PlanFollower::error(const StopPlan& plan, const PlanBalance& p, const Estimator& robot,
                                    Eigen::Vector2d& com) noexcept {
  const double omega = static_cast<double>(plan.head.omega);
  const SolePlace frame{.cosine = cosine_, .sine = sine_};
  const std::array<double, 2> part{p.left, 1.0 - p.left};
  Eigen::Vector2d planned = Eigen::Vector2d::Zero(), measured = planned;
  for (std::size_t f = 0; f < 2; ++f) {
    planned += part[f] * p.sole[f].position;
    measured += part[f] * robot.sole_in_world(static_cast<int>(f)).translation().head<2>();
  }
  const Eigen::Vector2d com_now = robot.kinematics().com().head<2>() - measured;
  com = frame.unturn(com_now) - (p.com - planned);
  const bool forces = robot.sole_force(0).z() != 0.0 || robot.sole_force(1).z() != 0.0;
  if (forces) return frame.unturn(Eigen::Vector2d(com_now + robot.dcm_velocity() / omega)) - (p.dcm - planned);
  const Configuration& c = robot.configuration();
  const Eigen::Matrix3d attitude = rotation_z(std::atan2(sine_, cosine_)) * rotation_of(p.attitude);
  const Eigen::Vector3d tilt = rotation_vector(c.base.linear() * attitude.transpose());
  const Eigen::Vector3d lean = kGravity / (omega * omega) * (tilt + c.base_angular_velocity / omega);
  return frame.unturn(Eigen::Vector2d(lean.y(), -lean.x()));
}

// A foot's own part: gives way under what is asked of it beyond the plan, and admits what it misses.
void PlanFollower::admit(std::size_t f, const PlanBalance& p, const Load& wanted, double share, const SolePlace& sole,
                         const Estimator& robot, double ramp) noexcept {
  Foot& foot = feet_[f];
  const double dt = model_->period();
  const Eigen::Vector2d leak = dt / kAnkleLeak * foot.admitted;
  Eigen::Vector2d turned = -leak;
  const int number = static_cast<int>(f);
  if (robot.sole_force(number).z() > kLoaded * weight_ && share > kWanted) {
    const double yaw = yaw_of(robot.sole_in_world(number).linear());
    const SolePlace axes{.cosine = std::cos(yaw), .sine = std::sin(yaw)};
    const Eigen::Vector2d got = axes.unturn(Eigen::Vector2d(robot.sole_torque(number).head<2>()));
    turned += ramp * dt * kAnkle * (got - wanted.moment).cwiseQuotient(foot.turning);
  }
  foot.admitted = (foot.admitted + turned).cwiseMax(-kMostTurn).cwiseMin(kMostTurn);
  if (p.single && number != p.support) return;
  foot.slope *= std::max(0.0, 1.0 - dt / kFlat);
  foot.slope += sole.turn(leak);
}

// The leg's joints for how the sole is to move, and its torques for the force beyond the plan.
void PlanFollower::move_leg(std::size_t f, const SolePlace& sole, const Estimator& robot, PlanJoints& set_points) noexcept {
  using Vector6 = LegMotion::Vector6;
  LegMotion& leg = (*legs_)[f];
  Foot& foot = feet_[f];
  const double dt = model_->period();
  const SolePlace frame{.cosine = cosine_, .sine = sine_};
  const Eigen::Vector2d turn = frame.turn(Eigen::Vector2d(foot.slope + sole.turn(Eigen::Vector2d(foot.bend + foot.admitted))));
  const Eigen::Vector2d push = frame.turn(Eigen::Vector2d(foot.force.head<2>()));
  const Eigen::Vector2d moment = frame.turn(sole.turn(foot.moment));
  Vector6 move, wrench;
  move << 0.0, 0.0, (f == 0 ? 0.5 : -0.5) * lift_ - foot.sink, turn, 0.0;
  wrench << push, foot.force.z(), moment, 0.0;

  leg.update(robot.kinematics(), robot.sole_in_world(static_cast<int>(f)));
  move.tail<3>() = leg.held(move.tail<3>());
  const Vector6 x = leg.damped(move, kDamping);
  const LegMotion::Vector7 tau = leg.torques(wrench);
  for (int j = 0; j < leg.chain().count; ++j) {
    const std::size_t b = at(foot.bus_joint[at(j)]);
    const double q = leg.rate(at(j), x);
    const double moved = std::isfinite(q) ? std::clamp(q, -kMostMove, kMostMove) : 0.0;
    set_points.q[b] += moved;
    set_points.qd[b] += (moved - foot.moved[at(j)]) / dt;
    if (std::isfinite(tau[j])) set_points.tau[b] += tau[j];
    foot.moved[at(j)] = moved;
  }
}

void PlanFollower::balance(const StopPlan& plan, std::int64_t tick, const Estimator& robot, PlanJoints& set_points) noexcept {
  if (!plan.head.walks || !legs_) return;
  const double dt = model_->period(), omega = static_cast<double>(plan.head.omega);
  const PlanBalance p = balance_at(plan, tick);
  since_ += dt;
  const double ramp = std::min(1.0, since_ / kRamp);
  Eigen::Vector2d com_error;
  const Eigen::Vector2d e = ramp * error(plan, p, robot, com_error);
  if (!e.allFinite()) return;
  error_ = e.norm();
  integral_ += dt * (e - integral_ / kLeak);

  std::array<SolePlace, 2> soles;
  std::array<Eigen::Vector2d, 2> on;
  for (std::size_t f = 0; f < 2; ++f) {
    soles[f] = {p.sole[f].position, std::cos(p.sole[f].yaw), std::sin(p.sole[f].yaw)};
    const auto forward = static_cast<double>(plan.head.sole_zmp[0]), inward = static_cast<double>(plan.head.sole_zmp[1]);
    on[f] = soles[f].position + soles[f].turn({forward, f == 0 ? -inward : inward});
  }
  const SoleArea area{Eigen::Vector2d(plan.head.sole_low[0], plan.head.sole_low[1]),
                      Eigen::Vector2d(plan.head.sole_high[0], plan.head.sole_high[1])};
  const int carries = p.single ? p.support : -1;
  const SoleShare planned = share_on_soles(soles, on, area, carries, p.zmp);
  const Eigen::Vector2d wanted_zmp = p.zmp + (1.0 + kDcm / omega) * e + kIntegral * integral_;
  const SoleShare wanted = share_on_soles(soles, on, area, carries, wanted_zmp);

  const double mass = static_cast<double>(plan.head.mass), weight = mass * kGravity;
  const auto load = [&](const SoleShare& share, std::size_t f, const Eigen::Vector2d& com) {
    const double part = f == 0 ? share.left : 1.0 - share.left;
    Eigen::Vector2d push = part * mass * omega * omega * (com - share.zmp);
    const double most = kFriction * std::max(0.1, model_->soles[f].friction) * part * weight;
    if (push.norm() > most) push *= most / push.norm();
    Load out;
    out.force << push, part * weight;
    const Eigen::Vector2d arm = soles[f].turn(share.cop[f]);
    const Eigen::Vector3d torque = Eigen::Vector3d(arm.x(), arm.y(), 0.0).cross(out.force);
    out.moment = soles[f].unturn(Eigen::Vector2d(torque.head<2>()));
    return out;
  };
  const std::array<Load, 2> now{load(wanted, 0, p.com + com_error), load(wanted, 1, p.com + com_error)};

  double rate = -lift_ / kForceLeak;
  if (!p.single && (robot.sole_force(0).z() != 0.0 || robot.sole_force(1).z() != 0.0)) {
    const double missed =
        (now[0].force.z() - now[1].force.z()) - (robot.sole_force(0).z() - robot.sole_force(1).z());
    rate -= ramp * kForce / feet_[0].stiffness * missed;
  }
  lift_ = std::clamp(lift_ + dt * rate, -kMostLift, kMostLift);

  const double share = dt / (dt + kFilter);
  for (std::size_t f = 0; f < 2; ++f) {
    Foot& foot = feet_[f];
    const Load before = load(planned, f, p.com);
    const Eigen::Vector3d force = now[f].force - before.force;
    const Eigen::Vector2d moment = now[f].moment - before.moment;
    // Four springs at the corners; a load off the centre turns the sole about it.
    const Eigen::Vector2d about = moment - force.z() * Eigen::Vector2d(foot.centre.y(), -foot.centre.x());
    const Eigen::Vector2d bend = -about.cwiseQuotient(foot.turning);
    const double sink = force.z() / foot.stiffness - bend.y() * foot.centre.x() + bend.x() * foot.centre.y();
    foot.bend_slow += share * (bend - foot.bend_slow);
    foot.bend += share * (foot.bend_slow - foot.bend);
    foot.sink_slow = filtered(foot.sink_slow, sink, share);
    foot.sink = filtered(foot.sink, foot.sink_slow, share);
    foot.force += 2.0 * share * ramp * (force - foot.force);
    foot.moment += 2.0 * share * ramp * (moment - foot.moment);
    admit(f, p, now[f], f == 0 ? wanted.left : 1.0 - wanted.left, soles[f], robot, ramp);
    move_leg(f, soles[f], robot, set_points);
  }
}

}  // namespace twinbus::robot
