// Names of the channels.  `--prefix R1_` is put before every one of them by Bus.

#pragma once

namespace twinbus::channel {

inline constexpr char kState[] = "STATE";
inline constexpr char kStateSim[] = "STATE_SIM";
inline constexpr char kStateBridge[] = "STATE_BRIDGE";
inline constexpr char kStateReplay[] = "STATE_REPLAY";
inline constexpr char kCommand[] = "COMMAND";
inline constexpr char kStopPlan[] = "STOP_PLAN";
inline constexpr char kSourceStatus[] = "SOURCE_STATUS";
inline constexpr char kSourceRequest[] = "SOURCE_REQUEST";
inline constexpr char kControllerRequest[] = "CONTROLLER_REQUEST";
inline constexpr char kModeRequest[] = "MODE_REQUEST";
inline constexpr char kStop[] = "STOP";
inline constexpr char kEstimate[] = "ESTIMATE";
inline constexpr char kTruth[] = "TRUTH";
inline constexpr char kGuard[] = "GUARD";
inline constexpr char kGamepad[] = "GAMEPAD";
inline constexpr char kWalk[] = "WALK";
inline constexpr char kSteps[] = "STEPS";
inline constexpr char kMotion[] = "MOTION";
inline constexpr char kSimRequest[] = "SIM_REQUEST";
inline constexpr char kArmGoal[] = "ARM_GOAL";
inline constexpr char kArmPath[] = "ARM_PATH";
inline constexpr char kControllerStatus[] = "CONTROLLER_STATUS";
inline constexpr char kGap[] = "GAP";
inline constexpr char kObstacles[] = "OBSTACLES";
inline constexpr char kHeld[] = "HELD";
inline constexpr char kHeartbeat[] = "HEARTBEAT";
inline constexpr char kModelText[] = "MODEL_TEXT";
inline constexpr char kEvent[] = "EVENT";
inline constexpr char kJournal[] = "JOURNAL";
// Only for whoever draws: what of the scene is ground or moves, where the feet go, what a camera sees.
inline constexpr char kTerrain[] = "TERRAIN";
inline constexpr char kLoose[] = "LOOSE";
inline constexpr char kFootsteps[] = "FOOTSTEPS";
inline constexpr char kCamera[] = "CAMERA";
// Only in logs: what a recorder writes about itself (model_text_t).
inline constexpr char kLogText[] = "LOG_TEXT";

}  // namespace twinbus::channel
