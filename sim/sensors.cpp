#include "sim/sensors.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics.h"

namespace twinbus {

namespace {

// Force and torque of the contacts beyond a sensor, on the robot, in the sensor's frame.
template <class Beyond>
std::array<float, 6> contact_wrench(const World& world, const Eigen::Isometry3d& frame,
                                    const Beyond& is_beyond) noexcept {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  for (const ContactPoint& contact : world.contacts()) {
    if (!is_beyond(contact)) continue;
    force += contact.force;
    torque += (contact.point - frame.translation()).cross(contact.force);
  }
  const Eigen::Vector3d f = frame.linear().transpose() * force;
  const Eigen::Vector3d t = frame.linear().transpose() * torque;
  std::array<float, 6> wrench{};
  for (int i = 0; i < 3; ++i) {
    wrench[static_cast<std::size_t>(i)] = static_cast<float>(f[i]);
    wrench[static_cast<std::size_t>(i) + 3] = static_cast<float>(t[i]);
  }
  return wrench;
}

}  // namespace

Sensors::Sensors(const Model& model, const SensorOptions& options)
    : model_(&model), options_(options), random_(options.seed) {
  options_.delay_ticks = std::clamp(options_.delay_ticks, 0, kMaxSensorDelay);
  history_.resize(static_cast<std::size_t>(options_.delay_ticks) + 1);
}

void Sensors::forget() noexcept {
  has_velocity_ = false;
  history_filled_ = false;
}

void Sensors::measure(const World& world, double dt, RobotState& state) noexcept {
  const int count = model_->bus_count();
  state.joint_count = static_cast<std::int16_t>(count);
  for (int k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const int joint = model_->bus_joints[at];
    double q = world.encoder(joint);
    if (options_.encoder_noise > 0.0) q += options_.encoder_noise * random_.normal();
    if (options_.encoder_quantum > 0.0)
      q = options_.encoder_quantum * std::round(q / options_.encoder_quantum);
    double qd = world.configuration().qd[joint];
    if (options_.velocity_noise > 0.0) qd += options_.velocity_noise * random_.normal();
    double tau = world.tau(joint);
    if (options_.torque_noise > 0.0) tau += options_.torque_noise * random_.normal();
    state.q[at] = q;
    state.qd[at] = static_cast<float>(qd);
    state.tau[at] = static_cast<float>(tau);
  }
  state.sensor_flags = kEncodersValid | kImuValid;
  measure_imu(world, dt, state);
  measure_wrenches(world, state);

  if (history_.size() > 1) {  // hand out what was measured delay_ticks ago
    if (!history_filled_) std::fill(history_.begin(), history_.end(), state);
    history_filled_ = true;
    history_[newest_] = state;
    newest_ = (newest_ + 1) % history_.size();
    state = history_[newest_];
  }
}

void Sensors::measure_imu(const World& world, double dt, RobotState& state) noexcept {
  const Eigen::Isometry3d imu = world.link_in_world(model_->imu_link) * model_->imu;
  const Eigen::Vector3d velocity = world.point_velocity(model_->imu_link, imu.translation());
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (has_velocity_ && dt > 0.0) acceleration = (velocity - velocity_) / dt;
  velocity_ = velocity;
  has_velocity_ = true;

  const Eigen::Matrix3d to_imu = imu.linear().transpose();
  Eigen::Vector3d accel = to_imu * (acceleration + Eigen::Vector3d(0.0, 0.0, kGravity));
  Eigen::Vector3d gyro = to_imu * world.angular_velocity(model_->imu_link);
  yaw_ += options_.yaw_drift * dt;
  Eigen::Quaterniond attitude =
      Eigen::AngleAxisd(yaw_, Eigen::Vector3d::UnitZ()) * Eigen::Quaterniond(imu.linear());
  if (options_.roll_bias != 0.0 || options_.pitch_bias != 0.0) {
    attitude = attitude * Eigen::AngleAxisd(options_.roll_bias, Eigen::Vector3d::UnitX()) *
               Eigen::AngleAxisd(options_.pitch_bias, Eigen::Vector3d::UnitY());
  }
  if (options_.attitude_noise > 0.0) {
    const Eigen::Vector3d turn =
        options_.attitude_noise * 0.5 *
        Eigen::Vector3d(random_.normal(), random_.normal(), random_.normal());
    attitude = attitude * Eigen::Quaterniond(1.0, turn.x(), turn.y(), turn.z());
  }
  attitude.normalize();
  for (int i = 0; i < 3; ++i) {
    gyro[i] += options_.gyro_bias +
               (options_.gyro_noise > 0.0 ? options_.gyro_noise * random_.normal() : 0.0);
    accel[i] += options_.accel_bias +
                (options_.accel_noise > 0.0 ? options_.accel_noise * random_.normal() : 0.0);
  }
  if (attitude.w() < 0.0) attitude.coeffs() *= -1.0;
  state.attitude = {static_cast<float>(attitude.w()), static_cast<float>(attitude.x()),
                    static_cast<float>(attitude.y()), static_cast<float>(attitude.z())};
  for (int i = 0; i < 3; ++i) {
    state.gyro[static_cast<std::size_t>(i)] = static_cast<float>(gyro[i]);
    state.accel[static_cast<std::size_t>(i)] = static_cast<float>(accel[i]);
  }
}

void Sensors::measure_wrenches(const World& world, RobotState& state) noexcept {
  for (int limb = 0; limb < kLimbs; ++limb) {
    const auto at = static_cast<std::size_t>(limb);
    const bool is_foot = limb == kLeftFoot || limb == kRightFoot;
    const std::size_t side = limb == kLeftFoot || limb == kLeftHand ? 0 : 1;
    const int link = is_foot ? model_->soles[side].link : model_->hands[side].link;
    state.wrench[at] = {};
    state.wrench_kind[at] = link < 0 ? WrenchKind::kAbsent : WrenchKind::kMeasured;
    if (link < 0) continue;
    const Eigen::Isometry3d frame =
        world.link_in_world(link) *
        (is_foot ? model_->soles[side].sensor : model_->hands[side].sensor);
    state.wrench[at] = contact_wrench(world, frame, [&](const ContactPoint& contact) {
      return is_foot ? of_foot(*model_, contact, side) : contact.link == link;
    });
    for (std::size_t i = 0; i < 6; ++i) {
      const double noise = i < 3 ? options_.force_noise : options_.moment_noise;
      if (noise > 0.0) state.wrench[at][i] += static_cast<float>(noise * random_.normal());
    }
    state.sensor_flags |= wrench_valid(static_cast<Limb>(limb));
  }
}

}  // namespace twinbus
