// A list of footsteps seen by a robot: which of them its legs and soles cannot do, and where they are on the ground.

#pragma once

#include <array>

#include "control/walk/footsteps.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus::inline control {

struct StepRefusal {
  int step = -1;              // the first that cannot be done, from 0
  const char* why = nullptr;  // a sentence that lives for ever; null: all can be done
};

StepRefusal check_steps(const Gait& gait, const StepList& list) noexcept;

// 0 left, 1 right.
inline int first_foot(const StepList& list) noexcept {
  return list.first_foot == FootSide::kRight ? 1 : 0;
}

// Where the soles go one after the other, from where they stand.  How many were filled.
int place_steps(const StepList& list, const std::array<Foothold, 2>& feet,
                std::array<Foothold, kMostSteps>& places) noexcept;

}  // namespace twinbus::control
