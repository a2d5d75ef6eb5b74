// The robot of the tests of views, and its STATE while it stands.

#pragma once

#include "lcmtypes/msg/robot_io.h"
#include "robot/description/load.h"

namespace twinbus::test {

inline const Model& model() {
  static const Model kModel = load_robot("hrp1s");
  return kModel;
}

inline RobotState standing(std::int64_t run = 11) {
  RobotState state;
  state.tick = 7;
  state.run_id = run;
  state.term = 3;
  state.model_hash = model().hash;
  state.joint_count = static_cast<std::int16_t>(model().bus_count());
  state.source = SourceKind::kBridge;
  state.role = Role::kActive;
  state.sensor_flags = kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
  state.wrench_kind = {WrenchKind::kMeasured, WrenchKind::kMeasured, WrenchKind::kAbsent, WrenchKind::kAbsent};
  state.wrench[kLeftFoot][2] = 640;
  state.wrench[kRightFoot][2] = 640;
  return state;
}

}  // namespace twinbus::test
