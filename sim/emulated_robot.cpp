#include "sim/emulated_robot.h"

#include <cmath>
#include <stdexcept>

namespace twinbus::inline sim {

using emulated::CommandKind;
using emulated::DeviceMode;

namespace {

constexpr double kDampPerEffort = 0.03;  // kd of damping per N m of effort limit [s/rad]

bool finite(const emulated::CommandPacket& packet) noexcept {
  for (std::size_t i = 0; i < packet.joint_count; ++i) {
    if (!std::isfinite(packet.q[i]) || !std::isfinite(packet.qd[i]) ||
        !std::isfinite(packet.tau[i]) || !(packet.kp[i] >= 0.0F && packet.kp[i] < 1e7F) ||
        !(packet.kd[i] >= 0.0F && packet.kd[i] < 1e6F)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> EmulatedRobot::differences() {
  return {{"model.mass_scale", "1.03"},       {"model.friction", "1.0"},
          {"model.friction_share", "0.01"},   {"servo.delay_ms", "2"},
          {"model.backlash", "0.0005"},
          {"contact.stiffness_scale", "0.8"}, {"contact.damping_scale", "1.2"},
          {"contact.friction", "0.7"},        {"sensor.noise.encoder", "1e-5"},
          {"sensor.quantum.encoder", "1e-5"}, {"sensor.noise.velocity", "0.002"},
          {"sensor.noise.torque", "0.1"},     {"sensor.noise.attitude", "1e-4"},
          {"sensor.noise.gyro", "0.001"},     {"sensor.noise.accel", "0.02"},
          {"sensor.noise.force", "1.0"},      {"sensor.noise.moment", "0.05"}};
}

EmulatedRobot::EmulatedRobot(const Model& model, Scene scene, const EmulatedRobotOptions& options)
    : model_(&model), options_(options) {
  AdaptorConfig config{.settings = differences()};
  config.settings.insert(config.settings.end(), options.settings.begin(), options.settings.end());
  scene.pushes.clear();
  body_ = std::make_unique<SimAdaptor>(scene);
  if (body_->open(model, config) != Status::kOk) {
    throw std::runtime_error("the body cannot be simulated in scene " + scene.name);
  }
  command_.joint_count = static_cast<std::int16_t>(model.bus_count());
  motors_ = MotorSpace(model);
  pairs_ = parallel_joints_of(model);
}

bool EmulatedRobot::accept(const emulated::CommandPacket& packet, std::int64_t now_ns) noexcept {
  const bool known = packet.model_hash == model_->hash &&
                     packet.joint_count == static_cast<std::uint32_t>(model_->bus_count()) &&
                     !(packet.session == newest_.session && packet.sequence <= newest_.sequence);
  if (!known || (packet.kind == CommandKind::kDrive && !finite(packet))) {
    ++dropped_;
    return false;
  }
  switch (packet.kind) {
    case CommandKind::kHello:
      break;
    case CommandKind::kDrive:
      for (std::size_t i = 0; i < packet.joint_count; ++i) {
        command_.q[i] = packet.q[i];
        command_.qd[i] = packet.qd[i];
        command_.tau[i] = packet.tau[i];
        command_.kp[i] = packet.kp[i];
        command_.kd[i] = packet.kd[i];
      }
      mode_ = DeviceMode::kDriven;
      commanded_ns_ = now_ns;
      break;
    case CommandKind::kRelease:
      // Brakes: what the servos held last is held on.
      if (mode_ != DeviceMode::kBraked) command_.qd.fill(0.0F);
      mode_ = DeviceMode::kBraked;
      break;
    case CommandKind::kDamp:
      mode_ = DeviceMode::kDamping;
      break;
    default:
      ++dropped_;
      return false;
  }
  newest_ = packet;
  return true;
}

void EmulatedRobot::watch(std::int64_t now_ns) noexcept {
  const double silence = 1e-9 * static_cast<double>(now_ns - commanded_ns_);
  if (mode_ == DeviceMode::kDriven && silence > options_.watchdog) {
    mode_ = DeviceMode::kHolding;
    command_.qd.fill(0.0F);
  }
  if (mode_ == DeviceMode::kHolding && silence > options_.watchdog + options_.hold)
    mode_ = DeviceMode::kDamping;
}

// A motor damps by its own torque limit.
void EmulatedRobot::damp_motors() noexcept {
  for (const ParallelJoints& pair : pairs_) {
    if (!pair.driver_of_motors) continue;
    for (int i = 0; i < 2; ++i) {
      const int bus = model_->bus_index[static_cast<std::size_t>(pair.joints[static_cast<std::size_t>(i)])];
      command_.kd[static_cast<std::size_t>(bus)] = static_cast<float>(kDampPerEffort * pair.drive.motor(i).torque);
    }
  }
}

void EmulatedRobot::cycle(std::int64_t now_ns, emulated::StatePacket& packet) noexcept {
  watch(now_ns);
  if (mode_ == DeviceMode::kDamping) {
    command_.tau.fill(0.0F);
    command_.qd.fill(0.0F);
    command_.kp.fill(0.0F);
    for (std::size_t k = 0; k < model_->bus_joints.size(); ++k) {
      const Joint& joint = model_->joints[static_cast<std::size_t>(model_->bus_joints[k])];
      command_.kd[k] = static_cast<float>(kDampPerEffort * joint.effort);
    }
    damp_motors();
  }
  // Before its first command the body holds its start pose by itself.
  if (newest_.sequence != 0 && commanded_ns_ != 0) {
    JointCommand joints = command_;
    if (motors_.to_joints(joints)) driven_ = joints;  // else what it was: the motors run against their rods
    (void)body_->write(driven_);
  }
  (void)body_->read(state_, 0.0);
  (void)motors_.to_motors(state_);

  packet.mode = mode_;
  packet.sequence = ++cycles_;
  packet.command_session = newest_.session;
  packet.command_sequence = newest_.sequence;
  packet.device_time_ns = now_ns;
  packet.model_hash = model_->hash;
  packet.enabled =
      mode_ == DeviceMode::kDriven || mode_ == DeviceMode::kHolding ? state_.enabled : 0;
  packet.dropped = dropped_;
  packet.joint_count = static_cast<std::uint32_t>(state_.joint_count);
  packet.sensor_flags = state_.sensor_flags;
  packet.q = state_.q;
  packet.qd = state_.qd;
  packet.tau = state_.tau;
  packet.attitude = state_.attitude;
  packet.gyro = state_.gyro;
  packet.accel = state_.accel;
  packet.wrench = state_.wrench;
  for (std::size_t i = 0; i < packet.wrench_kind.size(); ++i)
    packet.wrench_kind[i] = static_cast<std::int8_t>(state_.wrench_kind[i]);
  emulated::seal(packet);
}

}  // namespace twinbus::sim
