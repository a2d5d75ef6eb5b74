#include "robot/estimation/attitude_filter.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {
constexpr double kPull = 1.0;        // k_p [1/s]
constexpr double kBiasPull = 0.2;    // k_i [1/s^2]
constexpr double kSmooth = 0.02;     // low pass of both accelerations [s]
constexpr double kMostBias = 0.2;    // [rad/s]
constexpr double kMostPull = 20.0;   // k_p at the start of a robot that moves [1/s]
constexpr double kStart = 0.3;       // longest that a robot is taken to rest at first [s]
constexpr double kRestSpeed = 0.05;  // of the IMU, that is none [m/s]
constexpr double kStrange = 0.4;  // share of g by which an acceleration that counts differs from it
}  // namespace

void AttitudeFilter::update(const Eigen::Vector3d& gyro, const Eigen::Vector3d& accel,
                            const Eigen::Vector3d& velocity, bool trusted, double dt) noexcept {
  if (!started_) {
    started_ = true;
    age_ = dt;
    felt_ = accel;
    slow_.setZero();
    if (accel.norm() > 0.1 * kGravity) {
      rotation_ =
          Eigen::Quaterniond::FromTwoVectors(accel, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      rotation_ = rotation_z(-yaw_of(rotation_)) * rotation_;
    }
    rate_ = gyro;
    return;
  }
  age_ += dt;
  const double share = dt / (dt + kSmooth);
  felt_ = rotation_of(-dt * gyro) * felt_;  // the axes have turned under it
  felt_ += share * (accel - felt_);
  if (!trusted) slow_ = velocity;
  Eigen::Vector3d acceleration = (velocity - slow_) / (dt + kSmooth);
  slow_ += share * (velocity - slow_);
  // At first every look counts, and what legs say of a robot at rest is only their noise.
  const bool rests = age_ < kStart && slow_.norm() < kRestSpeed;
  if (rests) acceleration.setZero();
  const Eigen::Vector3d& felt = rests ? accel : felt_;

  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  if (trusted && std::abs(felt.norm() - kGravity) < kStrange * kGravity) {
    const Eigen::Vector3d expected =
        rotation_.transpose() * (acceleration + kGravity * Eigen::Vector3d::UnitZ());
    error = felt.cross(expected) / (kGravity * kGravity);
  }
  // Averages at first: a share 1 / age of each new look.
  const double pull = std::max(kPull, rests ? 1.0 / age_ : std::min(1.0 / age_, kMostPull));
  if (pull <= kPull)
    bias_ = (bias_ - dt * kBiasPull * error).cwiseMax(-kMostBias).cwiseMin(kMostBias);
  rate_ = gyro - bias_;
  const Eigen::Matrix3d turned = rotation_ * rotation_of(dt * (rate_ + pull * error));
  rotation_ = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
}

}  // namespace twinbus::robot
