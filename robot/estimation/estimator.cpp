#include "robot/estimation/estimator.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "robot/estimation/base_frame.h"
#include "robot/estimation/point_legs.h"
#include "robot/estimation/sole_contact.h"
#include "robot/estimation/standing_feet.h"

namespace twinbus::inline robot {

namespace {

// A foot counts as loaded above kLoadedOn of the robot's weight, as lifted below kLoadedOff.  One reading below
// kLoadedSurely may be noise, by which a foot in the air would land: it takes two.  A foot's
// share in the averages grows from nothing at kLoadedOff to full at kFullShare, so that touching
// and lifting make no step.
constexpr double kLoadedOn = 0.05;
constexpr double kLoadedSurely = 0.1;
constexpr double kLoadedOff = 0.03;
constexpr double kFullShare = 0.15;
constexpr double kLeastHeight = 0.2;  // of the centre of mass that is reckoned with [m]
constexpr double kDcmFilter = 0.020;  // of the velocity of the joints against what the ZMP says [s]
constexpr double kAttitudeFilter = 0.05;  // of the IMU's attitude against what its gyro says [s]
constexpr double kGyroBias = 2.0;         // in which the gyro's own error is found [s]
constexpr double kOtherAttitude = 0.1;    // farther off it is another attitude: it is taken [rad]

}  // namespace

Estimator::Estimator(const Model& model)
    : model_(&model),
      weight_force_(kGravity * model.total_mass()),
      configuration_(model),
      kinematics_(model) {
  std::vector<bool> needed(model.joints.size(), false);
  for (int link : {model.soles[0].link, model.soles[1].link, model.imu_link}) {
    for (; link > 0; link = model.links[at(link)].parent) needed[at(link) - 1] = true;
  }
  for (std::size_t j = 0; j < needed.size(); ++j) {
    if (needed[j]) seen_joints_.push_back(static_cast<int>(j));
  }
  if (stands_on_points(model)) odometry_.emplace(model);
  reset();
}

void Estimator::reset() noexcept {
  started_ = resumed_ = false;
  if (odometry_) odometry_->reset();
  attitude_.reset();
  imu_velocity_.setZero();
  loaded_ = {};
  anchored_ = {};
  yaw_offset_ = 0.0;
  upright_base_.setIdentity();
  position_.setZero();
  dcm_velocity_.setZero();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    force_[foot].setZero();
    torque_[foot].setZero();
    sole_[foot].setIdentity();
    anchor_[foot].setZero();
  }
  ground_.setIdentity();
  zmp_.setZero();
  support_.clear();
}

void Estimator::resume(const std::array<bool, 2>& stands, const std::array<Eigen::Vector2d, 2>& place,
                       const std::array<double, 2>& yaw) noexcept {
  loaded_ = anchored_ = stands;
  anchor_ = place;
  anchor_yaw_ = yaw;
  resumed_ = true;
}

void Estimator::update(const RobotState& state, bool again) noexcept {
  if (odometry_) return follow_points(state, again);
  const bool start = !started_;
  const bool switched = started_ && state.run_id != run_id_;
  run_id_ = state.run_id;
  started_ = true;
  const double since = 1e-9 * static_cast<double>(state.time_ns - time_ns_);
  const double period = model_->period();
  dt_ = again ? 0.0 : since > 0.0 && since < 10.0 * period ? since : period;
  time_ns_ = state.time_ns;
  look_at_imu(state, start || switched || resumed_);
  look(state);
  if (start) {  // the first reading is believed
    for (Eigen::Vector3d& force : force_) force.z() = weight_force_;
  }
  measure_load(state);
  place_base(start, switched);
  move_base();
  finish();
  follow_dcm();
}

// The attitude is a filter of ours; or the heading is what the IMU reads, and what is up, u, goes on by the gyro, which is
// quiet from tick to tick, and is pulled to what the IMU reads, too, without the gyro's bias b:
//     u' = u x (gyro - b) + e / T,    b' = u x e / (T T_b),    e = u of the IMU - u
void Estimator::look_at_imu(const RobotState& state, bool anew) noexcept {
  if ((state.sensor_flags & kImuValid) == 0) return;
  const Eigen::Vector3d gyro = vector_from_array(state.gyro);
  if (own_attitude_) {
    if (dt_ > 0.0) {
      attitude_.update(gyro, vector_from_array(state.accel), imu_velocity_,
                       loaded_[0] || loaded_[1], dt_);
    }
    imu_ = attitude_.rotation();
    return;
  }
  const Eigen::Vector3d up_before =
      rotation_of(-dt_ * (gyro - gyro_bias_)) * imu_.row(2).transpose();
  imu_ = quaternion_from_array(state.attitude).toRotationMatrix();
  const Eigen::Vector3d up = imu_.row(2).transpose();
  const Eigen::Vector3d off = up - up_before;
  if (anew || !(off.norm() < kOtherAttitude)) {
    gyro_bias_.setZero();
    return;
  }
  gyro_bias_ += dt_ / (kAttitudeFilter * kGyroBias) * up_before.cross(off);
  const Eigen::Vector3d believed = up_before + dt_ / (dt_ + kAttitudeFilter) * off;
  imu_ *= Eigen::Quaterniond::FromTwoVectors(believed, up).toRotationMatrix();
}

