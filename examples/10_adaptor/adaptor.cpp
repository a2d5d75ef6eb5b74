// 10 An adaptor: a robot whose servos are perfect, so that every joint is where the last command put it.  What a driver for real
// hardware does in read() and write() with its bus, this does with a variable.
//
//   build/release/bin/twinbus_bridge --robot hrp1s --adaptor build/release/lib/adaptors/perfect_servos.so

#include "bridge/adaptor/adaptor_abi.h"

namespace twinbus {

class PerfectServos final : public RobotAdaptor {
 public:
  // May take time: open the device, compare what it says with the model, home the joints.
  Status open(const Model& model, const AdaptorConfig& config) override {
    if (!config.settings.empty()) return Status::kUnsupported;  // --set key=value
    joints_ = model.bus_count();
    period_ns_ = model.period_ns;
    target_ = JointCommand{};
    for (const NamedPose& pose : model.poses) {  // where a robot stands that was just switched on
      if (pose.name != "half_sitting") continue;
      for (int k = 0; k < joints_; ++k) target_.q[at(k)] = pose.q[at(model.bus_joints[at(k)])];
    }
    return Status::kOk;
  }

  // Once per tick.  Says what is measured, and which sensors there are: here encoders and an IMU that stands upright.
  Status read(RobotState& state, double) override {
    for (int k = 0; k < joints_; ++k) {
      state.q[at(k)] = target_.q[at(k)];
      state.qd[at(k)] = target_.qd[at(k)];
      state.tau[at(k)] = target_.tau[at(k)];
    }
    state.attitude = {1.0F, 0.0F, 0.0F, 0.0F};
    state.accel = {0.0F, 0.0F, 9.81F};
    state.sensor_flags = kEncodersValid | kImuValid;
    state.wrench_kind.fill(WrenchKind::kAbsent);
    state.enabled = (std::int64_t{1} << joints_) - 1;
    state.source_time_ns += period_ns_;
    return Status::kOk;
  }

  // The gate has passed this command: it is finite and within the limits of the model.
  Status write(const JointCommand& command) override {
    target_ = command;
    return Status::kOk;
  }

  void close() override {}

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int joints_ = 0;
  std::int64_t period_ns_ = 0;
  JointCommand target_;
};

}  // namespace twinbus

TWINBUS_ADAPTOR(twinbus::PerfectServos)
