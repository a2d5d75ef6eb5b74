// A robot of two joints that goes where it is told at once: enough for everything of bridge/ that
// is not physics.

#pragma once

#include "bridge/adaptor/adaptor.h"
#include "robot/description/model.h"

namespace twinbus::test {

inline constexpr std::int64_t kMs = 1'000'000;
inline constexpr std::int64_t kPeriodNs = 2 * kMs;

inline Model small_model() {
  Model model;
  model.links.resize(3);
  for (int j = 0; j < 2; ++j) {
    Joint joint;
    joint.child = j + 1;
    model.links[static_cast<std::size_t>(joint.child)].parent = joint.parent;
    joint.lower = -2.0;
    joint.upper = 2.0;
    joint.velocity = 4.0;
    joint.effort = 100.0;
    joint.kp = 1000.0;
    joint.kd = 20.0;
    joint.stop_kp = 800.0;
    joint.stop_kd = 40.0;
    model.joints.push_back(joint);
  }
  model.bus_joints = model.bus_index = {0, 1};
  model.floating_base = false;
  model.period_ns = static_cast<std::int32_t>(kPeriodNs);
  model.hash = 4711;
  return model;
}

// Answers that state: both joints to 0, by controller 7.
inline JointCommand command_for(const RobotState& state) {
  JointCommand c;
  c.tick = state.tick;
  c.run_id = state.run_id;
  c.term = state.term;
  c.model_hash = state.model_hash;
  c.controller_id = 7;
  c.joint_count = 2;
  c.kp.fill(1000.0F);
  return c;
}

class PointRobot : public RobotAdaptor {
 public:
  explicit PointRobot(bool simulator = true) : simulator_(simulator) {}
  Status open(const Model&, const AdaptorConfig&) override { return Status::kOk; }
  Status read(RobotState& state, double) override {
    if (read_status != Status::kOk) return read_status;
    state.q[0] = q;
    if (has_torque) {
      state.tau[0] = written.kp[0] * static_cast<float>(written.q[0] - q) - written.kd[0] * state.qd[0] + written.tau[0] + friction;
    }
    state.sensor_flags = kEncodersValid | (has_imu ? kImuValid : 0);
    return Status::kOk;
  }
  Status write(const JointCommand& command) override {
    written = command;
    ++writes;
    return write_status;
  }
  void close() override {}
  bool can_be_set() const override { return simulator_; }
  Status set_state(const ImposedState& state) override {
    if (!simulator_) return Status::kUnsupported;
    q = state.q[0];
    return Status::kOk;
  }
  bool is_hardware() const override { return !simulator_; }

  double q = 0.0;
  bool has_imu = false, has_torque = false;
  float friction = 0.0F;  // on top of what the servo gives [N m]
  Status read_status = Status::kOk, write_status = Status::kOk;
  JointCommand written;
  int writes = 0;

 private:
  bool simulator_;
};

}  // namespace twinbus::test