// Everything relative to the base's origin, in a frame with z up and the heading the IMU believes
// in.
void Estimator::look(const RobotState& state) noexcept {
  set_in_base_frame(*model_, state, configuration_);
  kinematics_.update(configuration_, seen_joints_);

  // attitude = base * link of the IMU * IMU.  The IMU measures its own rates: those of the joints
  // before it come off.
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  // of the base, base axes
  if ((state.sensor_flags & kImuValid) != 0) {
    const Eigen::Matrix3d imu_in_base =
        kinematics_.link_in_world(model_->imu_link).linear() * model_->imu.linear();
    const Eigen::Vector3d rate = own_attitude_ ? attitude_.rate() : vector_from_array(state.gyro);
    upright_base_.noalias() = imu_ * imu_in_base.transpose();
    omega = imu_in_base * rate - kinematics_.angular_velocity(model_->imu_link);
  }
  configuration_.base_angular_velocity = upright_base_ * omega;

  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Sole& sole = model_->soles[foot];
    if (sole.link < 0) continue;
    Seen& seen = seen_[foot];
    const Eigen::Isometry3d sole_in_base = kinematics_.link_in_world(sole.link) * sole.frame;
    const Eigen::Vector3d centre =
        sole_in_base *
        Eigen::Vector3d(0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right), 0.0);
    seen.rotation.noalias() = upright_base_ * sole_in_base.linear();
    seen.position = upright_base_ * sole_in_base.translation();
    seen.centre = upright_base_ * centre;
    seen.centre_velocity = upright_base_ * kinematics_.point_velocity(sole.link, centre) +
                           configuration_.base_angular_velocity.cross(seen.centre);
    seen.yaw = yaw_of(seen.rotation);
    seen.spin = (upright_base_ * (omega + kinematics_.angular_velocity(sole.link))).z();
    seen.sensor_rotation.noalias() =
        upright_base_ * kinematics_.link_in_world(sole.link).linear() * sole.sensor.linear();
    seen.sensor_arm =
        upright_base_ * (kinematics_.link_in_world(sole.link) * sole.sensor.translation() -
                         sole_in_base.translation());
  }
}

// Foot forces in the same frame, which feet are loaded and how much each counts.
void Estimator::measure_load(const RobotState& state) noexcept {
  bool measured = false;
  for (int foot = 0; foot < 2; ++foot) {
    const Sole& sole = model_->soles[at(foot)];
    Seen& seen = seen_[at(foot)];
    seen.weight = 0.0;
    torque_[at(foot)].setZero();
    const bool was_loaded = std::exchange(loaded_[at(foot)], false);
    const double share_before = force_[at(foot)].z() / weight_force_;
    force_[at(foot)].setZero();
    if (sole.link < 0) continue;
    const auto limb = static_cast<Limb>(foot);
    if (state.wrench_kind[at(foot)] != WrenchKind::kAbsent &&
        (state.sensor_flags & wrench_valid(limb)) != 0) {
      measured = true;
      const auto& w = state.wrench[at(foot)];
      const Eigen::Vector3d force =
          seen.sensor_rotation * vector_from_array<float>({w[0], w[1], w[2]});
      force_[at(foot)] = force;
      torque_[at(foot)] = seen.sensor_rotation * vector_from_array<float>({w[3], w[4], w[5]}) +
                          seen.sensor_arm.cross(force);
      const double share = force.z() / weight_force_;
      const bool lands = share > kLoadedSurely || std::min(share, share_before) > kLoadedOn;
      loaded_[at(foot)] = was_loaded ? share > kLoadedOff : lands;
      if (loaded_[at(foot)]) {
        seen.weight = std::clamp((share - kLoadedOff) / (kFullShare - kLoadedOff), 0.0, 1.0);
      }
    }
    seen.height = sole_height(sole, seen.rotation, force_[at(foot)].z());
  }
  if (measured) return;

  // No force sensor: the lower sole carries the robot, both if they are level.
  double lowest = std::numeric_limits<double>::infinity();
  for (int foot = 0; foot < 2; ++foot) {
    if (model_->soles[at(foot)].link >= 0) lowest = std::min(lowest, seen_[at(foot)].position.z());
  }
  for (int foot = 0; foot < 2; ++foot) {
    loaded_[at(foot)] =
        model_->soles[at(foot)].link >= 0 && seen_[at(foot)].position.z() < lowest + kSameHeight;
    seen_[at(foot)].weight = loaded_[at(foot)] ? 1.0 : 0.0;
  }
  const double each = weight_force_ / std::max(1, int{loaded_[0]} + int{loaded_[1]});
  for (int foot = 0; foot < 2; ++foot) {
    if (loaded_[at(foot)]) {
      seen_[at(foot)].height = sole_height(model_->soles[at(foot)], seen_[at(foot)].rotation, each);
    }
  }
}

