#include "robot/estimation/inertial_leg_odometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/base_frame.h"

namespace twinbus::inline robot {

namespace {

constexpr double kPullTime = 0.1;                       // T on one foot [s]
constexpr double kFootNoise = 0.08 * 0.08 * 0.02;   // r: 0.08 m/s that changes every 20 ms [m^2/s]
constexpr double kAccelNoise = kFootNoise / (kPullTime * kPullTime);  // q [m^2/s^3]
constexpr double kUnknownAccel = 9.0 * 0.05;        // q without accelerometer: 3 m/s^2 for 50 ms
constexpr double kHuber = 2.5;                      // standard deviations
constexpr double kChange = 0.02;                    // T_c [s]
constexpr double kRestless = 1.5;                   // c_0 [m/s^2]
constexpr double kAgrees = 0.1, kMoves = 0.25;      // a foot at rest; one that is not [m/s]
constexpr double kFirst = 1.0;                      // deviation at the beginning [m/s]
constexpr double kNewSource = 0.05;                 // of another robot that goes on [m/s]
constexpr double kGap_s = 0.1;                      // states that are missing for longer: as at the beginning
constexpr double kFollows = 1.5;                    // periods after the last, a state is not the next one
constexpr double kInTheAir = 0.1;                   // without a foot for so long the accelerometer is alone [s]
constexpr double kTilt = 0.01;                      // deviation of roll and pitch [rad]
constexpr double kYawRate = 1e-6;                   // growth of the variance of the heading [rad^2/s]
constexpr double kGyro = 0.02;                      // deviation of the turning rate [rad/s]
constexpr double kHeight = 0.005;                   // of the base above standing feet [m]

}  // namespace

InertialLegOdometry::InertialLegOdometry(const Model& model)
    : model_(&model), feet_(model), configuration_(model), kinematics_(model) {
  std::vector<bool> needed(model.joints.size(), false);
  for (const int joint : feet_.joints()) needed[at(joint)] = true;
  for (int link = model.imu_link; link > 0; link = model.links[at(link)].parent) needed[at(link - 1)] = true;
  for (int j = 0; j < model.joint_count(); ++j) {
    if (needed[at(j)]) joints_.push_back(j);
  }
  reset();
}

void InertialLegOdometry::reset() noexcept {
  feet_.reset();
  estimate_ = Estimate{};
  position_.setZero();
  velocity_.setZero();
  variance_.setConstant(kFirst * kFirst);
  position_variance_.setZero();
  yaw_variance_ = yaw_offset_ = unsupported_ = 0.0;
  seen_.fill(Seen());
  time_ns_ = 0;
  started_ = resumed_ = imu_valid_ = stood_ = lifted_ = false;
}

void InertialLegOdometry::resume(const Estimate& last) noexcept {
  reset();
  estimate_ = last;
  position_ << last.base_position[0], last.base_position[1], last.base_position[2];
  base_ = quaternion_from_array(last.base_attitude).toRotationMatrix();
  velocity_ = vector_from_array(last.base_velocity);
  for (int i = 0; i < 3; ++i) {
    const auto place = static_cast<double>(last.position_deviation[at(i)]);
    const auto speed = static_cast<double>(last.velocity_deviation[at(i)]);
    position_variance_[i] = place * place;
    variance_[i] = std::min(speed * speed + kNewSource * kNewSource, kFirst * kFirst);
  }
  const double yaw = static_cast<double>(last.attitude_deviation[2]);
  yaw_variance_ = yaw * yaw;
  started_ = resumed_ = stood_ = true;
}

void InertialLegOdometry::update(const RobotState& state) noexcept {
  const bool other = started_ && state.run_id != estimate_.run_id;
  if (started_ && !resumed_ && !other && state.tick <= estimate_.tick && estimate_.tick - state.tick < 1000) return;
  const double since = 1e-9 * static_cast<double>(state.time_ns - time_ns_);
  const bool missing = started_ && !resumed_ && !(since > 0.0 && since < kGap_s);
  const double dt = started_ && !resumed_ && !missing ? since : model_->period();
  time_ns_ = state.time_ns;
  estimate_.tick = state.tick;
  estimate_.run_id = state.run_id;

  const double yaw_before = yaw_of(base_);
  const Eigen::Vector3d origin_before = base_ * (omega_.cross(imu_place_) + imu_drift_);
  const bool had_imu = imu_valid_;
  look(state);
  if (!started_ || resumed_ || other || !had_imu) {
    const double heading = started_ ? yaw_before : 0.0;
    yaw_offset_ = wrap_angle(heading - yaw_of(imu_ * imu_in_base_.transpose()));
  }
  base_.noalias() = rotation_z(yaw_offset_) * imu_ * imu_in_base_.transpose();
  if (resumed_) velocity_ += base_ * (omega_.cross(imu_place_) + imu_drift_);  // it was that of the base's origin
  else if (other) velocity_ += base_ * (omega_.cross(imu_place_) + imu_drift_) - origin_before;
  if (missing) variance_.setConstant(kFirst * kFirst);
  if (other) variance_.array() += kNewSource * kNewSource;
  if (model_->floating_base) {
    if (started_ && !missing) predict(imu_valid_, dt);
    const Eigen::Vector3d felt = imu_valid_ ? Eigen::Vector3d(imu_in_base_ * felt_)
                                            : Eigen::Vector3d(kGravity * base_.row(2).transpose());
    feet_.update(state, kinematics_, base_, felt, started_ && !resumed_ ? dt : 1.0);  // the first reading is believed
    look_at_feet(dt, imu_valid_ && had_imu && started_ && !missing && !resumed_ && !other && dt < kFollows * model_->period());
    correct(dt);
    move(started_ && !missing ? dt : 0.0);
  }
  started_ = true;
  resumed_ = false;
  report();
}

void InertialLegOdometry::look(const RobotState& state) noexcept {
  set_in_base_frame(*model_, state, configuration_);
  kinematics_.update(configuration_, joints_);
  imu_valid_ = (state.sensor_flags & kImuValid) != 0;
  const Eigen::Isometry3d frame = kinematics_.link_in_world(model_->imu_link) * model_->imu;
  imu_in_base_ = frame.linear();
  imu_place_ = frame.translation();
  imu_drift_ = kinematics_.point_velocity(model_->imu_link, imu_place_);
  if (!imu_valid_) return;
  imu_ = quaternion_from_array(state.attitude).toRotationMatrix();
  omega_ = imu_in_base_ * vector_from_array(state.gyro) - kinematics_.angular_velocity(model_->imu_link);
  felt_ = vector_from_array(state.accel);
}

void InertialLegOdometry::predict(bool imu, double dt) noexcept {
  if (imu) {
    velocity_ += dt * (base_ * (imu_in_base_ * felt_) - kGravity * Eigen::Vector3d::UnitZ());
    variance_.array() += dt * kAccelNoise;
  } else {
    variance_.array() += dt * kUnknownAccel;
  }
  variance_ = variance_.cwiseMin(kFirst * kFirst);
}

// What each foot says how fast the IMU's origin is, if it is at rest where the ground presses it, and how that changes.
// follows: this state is the next one after the last, so that the accelerometer tells what happened between them.
void InertialLegOdometry::look_at_feet(double dt, bool follows) noexcept {
  const Eigen::Vector3d felt = base_ * (imu_in_base_ * felt_) - kGravity * Eigen::Vector3d::UnitZ();
  const double share = dt / (dt + kChange);
  for (int foot = 0; foot < feet_.count(); ++foot) {
    Seen& seen = seen_[at(foot)];
    const Eigen::Vector3d before = seen.velocity;
    const Eigen::Vector3d& point = feet_.point(foot);
    const Eigen::Vector3d by_joints = imu_drift_ - kinematics_.point_velocity(feet_.link(foot), point);
    seen.velocity = base_ * (omega_.cross(imu_place_ - point) + by_joints);
    const Eigen::Vector3d change = follows ? Eigen::Vector3d((seen.velocity - before) / dt - felt) : Eigen::Vector3d::Zero();
    seen.rough += share * (change - seen.rough);
    seen.change += share * (seen.rough - seen.change);
  }
}

void InertialLegOdometry::correct(double dt) noexcept {
  bool any = false, agreed = false;
  for (int foot = 0; foot < feet_.count(); ++foot)
    agreed = agreed || (feet_.stands(foot) && (seen_[at(foot)].velocity - velocity_).norm() < kAgrees);
  const auto restless_of = [&](int foot) { return 1.0 + seen_[at(foot)].change.squaredNorm() / (kRestless * kRestless); };
  // Of two feet the one that lands stands alone: nothing else tells how fast the base rises.
  const bool alone = feet_.count() <= 2;
  double calmest = std::numeric_limits<double>::infinity();
  for (int foot = 0; foot < feet_.count(); ++foot) {
    if (feet_.certainty(foot) > 0.0) calmest = std::min(calmest, restless_of(foot));
  }
  for (int foot = 0; foot < feet_.count(); ++foot) {
    const double sure = feet_.certainty(foot);
    if (!(sure > 0.0)) continue;
    any = any || feet_.stands(foot);
    const Eigen::Vector3d& seen = seen_[at(foot)].velocity;
    const double restless = restless_of(foot);
    // Torques swing a heavy leg too: while another foot agrees with what was known, one that moves is in the air.
    if (agreed && (seen - velocity_).norm() > kMoves) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double off = seen[axis] - velocity_[axis];
      double noise = (alone && axis == 2 ? restless / calmest : restless) * kFootNoise / (sure * dt);
      const double usual = kHuber * kHuber * (variance_[axis] + kFootNoise / 0.02);
      if (off * off > usual) noise *= std::sqrt(off * off / usual);
      const double gain = variance_[axis] / (variance_[axis] + noise);
      velocity_[axis] += gain * off;
      variance_[axis] *= 1.0 - gain;
    }
  }
  unsupported_ = any ? 0.0 : unsupported_ + dt;
  stood_ = stood_ || any;
}

