// The channels and the message that travels on each.  `--prefix R1_` is put before every name by Bus.

#pragma once

#include <string>
#include <string_view>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// Used as its name where one is wanted.
template <class T>
struct Channel {
  const char* name;
  constexpr operator const char*() const noexcept { return name; }
};
template <class T>
constexpr bool operator==(std::string_view name, const Channel<T>& channel) noexcept {
  return name == std::string_view(channel.name);
}
template <class T>
std::string operator+(const std::string& prefix, const Channel<T>& channel) {
  return prefix + channel.name;
}

namespace channel {

inline constexpr Channel<RobotState> kState{"STATE"};
inline constexpr Channel<RobotState> kStateSim{"STATE_SIM"};
inline constexpr Channel<RobotState> kStateBridge{"STATE_BRIDGE"};
inline constexpr Channel<RobotState> kStateReplay{"STATE_REPLAY"};
inline constexpr Channel<JointCommand> kCommand{"COMMAND"};
inline constexpr Channel<StopPlanPiece> kStopPlan{"STOP_PLAN"};
inline constexpr Channel<SourceStatus> kSourceStatus{"SOURCE_STATUS"};
inline constexpr Channel<SourceRequest> kSourceRequest{"SOURCE_REQUEST"};
inline constexpr Channel<ControllerRequest> kControllerRequest{"CONTROLLER_REQUEST"};
inline constexpr Channel<ModeRequest> kModeRequest{"MODE_REQUEST"};
inline constexpr Channel<StopRequest> kStop{"STOP"};
inline constexpr Channel<Estimate> kEstimate{"ESTIMATE"};
inline constexpr Channel<SimTruth> kTruth{"TRUTH"};
inline constexpr Channel<GuardReport> kGuard{"GUARD"};
inline constexpr Channel<Gamepad> kGamepad{"GAMEPAD"};
inline constexpr Channel<WalkCommand> kWalk{"WALK"};
inline constexpr Channel<StepList> kSteps{"STEPS"};
inline constexpr Channel<MotionPiece> kMotion{"MOTION"};
inline constexpr Channel<SimRequest> kSimRequest{"SIM_REQUEST"};
inline constexpr Channel<ArmGoal> kArmGoal{"ARM_GOAL"};
inline constexpr Channel<ArmPathPiece> kArmPath{"ARM_PATH"};
inline constexpr Channel<ControllerStatus> kControllerStatus{"CONTROLLER_STATUS"};
inline constexpr Channel<Gap> kGap{"GAP"};
inline constexpr Channel<ObstaclesPiece> kObstacles{"OBSTACLES"};
inline constexpr Channel<ObstaclesPiece> kHeld{"HELD"};
inline constexpr Channel<Heartbeat> kHeartbeat{"HEARTBEAT"};
inline constexpr Channel<ModelTextPiece> kModelText{"MODEL_TEXT"};
inline constexpr Channel<Event> kEvent{"EVENT"};
inline constexpr Channel<JournalPage> kJournal{"JOURNAL"};
// Only for whoever draws: what of the scene is ground or moves, where the feet go, what a camera sees.
inline constexpr Channel<ObstaclesPiece> kTerrain{"TERRAIN"};
inline constexpr Channel<ObstaclesPiece> kLoose{"LOOSE"};
inline constexpr Channel<ObstaclesPiece> kFootsteps{"FOOTSTEPS"};
inline constexpr Channel<ModelTextPiece> kCamera{"CAMERA"};
// Only in logs: what a recorder writes about itself (model_text_t).
inline constexpr Channel<ModelTextPiece> kLogText{"LOG_TEXT"};

}  // namespace channel

// Of messages that have one channel each.
constexpr auto channel_of(const SourceRequest&) noexcept { return channel::kSourceRequest; }
constexpr auto channel_of(const ControllerRequest&) noexcept { return channel::kControllerRequest; }
constexpr auto channel_of(const SimRequest&) noexcept { return channel::kSimRequest; }
constexpr auto channel_of(const StopRequest&) noexcept { return channel::kStop; }
constexpr auto channel_of(const ModeRequest&) noexcept { return channel::kModeRequest; }
constexpr auto channel_of(const WalkCommand&) noexcept { return channel::kWalk; }
constexpr auto channel_of(const StepList&) noexcept { return channel::kSteps; }
constexpr auto channel_of(const MotionPiece&) noexcept { return channel::kMotion; }
constexpr auto channel_of(const Gamepad&) noexcept { return channel::kGamepad; }
constexpr auto channel_of(const ArmGoal&) noexcept { return channel::kArmGoal; }
constexpr auto channel_of(const ArmPathPiece&) noexcept { return channel::kArmPath; }
constexpr auto channel_of(const GuardReport&) noexcept { return channel::kGuard; }

}  // namespace twinbus::lcmtypes
