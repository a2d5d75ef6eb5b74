// A robot whose driver speaks of motors where the bus speaks of joints, to the source a robot like any other: motor_space.h around
// another adaptor.  A robot without such joints passes as it is.

#pragma once

#include "bridge/adaptor/adaptor.h"
#include "bridge/adaptor/motor_space.h"

namespace twinbus::inline bridge {

class MotorSpaceAdaptor final : public RobotAdaptor {
 public:
  explicit MotorSpaceAdaptor(RobotAdaptor& inner) : inner_(inner) {}  // must outlive this

  Status open(const Model& model, const AdaptorConfig& config) override;
  // kDeviceError too when no posture of the joints has the motor angles that were read.
  Status read(RobotState& state, double timeout_s) override;
  // kOutOfRange too when the rods do not reach the target, which the gate never asks for.
  Status write(const JointCommand& command) override;
  void close() override { inner_.close(); }
  Status fall_safe() override { return inner_.fall_safe(); }
  bool is_hardware() const override { return inner_.is_hardware(); }

 private:
  RobotAdaptor& inner_;
  MotorSpace space_;
  RobotState read_;  // of the motors
  JointCommand written_;
  bool lost_ = false;  // said already
};

}  // namespace twinbus::bridge
