#include "sim/motors/motor_limits.h"

#include "common/math/index.h"
#include "robot/description/model.h"

namespace twinbus::inline sim {

MotorLimits::MotorLimits(const Model& model, std::vector<JointLaw>& joints) {
  for (const ParallelJoints& pair : parallel_joints_of(model)) {
    pairs_.emplace_back().of = pair;
    for (const int j : pair.joints) joints[at(j)].limit_elsewhere();
  }
}

void MotorLimits::begin(const std::vector<JointLaw>& joints, const Eigen::VectorXd& q) noexcept {
  for (Pair& pair : pairs_) {
    RodPosture posture;
    if (pair.of.drive.at(pair.of.of(q), posture)) pair.jacobian = posture.jacobian;  // else as it was: stops hold it inside
    Eigen::Vector2d force, gain;
    for (int i = 0; i < 2; ++i) {
      const JointRow line = joints[at(pair.of.joints[at(i)])].servo_line();
      force[i] = line.force;
      gain[i] = line.gain;
    }
    pair.solve.begin(pair.jacobian, pair.of.drive.torque_limits(), force, gain);
  }
}

Eigen::Vector2d MotorLimits::applied(const std::vector<JointLaw>& joints, const Pair& pair, const Eigen::Vector2d& qd) noexcept {
  const JointRow first = joints[at(pair.of.joints[0])].servo_line(), second = joints[at(pair.of.joints[1])].servo_line();
  return {first.force - first.gain * qd[0], second.force - second.gain * qd[1]};
}

void MotorLimits::approach(std::vector<JointLaw>& joints, Pair& pair, const Eigen::Vector2d& qd) noexcept {
  const Eigen::Vector2d now = applied(joints, pair, qd);
  if (pair.solve.settled(now, qd)) return;
  const Eigen::Vector2d tau = pair.solve.next(now, qd);
  for (int i = 0; i < 2; ++i) joints[at(pair.of.joints[at(i)])].take_servo_line({.force = tau[i], .gain = 0.0});
}

std::uint64_t MotorLimits::pattern(std::uint64_t pattern) const noexcept {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].solve.limited()) pattern = mix(mix(pattern, -1), static_cast<int>(i));
  }
  return pattern;
}

}  // namespace twinbus::sim
