#include "bridge/adaptor/motor_space_adaptor.h"

#include <cstdio>

namespace twinbus::inline bridge {

Status MotorSpaceAdaptor::open(const Model& model, const AdaptorConfig& config) {
  space_ = MotorSpace(model);
  lost_ = false;
  return inner_.open(model, config);
}

Status MotorSpaceAdaptor::read(RobotState& state, double timeout_s) {
  if (space_.empty()) return inner_.read(state, timeout_s);
  read_ = state;
  const Status status = inner_.read(read_, timeout_s);
  if (status != Status::kOk) return status;
  if (!space_.to_joints(read_)) {
    if (!lost_) std::fprintf(stderr, "bridge: the motors are at angles that the rods do not allow: %s; correct its points, or calibrate the motors\n", space_.where().c_str());
    lost_ = true;
    return Status::kDeviceError;
  }
  lost_ = false;
  state = read_;
  return Status::kOk;
}

Status MotorSpaceAdaptor::write(const JointCommand& command) {
  if (space_.empty()) return inner_.write(command);
  written_ = command;
  return space_.to_motors(written_) ? inner_.write(written_) : Status::kOutOfRange;
}

}  // namespace twinbus::bridge
