// Servo, rotor inertia, friction and stops of the joints as rows of ODE's solve; the algebra is in
// ode_world.h.

#include <algorithm>
#include <cmath>

#include "sim/engine/ode_robot.h"
#include "sim/world/coulomb_friction.h"

namespace twinbus::inline sim {

namespace {

constexpr double kStopReach = 20.0;  // speed that a step may add [rad/s or m/s]
constexpr double kStopErp = 0.2;
constexpr int kPairPasses = 12;  // of a step, at most, for joints that share motors

struct Params {  // ODE numbers the parameters of axis 0, 1, 2 in groups of dParamGroup
  static int of(int parameter, int axis) { return parameter + axis * dParamGroup; }
};

void set_motor(const OdeJoint& joint, int parameter, int axis, double value) {
  if (joint.prismatic) {
    dJointSetLMotorParam(joint.motor, Params::of(parameter, axis), value);
  } else {
    dJointSetAMotorParam(joint.motor, Params::of(parameter, axis), value);
  }
}

// A row J qd+ + lambda / gain = force / gain, i.e. lambda = force - gain qd+; no row if gain is
// zero.
void set_row(const OdeJoint& joint, int axis, double gain, double force, double limit) {
  if (!(gain > 0.0)) {
    set_motor(joint, dParamFMax, axis, 0.0);
    return;
  }
  set_motor(joint, dParamCFM, axis, 1.0 / gain);
  set_motor(joint, dParamVel, axis, force / gain);
  set_motor(joint, dParamFMax, axis, limit);
}

}  // namespace

void OdeRobot::anchor_joint(int index) noexcept {
  const auto at = static_cast<std::size_t>(index);
  const Eigen::Vector3d axis = kinematics.axis_in_world(index);
  if (joints[at].prismatic) {
    dJointSetSliderAxis(joints[at].joint, axis.x(), axis.y(), axis.z());
    return;
  }
  const Eigen::Vector3d anchor =
      kinematics.link_in_world(model.joints[at].child).translation();
  dJointSetHingeAnchor(joints[at].joint, anchor.x(), anchor.y(), anchor.z());
  dJointSetHingeAxis(joints[at].joint, axis.x(), axis.y(), axis.z());
}

void OdeRobot::add_joint(int index, dWorldID world) {
  const auto at = static_cast<std::size_t>(index);
  const Joint& from = model.joints[at];
  OdeJoint& to = joints[at];
  to.prismatic = from.kind == JointKind::kPrismatic;
  to.limit = from.effort > 0.0 && std::isfinite(from.effort) ? from.effort : 0.0;
  if (pair_with(pairs, index) != nullptr) to.limit = dInfinity;  // the motors have limits
  to.rotor = from.rotor_inertia;
  to.damping = from.damping * config.friction_scale;
  to.friction = coulomb_friction(from, config);

  const Eigen::Vector3d axis = kinematics.axis_in_world(index);
  const dBodyID child = body(from.child);
  const dBodyID parent = body(from.parent);
  to.joint = to.prismatic ? dJointCreateSlider(world, nullptr) : dJointCreateHinge(world, nullptr);
  dJointAttach(to.joint, child, parent);
  anchor_joint(index);
  if (to.prismatic) {
    to.motor = dJointCreateLMotor(world, nullptr);
    dJointAttach(to.motor, child, parent);
    dJointSetLMotorNumAxes(to.motor, 2);
    for (int i = 0; i < 2; ++i) dJointSetLMotorAxis(to.motor, i, 1, axis.x(), axis.y(), axis.z());
  } else {
    to.motor = dJointCreateAMotor(world, nullptr);
    dJointAttach(to.motor, child, parent);
    dJointSetAMotorMode(to.motor, dAMotorUser);
    dJointSetAMotorNumAxes(to.motor, 3);
    for (int i = 0; i < 3; ++i) dJointSetAMotorAxis(to.motor, i, 1, axis.x(), axis.y(), axis.z());
  }
  if (from.kind != JointKind::kContinuous) {
    to.lower = from.lower;
    to.upper = from.upper;
  }
}

// The stop is a row of its own, J qd+ <= (upper - q) / h with a force that only pushes back, there
// whenever the joint could reach the stop within the step: it is not passed, whatever pushes. ODE's
// row has the target -stop_erp / h (angle - stop), so a distance still to go is a negative stop_erp
// and a stop that is mirrored by q.
void OdeRobot::prepare_stop(const OdeJoint& joint, double q, double qd) noexcept {
  const double h = config.step;
  const double reach = h * (std::abs(qd) + kStopReach);
  double low = -dInfinity, high = dInfinity, erp = kStopErp;
  if (q - joint.lower < reach && q - joint.lower <= joint.upper - q) {
    low = q < joint.lower ? joint.lower : 2.0 * q - joint.lower;
    if (q >= joint.lower) erp = -1.0;
  } else if (joint.upper - q < reach) {
    high = q > joint.upper ? joint.upper : 2.0 * q - joint.upper;
    if (q <= joint.upper) erp = -1.0;
  }
  if (joint.prismatic) {
    dJointSetSliderParam(joint.joint, dParamLoStop, low - joint.middle);
    dJointSetSliderParam(joint.joint, dParamHiStop, high - joint.middle);
    dJointSetSliderParam(joint.joint, dParamStopERP, erp);
  } else {
    dJointSetAMotorAngle(joint.motor, 2, q);
    set_motor(joint, dParamLoStop, 2, low);
    set_motor(joint, dParamHiStop, 2, high);
    set_motor(joint, dParamStopERP, 2, erp);
  }
}

void OdeRobot::prepare_rows() noexcept {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    prepare_joint(joints[j], start_of_step.q[index], start_of_step.qd[index]);
  }
}

