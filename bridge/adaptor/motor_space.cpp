#include "bridge/adaptor/motor_space.h"

#include "robot/parallel/drive_torque.h"

namespace twinbus::inline bridge {

namespace {

template <class Array>
Eigen::Vector2d take(const Array& from, const std::array<std::size_t, 2>& at) noexcept {
  return {static_cast<double>(from[at[0]]), static_cast<double>(from[at[1]])};
}

template <class Number>
void put(const Eigen::Vector2d& values, const std::array<std::size_t, 2>& at, PerJoint<Number>& to) noexcept {
  for (int i = 0; i < 2; ++i) to[at[static_cast<std::size_t>(i)]] = static_cast<Number>(values[i]);
}

PairServo servo_from(const JointCommand& command, const std::array<std::size_t, 2>& at) noexcept {
  return {.q = take(command.q, at), .qd = take(command.qd, at), .tau = take(command.tau, at), .kp = take(command.kp, at),
          .kd = take(command.kd, at)};
}

void put(const PairServo& servo, const std::array<std::size_t, 2>& at, JointCommand& command) noexcept {
  put(servo.q, at, command.q);
  put(servo.qd, at, command.qd);
  put(servo.tau, at, command.tau);
  put(servo.kp, at, command.kp);
  put(servo.kd, at, command.kd);
}

}  // namespace

MotorSpace::MotorSpace(const Model& model) {
  for (const ParallelJoints& of : parallel_joints_of(model)) {
    if (!of.driver_of_motors) continue;
    Pair& pair = pairs_.emplace_back();
    pair.of = of;
    for (std::size_t i = 0; i < 2; ++i)
      pair.bus[i] = static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(of.joints[i])]);
    pair.q = middle_of(of.box);
    (void)of.drive.at(pair.q, pair.posture);
    if (where_.empty()) where_ = of.where;
  }
}

bool MotorSpace::to_joints(RobotState& state) noexcept {
  for (Pair& pair : pairs_) {
    if (!pair.of.drive.joints(take(state.q, pair.bus), pair.q, pair.posture)) return false;
  }
  for (Pair& pair : pairs_) {
    pair.qd = pair.posture.jacobian.inverse() * take(state.qd, pair.bus);
    put(pair.q, pair.bus, state.q);
    put(pair.qd, pair.bus, state.qd);
    put(pair.posture.jacobian.transpose() * take(state.tau, pair.bus), pair.bus, state.tau);
  }
  return true;
}

bool MotorSpace::to_motors(RobotState& state) noexcept {
  for (Pair& pair : pairs_) {
    RodPosture posture;
    const Eigen::Vector2d q = take(state.q, pair.bus);
    if (!pair.of.drive.at(q, posture)) return false;
    pair.q = q;
    pair.qd = take(state.qd, pair.bus);
    pair.posture = posture;
    put(posture.motors, pair.bus, state.q);
    put(posture.jacobian * pair.qd, pair.bus, state.qd);
    put(posture.jacobian.transpose().inverse() * take(state.tau, pair.bus), pair.bus, state.tau);
  }
  return true;
}

bool MotorSpace::to_motors(JointCommand& command) const noexcept {
  PairServo motors;
  for (const Pair& pair : pairs_) {
    if (!servo_of_motors(pair.of.drive, servo_from(command, pair.bus), pair.q, pair.posture, motors)) return false;
    put(motors, pair.bus, command);
  }
  return true;
}

bool MotorSpace::to_joints(JointCommand& command) const noexcept {
  PairServo joints;
  for (const Pair& pair : pairs_) {
    if (!servo_of_joints(pair.of.drive, servo_from(command, pair.bus), pair.q, pair.qd, pair.posture, joints)) return false;
    put(joints, pair.bus, command);
  }
  return true;
}

}  // namespace twinbus::bridge