void InertialLegOdometry::move(double dt) noexcept {
  const Eigen::Vector3d velocity = velocity_ - base_ * (omega_.cross(imu_place_) + imu_drift_);
  position_ += dt * velocity;
  position_variance_ += 2.0 * kPullTime * dt * variance_;
  yaw_variance_ += kYawRate * dt;
  double sum = 0.0, height = 0.0;
  for (int foot = 0; foot < feet_.count(); ++foot) {
    sum += feet_.certainty(foot);
    height -= feet_.certainty(foot) * base_.row(2).dot(feet_.point(foot));
  }
  if (!(sum > 0.0)) {
    if (!lifted_ && !stood_) {  // begins in the air: its lowest foot touches
      for (int foot = 0; foot < feet_.count(); ++foot) {
        position_.z() = std::max(position_.z(), -base_.row(2).dot(feet_.point(foot)));
      }
      lifted_ = true;
    }
    return;
  }
  const double share = dt > 0.0 ? std::min(1.0, sum) * dt / (dt + kPullTime) : 1.0;
  position_.z() += share * (height / sum - position_.z());
  position_variance_.z() += share * (kHeight * kHeight - position_variance_.z());
}

void InertialLegOdometry::report() noexcept {
  Estimate& e = estimate_;
  const Eigen::Vector3d turning = omega_.cross(imu_place_) + imu_drift_;
  const bool fixed = !model_->floating_base;
  Eigen::Vector3d velocity = velocity_ - base_ * turning;
  if (fixed) {
    velocity.setZero();
    base_.setIdentity();
    omega_.setZero();
  }
  e.base_position = {position_.x(), position_.y(), position_.z()};
  e.base_attitude = array_from_rotation<double>(base_);
  e.base_velocity = array_from_vector<float>(velocity);
  e.base_angular_velocity = array_from_vector<float>(base_ * omega_);
  e.velocity_in_base = array_from_vector<float>(base_.transpose() * velocity);
  e.angular_velocity_in_base = array_from_vector<float>(omega_);
  const Eigen::Vector3d of_imu = base_.transpose() * velocity + (fixed ? imu_drift_ : turning);
  e.imu_velocity = array_from_vector<float>(imu_in_base_.transpose() * of_imu);
  const double known = fixed ? 0.0 : 1.0;
  e.position_deviation = array_from_vector<float>(known * position_variance_.cwiseSqrt());
  e.velocity_deviation = array_from_vector<float>(known * variance_.cwiseSqrt());
  const double heading = std::sqrt(kTilt * kTilt + yaw_variance_);
  e.attitude_deviation = array_from_vector<float>(known * Eigen::Vector3d(kTilt, kTilt, heading));
  e.angular_velocity_deviation = array_from_vector<float>(known * kGyro * Eigen::Vector3d::Ones());
  e.foot_count = static_cast<std::int16_t>(feet_.count());
  for (int foot = 0; foot < feet_.count(); ++foot) {
    e.foot_load[at(foot)] = static_cast<float>(feet_.load(foot));
    e.foot_certainty[at(foot)] = static_cast<float>(std::clamp(feet_.certainty(foot), 0.0, 1.0));
    e.foot_position[at(foot)] = array_from_vector<float>(position_ + base_ * feet_.point(foot));
    e.foot_joint[at(foot)] = static_cast<std::int16_t>(feet_.bus_joint(foot));
    e.foot_stands[at(foot)] = feet_.stands(foot);
  }
  e.load_from = feet_.load_from();
  e.velocity_from = fixed                                        ? VelocityFrom::kFixed
                    : !stood_                                    ? VelocityFrom::kUnknown
                    : unsupported_ < kInTheAir && imu_valid_     ? VelocityFrom::kFeetAndAccelerometer
                    : imu_valid_                                 ? VelocityFrom::kAccelerometer
                    : unsupported_ < kInTheAir                   ? VelocityFrom::kFeet
                                                                 : VelocityFrom::kUnknown;
}

}  // namespace twinbus::robot