void OdeRobot::prepare_joint(OdeJoint& joint, double q, double qd) noexcept {
  const ServoTarget& t = joint.target;
  const double h = config.step;
  const double servo_gain = joint.taken ? 0.0 : h * t.kp + t.kd;
  // Coulomb friction as damping of the magnitude it has at the present speed: below kStickSpeed it
  // creeps.
  const double friction_gain = joint.friction / std::max(std::abs(qd), kStickSpeed);
  const double passive_gain = joint.rotor / h + joint.damping + friction_gain;
  const double passive_force = joint.rotor / h * qd;
  double servo_force = joint.taken ? joint.given : t.kp * (t.q - q - joint.play) + t.kd * t.qd + t.tau;

  prepare_stop(joint, q, qd);
  if (!(servo_gain > 0.0)) {  // a torque that does not depend on the motion
    servo_force = std::clamp(servo_force, -joint.limit, joint.limit);
    if (passive_gain > 0.0) {
      set_row(joint, 0, passive_gain, passive_force + servo_force, dInfinity);
    } else {
      set_row(joint, 0, 0.0, 0.0, 0.0);
      if (joint.prismatic) {
        dJointAddSliderForce(joint.joint, servo_force);
      } else {
        dJointAddHingeTorque(joint.joint, servo_force);
      }
    }
    set_row(joint, 1, 0.0, 0.0, 0.0);
  } else if (joint.bounded) {
    set_row(joint, 0, servo_gain, servo_force, joint.limit);
    set_row(joint, 1, passive_gain, passive_force, dInfinity);
  } else {
    set_row(joint, 0, servo_gain + passive_gain, servo_force + passive_force, dInfinity);
    set_row(joint, 1, 0.0, 0.0, 0.0);
  }
}

// The law itself at the end of the step: equal to the row's lambda, which solves it.
bool OdeRobot::read_torques() noexcept {
  const double h = config.step;
  bool beyond = false;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    OdeJoint& joint = joints[i];
    const ServoTarget& t = joint.target;
    const auto index = static_cast<Eigen::Index>(i);
    const double q = start_of_step.q[index];
    const double qd = configuration.qd[index];  // at the end
    const double asked = t.kp * (t.q - q - joint.play - h * qd) + t.kd * (t.qd - qd) + t.tau;
    const bool too_much = !(std::abs(asked) <= joint.limit);
    if (too_much && !joint.bounded && h * t.kp + t.kd > 0.0) {
      joint.bounded = true;
      beyond = true;
    }
    joint.tau = std::clamp(asked, -joint.limit, joint.limit);
  }
  return limit_pairs() || beyond;
}

bool OdeRobot::limit_pairs() noexcept {
  bool again = false;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    RodPosture posture;
    if (!pairs[p].drive.at(pairs[p].of(start_of_step.q), posture)) continue;  // beyond its stops: the servo as it is
    Eigen::Vector2d force, gain, applied;
    const Eigen::Vector2d qd = pairs[p].of(configuration.qd);  // at the end
    for (int i = 0; i < 2; ++i) {
      OdeJoint& joint = joints[static_cast<std::size_t>(pairs[p].joints[static_cast<std::size_t>(i)])];
      gain[i] = config.step * joint.target.kp + joint.target.kd;
      force[i] = joint.tau + gain[i] * qd[i];
      if (joint.taken) joint.tau = joint.given;
      applied[i] = joint.tau;
    }
    if (pair_passes_ == 0) solves_[p].begin(posture.jacobian, pairs[p].drive.torque_limits(), force, gain);
    if (pair_passes_ == kPairPasses || solves_[p].settled(applied, qd)) continue;
    const Eigen::Vector2d given = solves_[p].next(applied, qd);
    for (int i = 0; i < 2; ++i) {
      OdeJoint& joint = joints[static_cast<std::size_t>(pairs[p].joints[static_cast<std::size_t>(i)])];
      joint.taken = true;
      joint.given = given[i];
    }
    again = true;
  }
  pair_passes_ += again ? 1 : 0;
  return again;
}

double OdeRobot::flank(const OdeJoint& joint) const noexcept {
  return 0.5 * config.backlash * std::clamp(joint.tau / kPlayTorque, -1.0, 1.0);
}

void OdeRobot::set_servo(int joint, const ServoTarget& target) noexcept {
  if (joints[static_cast<std::size_t>(joint)].passive) return;
  ServoTarget& own = joints[static_cast<std::size_t>(joint)].target;
  own = target;
  own.kp *= config.servo_kp_scale;
  own.kd *= config.servo_kd_scale;
}

void OdeRobot::set_tau(int index, double tau) noexcept {
  OdeJoint& joint = joints[static_cast<std::size_t>(index)];
  joint.bounded = false;
  joint.tau = std::isfinite(tau) ? std::clamp(tau, -joint.limit, joint.limit) : 0.0;
  joint.play = flank(joint);
}

void OdeRobot::update_play() noexcept {
  for (OdeJoint& joint : joints) {
    // A bounded row costs time: a joint that is well inside its limit again gets the cheap one.
    if (joint.bounded && std::abs(joint.tau) < 0.9 * joint.limit) joint.bounded = false;
    joint.play += kPlayRate * (flank(joint) - joint.play);
    joint.taken = false;
  }
  pair_passes_ = 0;
}

}  // namespace twinbus::sim
