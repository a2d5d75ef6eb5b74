// How far and how fast a balancing robot moves when an operator says no more than the motion: the terminal, the page, and the
// scenes sway and squat.

#pragma once

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

struct MotionDefaults {
  float amplitude, frequency;  // [m], [Hz]
};

constexpr MotionDefaults defaults_of(Motion motion) {
  switch (motion) {
    case Motion::kSway:
      return {0.03F, 0.4F};
    case Motion::kSquat:
      return {0.05F, 0.3F};
    default:
      return {0.0F, 0.0F};
  }
}

}  // namespace twinbus::lcmtypes
