// The channel that a source publishes its states on while it is not active.

#pragma once

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

inline const Channel<RobotState>& own_channel(SourceKind kind) {
  switch (kind) {
    case SourceKind::kBridge:
      return channel::kStateBridge;
    case SourceKind::kReplay:
      return channel::kStateReplay;
    default:
      return channel::kStateSim;
  }
}

}  // namespace twinbus::bridge
