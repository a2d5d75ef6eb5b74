#include "robot/attitude_filter.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics.h"
#include "robot/pose_math.h"

namespace twinbus {

namespace {
constexpr double kPull = 0.6;       // k_p [1/s]
constexpr double kBiasPull = 0.06;  // k_i [1/s^2]
constexpr double kSmooth = 0.02;    // low pass of both accelerations [s]
constexpr double kMostBias = 0.2;   // [rad/s]
constexpr double kMostPull = 20.0;  // k_p at the start, where it averages [1/s]
constexpr double kStrange = 0.4;  // share of g by which an acceleration that counts differs from it
}  // namespace

void AttitudeFilter::update(const Eigen::Vector3d& gyro, const Eigen::Vector3d& accel,
                            const Eigen::Vector3d& velocity, bool trusted, double dt) noexcept {
  if (!started_) {
    started_ = true;
    felt_ = accel;
    slow_ = velocity;
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
  felt_ += share * (accel - felt_);
  if (!trusted) slow_ = velocity;
  const Eigen::Vector3d acceleration = (velocity - slow_) / (dt + kSmooth);
  slow_ += share * (velocity - slow_);

  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  if (trusted && std::abs(felt_.norm() - kGravity) < kStrange * kGravity) {
    const Eigen::Vector3d expected =
        rotation_.transpose() * (acceleration + kGravity * Eigen::Vector3d::UnitZ());
    error = felt_.cross(expected) / (kGravity * kGravity);
  }
  // Averages at first: a share 1 / age of each new look.
  const double pull = std::clamp(1.0 / age_, kPull, kMostPull);
  bias_ = (bias_ - dt * kBiasPull * error).cwiseMax(-kMostBias).cwiseMin(kMostBias);
  rate_ = gyro - bias_;
  const Eigen::Matrix3d turned = rotation_ * rotation_of(dt * (rate_ + pull * error));
  rotation_ = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
}

}  // namespace twinbus
