// Which joint each motor of a Unitree robot is, by name: one table per robot, in the order of motor_cmd and motor_state.

#pragma once

#include <array>
#include <string>
#include <vector>

#include "bridge/unitree/low_frames.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

struct MotorOrder {
  std::string robot;                      // G1, Go2, Go1
  std::array<int, kHgMotors> bus_index{};  // of each motor; -1: the model has no such joint
  int mode_machine = 0;                   // hg: what the robot calls its build, by the motors that the model lacks; 0 go
  std::vector<int> absent;                // motors of the table that the model lacks
};

// The table in which every joint that the model has on the bus is found.  Throws std::runtime_error naming the joints that are
// in no table of this family.
MotorOrder motor_order(const Model& model, UnitreeFamily family);

// "unitree_hg", "unitree_go".
const char* family_name(UnitreeFamily family) noexcept;

}  // namespace twinbus::bridge