// Heading, x and y so that loaded soles stay where they are anchored; z so that they are pressed in
// as their force says.
void Estimator::place_base(bool start, bool switched) noexcept {
  if (start || switched) {
    // The frame midway between the soles is put where it was (at the origin at the start), then
    // soles are anchored anew.
    anchored_ = {};
    double yaw = yaw_of(upright_base_);
    Eigen::Vector3d midway = Eigen::Vector3d::Zero();
    if (model_->soles[0].link >= 0 && model_->soles[1].link >= 0) {
      yaw = seen_[0].yaw + 0.5 * wrap_angle(seen_[1].yaw - seen_[0].yaw);
      midway = 0.5 * (seen_[0].position + seen_[1].position);
    }
    yaw_offset_ = yaw_of(ground_.linear()) - yaw;
    position_.head<2>() = (ground_.translation() - rotation_z(yaw_offset_) * midway).head<2>();
  }

  double sum = 0.0;
  double turn = 0.0;  // of the heading, so that soles keep theirs
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (!loaded_[foot]) anchored_[foot] = false;
    if (!anchored_[foot]) continue;
    sum += seen_[foot].weight;
    turn += seen_[foot].weight * wrap_angle(anchor_yaw_[foot] - seen_[foot].yaw - yaw_offset_);
  }
  if (sum > 0.0) {
    yaw_offset_ = wrap_angle(yaw_offset_ + turn / sum);
  }  // else in the air: heading goes on as the IMU says

  const Eigen::Matrix3d heading = rotation_z(yaw_offset_);
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  if (sum > 0.0) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (!anchored_[foot]) continue;
      shift +=
          seen_[foot].weight / sum * (anchor_[foot] - (heading * seen_[foot].position).head<2>());
    }
    position_.head<2>() = shift;
  }
  const double loads = seen_[0].weight + seen_[1].weight;
  if (loads > 0.0) {
    double z = 0.0;
    for (const Seen& seen : seen_) z += seen.weight / loads * (seen.height - seen.position.z());
    position_.z() = z;
  } else if (start) {  // held in the air: the lowest sole touches
    double z = 0.0;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (model_->soles[foot].link >= 0)
        z = std::max(z, seen_[foot].height - seen_[foot].position.z());
    }
    position_.z() = z;
  }
  configuration_.base.linear().noalias() = heading * upright_base_;
  configuration_.base.translation() = position_;

  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (!loaded_[foot] || anchored_[foot]) continue;
    anchored_[foot] = true;
    anchor_[foot] = (position_ + heading * seen_[foot].position).head<2>();
    anchor_yaw_[foot] = seen_[foot].yaw + yaw_offset_;
  }
}

// Loaded soles are at rest: the base moves against what the joints and its own turning make of
// them.
void Estimator::move_base() noexcept {
  const Eigen::Matrix3d heading = rotation_z(yaw_offset_);
  const double sum = seen_[0].weight + seen_[1].weight;
  Eigen::Vector3d omega = configuration_.base_angular_velocity;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  if (sum > 0.0) {
    double spin = 0.0;
    for (const Seen& seen : seen_) spin += seen.weight / sum * seen.spin;
    omega.z() -= spin;
    for (const Seen& seen : seen_) {
      // centre_velocity holds the turning about z that has just been taken off.
      const Eigen::Vector3d taken = -spin * Eigen::Vector3d::UnitZ().cross(seen.centre);
      velocity -= seen.weight / sum * (seen.centre_velocity + taken);
    }
  }
  configuration_.base_angular_velocity = heading * omega;
  configuration_.base_velocity = heading * velocity;
}

