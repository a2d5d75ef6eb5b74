#include "sim/scene/sensors.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline sim {

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
    if (!contact.moment.isZero(0.0)) torque += contact.moment;
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

// Roll and pitch of an attitude as an inclination sensor reads them; its heading is left alone.
Eigen::Quaterniond inclined(const Eigen::Quaterniond& attitude, const Imperfection& sensor,
                            Random& random) noexcept {
  const Eigen::Matrix3d r = attitude.toRotationMatrix();
  const Imperfection reading{.quantum = sensor.quantum, .limit = sensor.limit};
  const double roll = reading.read(std::atan2(r(2, 1), r(2, 2)), random);
  const double pitch = reading.read(std::asin(std::clamp(-r(2, 0), -1.0, 1.0)), random);
  return Eigen::AngleAxisd(std::atan2(r(1, 0), r(0, 0)), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

}  // namespace

bool Sensors::SampleClock::due(double dt, double rate) noexcept {
  if (!(rate > 0.0)) return true;
  const bool first = left < 0.0;
  left = first ? 0.0 : left - dt;
  if (left > 1e-9) return false;
  left = std::max(left + 1.0 / rate, 0.0);  // keeps the mean of a rate that is no divisor
  return true;
}

Sensors::Sensors(const Model& model, const SensorOptions& options)
    : model_(&model), feet_(felt_feet(model)), options_(options), random_(options.seed) {
  options_.delay_ticks = std::clamp(options_.delay_ticks, 0, kMaxSensorDelay);
  history_.resize(static_cast<std::size_t>(options_.delay_ticks) + 1);
}

void Sensors::forget() noexcept {
  has_velocity_ = false;
  history_filled_ = false;
  encoders_ = imu_ = forces_ = SampleClock{};
}

void Sensors::measure(const World& world, double dt, RobotState& state) noexcept {
  if (encoders_.due(dt, options_.encoder_rate)) measure_joints(world);
  measure_imu(world, dt);
  if (forces_.due(dt, options_.force_rate)) measure_wrenches(world);
  state.joint_count = sample_.joint_count;
  state.q = sample_.q;
  state.qd = sample_.qd;
  state.tau = sample_.tau;
  state.attitude = sample_.attitude;
  state.gyro = sample_.gyro;
  state.accel = sample_.accel;
  state.wrench = sample_.wrench;
  state.wrench_kind = sample_.wrench_kind;
  state.sensor_flags = sample_.sensor_flags;

  if (history_.size() > 1) {  // hand out what was measured delay_ticks ago
    if (!history_filled_) std::fill(history_.begin(), history_.end(), state);
    history_filled_ = true;
    history_[newest_] = state;
    newest_ = (newest_ + 1) % history_.size();
    state = history_[newest_];
  }
}

void Sensors::measure_joints(const World& world) noexcept {
  const int count = model_->bus_count();
  const Eigen::VectorXd& qd = world.configuration().qd;
  sample_.joint_count = static_cast<std::int16_t>(count);
  for (int k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const int joint = model_->bus_joints[at];
    sample_.q[at] = options_.encoder.read(world.encoder(joint), random_);
    sample_.qd[at] = static_cast<float>(options_.velocity.read(qd[joint], random_));
    sample_.tau[at] = static_cast<float>(options_.torque.read(world.tau(joint), random_));
  }
  sample_.sensor_flags |= kEncodersValid;
}

void Sensors::measure_imu(const World& world, double dt) noexcept {
  const Eigen::Isometry3d imu = world.link_in_world(model_->imu_link) * model_->imu;
  const Eigen::Vector3d velocity = world.point_velocity(model_->imu_link, imu.translation());
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (has_velocity_ && dt > 0.0) acceleration = (velocity - velocity_) / dt;
  velocity_ = velocity;
  has_velocity_ = true;
  yaw_ += options_.yaw_drift * dt;
  if (!imu_.due(dt, options_.imu_rate)) return;

  const Eigen::Matrix3d to_imu = imu.linear().transpose();
  const Eigen::Vector3d accel = to_imu * (acceleration + Eigen::Vector3d(0.0, 0.0, kGravity));
  const Eigen::Vector3d gyro = to_imu * world.angular_velocity(model_->imu_link);
  Eigen::Quaterniond attitude =
      Eigen::AngleAxisd(yaw_, Eigen::Vector3d::UnitZ()) * Eigen::Quaterniond(imu.linear());
  const Imperfection& inclination = options_.inclination;
  if (options_.roll_bias != 0.0 || options_.pitch_bias != 0.0) {
    attitude = attitude * Eigen::AngleAxisd(options_.roll_bias, Eigen::Vector3d::UnitX()) *
               Eigen::AngleAxisd(options_.pitch_bias, Eigen::Vector3d::UnitY());
  }
  if (inclination.noise > 0.0) {
    const Eigen::Vector3d turn =
        inclination.noise * 0.5 *
        Eigen::Vector3d(random_.normal(), random_.normal(), random_.normal());
    attitude = attitude * Eigen::Quaterniond(1.0, turn.x(), turn.y(), turn.z());
  }
  if (inclination.quantum > 0.0 || inclination.limit > 0.0)
    attitude = inclined(attitude, inclination, random_);
  attitude.normalize();
  if (attitude.w() < 0.0) attitude.coeffs() *= -1.0;
  sample_.attitude = {static_cast<float>(attitude.w()), static_cast<float>(attitude.x()),
                      static_cast<float>(attitude.y()), static_cast<float>(attitude.z())};
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sample_.gyro[at] = static_cast<float>(options_.gyro.read(gyro[i], random_));
    sample_.accel[at] = static_cast<float>(options_.accel.read(accel[i], random_));
  }
  sample_.sensor_flags |= kImuValid;
}

void Sensors::measure_wrenches(const World& world) noexcept {
  for (int limb = 0; limb < kLimbs; ++limb) {
    const auto at = static_cast<std::size_t>(limb);
    const FeltFoot* foot = limb < kLeftHand ? &feet_.foot[at] : nullptr;
    const Hand& hand = model_->hands[limb == kLeftHand ? 0 : 1];
    const int link = foot == nullptr ? hand.link : options_.foot_forces ? foot->link : -1;
    sample_.wrench[at] = {};
    sample_.wrench_kind[at] = link < 0                               ? WrenchKind::kAbsent
                              : foot != nullptr && foot->side < 0 ? WrenchKind::kEstimated
                                                                  : WrenchKind::kMeasured;
    if (link < 0) continue;
    const Eigen::Isometry3d frame = world.link_in_world(link) * (foot != nullptr ? foot->sensor : hand.sensor);
    sample_.wrench[at] = contact_wrench(
        world, frame, [&](const ContactPoint& contact) { return foot != nullptr ? foot->feels(contact) : contact.link == link; });
    for (std::size_t i = 0; i < 6; ++i) {
      const Imperfection& sensor = i < 3 ? options_.force : options_.moment;
      float& component = sample_.wrench[at][i];
      component = static_cast<float>(sensor.read(static_cast<double>(component), random_));
    }
    sample_.sensor_flags |= wrench_valid(static_cast<Limb>(limb));
  }
}

}  // namespace twinbus::sim
