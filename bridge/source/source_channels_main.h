// The channels that a source publishes on: of its states while it is not active, and of the requests of a scene's script.

#pragma once

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus {

inline const char* own_channel(SourceKind kind) {
  switch (kind) {
    case SourceKind::kBridge:
      return channel::kStateBridge;
    case SourceKind::kReplay:
      return channel::kStateReplay;
    default:
      return channel::kStateSim;
  }
}

inline const char* channel_of(const ModeRequest&) { return channel::kModeRequest; }
inline const char* channel_of(const ArmGoal&) { return channel::kArmGoal; }
inline const char* channel_of(const WalkCommand&) { return channel::kWalk; }
inline const char* channel_of(const StepList&) { return channel::kSteps; }
inline const char* channel_of(const MotionPiece&) { return channel::kMotion; }
inline const char* channel_of(const Gamepad&) { return channel::kGamepad; }

}  // namespace twinbus