void Estimator::finish() noexcept {
  kinematics_.update(configuration_);
  const Eigen::Matrix3d heading = rotation_z(yaw_offset_);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // about the world's origin
  double force_z = 0.0;
  support_.clear();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Sole& sole = model_->soles[foot];
    if (sole.link < 0) continue;
    sole_[foot] = kinematics_.link_in_world(sole.link) * sole.frame;
    force_[foot] = (heading * force_[foot]).eval();
    torque_[foot] = (heading * torque_[foot]).eval();
    if (!loaded_[foot]) continue;
    moment += torque_[foot] + sole_[foot].translation().cross(force_[foot]);
    force_z += force_[foot].z();
    support_.add(sole, sole_[foot]);
  }
  support_.finish();
  if (own_attitude_) {
    const Eigen::Vector3d imu =
        kinematics_.link_in_world(model_->imu_link) * model_->imu.translation();
    imu_velocity_ = heading.transpose() * kinematics_.point_velocity(model_->imu_link, imu);
  }
  if (force_z > 0.0) {
    zmp_ << -moment.y() / force_z, moment.x() / force_z, 0.0;
  } else {
    zmp_ << kinematics_.com().x(), kinematics_.com().y(), 0.0;
  }
  if (model_->soles[0].link >= 0 && model_->soles[1].link >= 0) {
    const double left = yaw_of(sole_[0].linear());
    const double yaw = left + 0.5 * wrap_angle(yaw_of(sole_[1].linear()) - left);
    ground_.linear() = rotation_z(yaw);
    ground_.translation() = 0.5 * (sole_[0].translation() + sole_[1].translation());
    ground_.translation().z() = 0.0;
  }
}

// Where the feet that stand are at rest.  A tick that was seen, of another robot, tells of its joints alone.
void Estimator::follow_points(const RobotState& state, bool again) noexcept {
  if (!again) odometry_->update(state);
  set_joints(*model_, state, configuration_);
  const Estimate& e = odometry_->estimate();
  configuration_.base.linear() = quaternion_from_array(e.base_attitude).toRotationMatrix();
  configuration_.base.translation() << e.base_position[0], e.base_position[1], e.base_position[2];
  configuration_.base_velocity = vector_from_array(e.base_velocity);
  configuration_.base_angular_velocity = vector_from_array(e.base_angular_velocity);
  kinematics_.update(configuration_);
  support_.clear();
  const StandingFeet& feet = odometry_->feet();
  double load = 0.0;
  Eigen::Vector2d pressed = Eigen::Vector2d::Zero();
  bool any = false;
  for (int foot = 0; foot < feet.count(); ++foot) {
    if (!feet.stands(foot)) continue;
    const Eigen::Vector2d place = (configuration_.base * feet.point(foot)).head<2>();
    support_.add(place);
    any = true;
    load += std::max(0.0, feet.load(foot));
    pressed += std::max(0.0, feet.load(foot)) * place;
  }
  support_.finish();
  loaded_ = {any, any};
  zmp_ << (load > 0.0 ? Eigen::Vector2d(pressed / load) : Eigen::Vector2d(kinematics_.com().head<2>())), 0.0;
  ground_ = upright(configuration_.base);
  ground_.translation().z() = 0.0;
  const double period = model_->period();
  dt_ = period;
  started_ = true;
  follow_dcm();
}

// Begins at rest, for one reading of the joints is noise.  Another source goes on with it: its robot moves as the last
// one did.
void Estimator::follow_dcm() noexcept {
  const double height = std::max(kLeastHeight, kinematics_.com().z());
  const Kinematics::Momentum momentum = kinematics_.momentum();
  const Eigen::Vector3d& spin = momentum.angular;
  com_velocity_ = momentum.com_velocity;
  spun_velocity_ = com_velocity_.head<2>() +
                   kGravity / (weight_force_ * height) * Eigen::Vector2d(spin.y(), -spin.x());
  dcm_velocity_ += dt_ * kGravity / height * (kinematics_.com() - zmp_).head<2>();
  dcm_velocity_ += dt_ / (dt_ + kDcmFilter) * (spun_velocity_ - dcm_velocity_);
  if (std::exchange(resumed_, false)) dcm_velocity_ = spun_velocity_;
}

}  // namespace twinbus::robot
