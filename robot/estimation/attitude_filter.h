// Attitude from gyro and accelerometer: a complementary filter on SO(3) that finds the gyro's bias.
//
//     R' = R [gyro - b + k_p e]x,   b' = -k_i e,   e = f x R^T (a + g z) / g^2
//
// Mahony, Hamel, Pflimlin: Nonlinear complementary filters on the special orthogonal group, IEEE Trans. Automatic
// Control 53 (5), 2008, section IV.  f is what the accelerometer feels; a, the acceleration of the IMU, comes from legs
// that stand: without it a walk of 0.5 m/s would be taken for a tilt of several degrees.  Heading drifts with the gyro.

#pragma once

#include <Eigen/Geometry>

namespace twinbus::inline robot {

class AttitudeFilter {
 public:
  void reset() noexcept { *this = AttitudeFilter(); }

  // One call per tick.  gyro [rad/s] and accel [m/s^2] in the IMU's axes; velocity of the IMU in the frame of rotation()
  // [m/s], as of this or the last tick; trusted: it is known, some foot stands.
  void update(const Eigen::Vector3d& gyro, const Eigen::Vector3d& accel,
              const Eigen::Vector3d& velocity, bool trusted, double dt) noexcept;

  // IMU's axes -> z up, heading 0 at the start.
  const Eigen::Matrix3d& rotation() const noexcept { return rotation_; }
  // Turning rate without the bias, IMU's axes [rad/s].
  const Eigen::Vector3d& rate() const noexcept { return rate_; }
  const Eigen::Vector3d& bias() const noexcept { return bias_; }  // [rad/s]

 private:
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero(), bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d felt_ = Eigen::Vector3d::Zero();  // accelerometer, low-passed [m/s^2]
  Eigen::Vector3d slow_ = Eigen::Vector3d::Zero();  // velocity, as much low-passed [m/s]
  double age_ = 0.0;                                // [s]
  bool started_ = false;
};

}  // namespace twinbus::robot
