#include "robot/parallel/drive_torque.h"

namespace twinbus::inline robot {

namespace {

constexpr double kAlike = 0.05;  // weight of the difference of the gains, of that of the joints' stiffness

// Gains of the motors whose gains of the joints are nearest to those wanted.
Eigen::Vector2d gains_of_motors(const Eigen::Matrix2d& jacobian, const Eigen::Vector2d& wanted) noexcept {
  // Row j: what a unit of each motor gives joint j.  Each row over what is wanted there, so that joints of different gains count alike.
  Eigen::Matrix2d gives = jacobian.cwiseAbs2().transpose();
  Eigen::Vector2d want = Eigen::Vector2d::Ones();
  for (int j = 0; j < 2; ++j) {
    if (wanted[j] > 0.0) gives.row(j) /= wanted[j];
    else want[j] = 0.0;
  }
  if (!(wanted.maxCoeff() > 0.0)) return Eigen::Vector2d::Zero();
  // A joint that is to be free counts as little as the largest does much.
  for (int j = 0; j < 2; ++j) {
    if (!(wanted[j] > 0.0)) gives.row(j) /= wanted.maxCoeff();
  }
  // Motors alike in lever make it singular, or nearly: gains that differ little are wanted too.
  const Eigen::Matrix2d normal = gives.transpose() * gives;
  const double alike = kAlike * normal.trace();
  Eigen::Matrix2d all = normal;
  all.diagonal().array() += alike;
  all(0, 1) -= alike;
  all(1, 0) -= alike;
  Eigen::Vector2d gains = all.inverse() * (gives.transpose() * want);
  for (int i = 0; i < 2; ++i) {
    if (gains[i] >= 0.0) continue;  // then the other alone
    const int other = 1 - i;
    gains[i] = 0.0;
    gains[other] = std::max(0.0, (gives.transpose() * want)[other] / normal(other, other));
  }
  return gains;
}

}  // namespace

bool servo_of_motors(const RodDrive& drive, const PairServo& joints, const Eigen::Vector2d& q_now, const RodPosture& posture,
                     PairServo& motors) noexcept {
  RodPosture target;
  if (!drive.at(joints.q, target)) return false;
  motors.q = target.motors;
  motors.qd = target.jacobian * joints.qd;
  motors.kp = gains_of_motors(posture.jacobian, joints.kp);
  motors.kd = gains_of_motors(posture.jacobian, joints.kd);
  const Eigen::Vector2d wanted = joints.kp.cwiseProduct(joints.q - q_now) + joints.tau;
  motors.tau = posture.jacobian.transpose().inverse() * wanted - motors.kp.cwiseProduct(motors.q - posture.motors);
  if (!motors.tau.allFinite()) return false;
  const Eigen::Vector2d most = drive.torque_limits();
  motors.tau = motors.tau.cwiseMax(-most).cwiseMin(most);
  return true;
}

bool servo_of_joints(const RodDrive& drive, const PairServo& motors, const Eigen::Vector2d& q_now, const Eigen::Vector2d& qd_now,
                     const RodPosture& posture, PairServo& joints) noexcept {
  RodPosture target;
  joints.q = q_now;
  if (!drive.joints(motors.q, joints.q, target)) return false;
  joints.qd = target.jacobian.inverse() * motors.qd;
  const Eigen::Matrix2d squared = posture.jacobian.cwiseAbs2().transpose();
  joints.kp = squared * motors.kp;
  joints.kd = squared * motors.kd;
  const Eigen::Vector2d given = motors.kp.cwiseProduct(motors.q - posture.motors) +
                                motors.kd.cwiseProduct(motors.qd - posture.jacobian * qd_now) + motors.tau;
  joints.tau = posture.jacobian.transpose() * given - joints.kp.cwiseProduct(joints.q - q_now) -
               joints.kd.cwiseProduct(joints.qd - qd_now);
  return joints.tau.allFinite();
}

}  // namespace twinbus::robot
