// The structs of robot/ as bytes on the bus.
//
// decode() accepts exactly one encoded size per type, with the right fingerprint, with every number
// finite and in range (convert.h); anything else is refused whole.  encode() refuses the same, so
// no process can send what no process would take.

#pragma once

#include <cstdint>
#include <span>

#include "lcmtypes/msg/estimate.h"
#include "lcmtypes/msg/full_heartbeat.h"
#include "lcmtypes/msg/journal.h"
#include "lcmtypes/msg/pieces.h"
#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/sim_request.h"
#include "lcmtypes/msg/status.h"
#include "lcmtypes/msg/step_list.h"
#include "lcmtypes/msg/stop_plan.h"

namespace twinbus {

inline constexpr int kLargestMessage = 1400;  // one Ethernet frame, so never split [bytes]

// Writes the encoded form to bytes and returns its size; 0 if there is no room or a number is not
// fit to send.
template <class T>
[[nodiscard]] int encode(const T& value, std::span<std::uint8_t> bytes) noexcept;

// Fills value.  When it is not kOk, value is unspecified.
template <class T>
Status decode(std::span<const std::uint8_t> bytes, T& value) noexcept;

// What a receiver needs to know of each type besides its bytes:
//   kBytes        encoded size
//   sender(x)     who sent it: one slot per sender
//   kCounted      whether count(x) goes up by one per message of one sender (ticks, sequences)
template <class T>
struct Wire;

template <int bytes, bool counted>
struct WireBase {
  static constexpr int kBytes = bytes;
  static constexpr bool kCounted = counted;
};

template <>
struct Wire<RobotState> : WireBase<1013, true> {
  static std::int64_t sender(const RobotState& x) noexcept { return x.run_id; }
  static std::int64_t count(const RobotState& x) noexcept { return x.tick; }
};
template <>
struct Wire<JointCommand> : WireBase<1200, true> {
  static std::int64_t sender(const JointCommand& x) noexcept { return x.controller_id; }
  static std::int64_t count(const JointCommand& x) noexcept { return x.tick; }
};
template <>
struct Wire<StopPlanPiece> : WireBase<1224, false> {
  static std::int64_t sender(const StopPlanPiece& x) noexcept { return x.head.controller_id; }
};
template <>
struct Wire<StopRequest> : WireBase<34, true> {
  static std::int64_t sender(const StopRequest& x) noexcept { return x.sender_id; }
  static std::int64_t count(const StopRequest& x) noexcept { return x.sequence; }
};
template <>
struct Wire<SourceRequest> : WireBase<47, true> {
  static std::int64_t sender(const SourceRequest& x) noexcept { return x.sender_id; }
  static std::int64_t count(const SourceRequest& x) noexcept { return x.sequence; }
};
template <>
struct Wire<SourceStatus> : WireBase<158, false> {
  static std::int64_t sender(const SourceStatus& x) noexcept { return x.run_id; }
};
template <>
struct Wire<ControllerRequest> : WireBase<44, true> {
  static std::int64_t sender(const ControllerRequest& x) noexcept { return x.sender_id; }
  static std::int64_t count(const ControllerRequest& x) noexcept { return x.sequence; }
};
template <>
struct Wire<ModeRequest> : WireBase<450, true> {
  static std::int64_t sender(const ModeRequest& x) noexcept { return x.sender_id; }
  static std::int64_t count(const ModeRequest& x) noexcept { return x.sequence; }
};
template <>
struct Wire<WalkCommand> : WireBase<52, true> {
  static std::int64_t sender(const WalkCommand& x) noexcept { return x.sender_id; }
  static std::int64_t count(const WalkCommand& x) noexcept { return x.sequence; }
};
template <>
struct Wire<StepList> : WireBase<423, true> {
  static std::int64_t sender(const StepList& x) noexcept { return x.sender_id; }
  static std::int64_t count(const StepList& x) noexcept { return x.sequence; }
};
template <>
struct Wire<SimRequest> : WireBase<83, true> {
  static std::int64_t sender(const SimRequest& x) noexcept { return x.sender_id; }
  static std::int64_t count(const SimRequest& x) noexcept { return x.sequence; }
};
template <>
struct Wire<Gamepad> : WireBase<100, true> {
  static std::int64_t sender(const Gamepad& x) noexcept { return x.sender_id; }
  static std::int64_t count(const Gamepad& x) noexcept { return x.sequence; }
};
template <>
struct Wire<ArmGoal> : WireBase<498, true> {
  static std::int64_t sender(const ArmGoal& x) noexcept { return x.sender_id; }
  static std::int64_t count(const ArmGoal& x) noexcept { return x.sequence; }
};
template <>
struct Wire<ArmPathPiece> : WireBase<1003, false> {
  static std::int64_t sender(const ArmPathPiece& x) noexcept { return x.planner_id; }
};
template <>
struct Wire<GuardReport> : WireBase<266, true> {
  static std::int64_t sender(const GuardReport& x) noexcept { return x.guard_id; }
  static std::int64_t count(const GuardReport& x) noexcept { return x.tick; }
};
template <>
struct Wire<ControllerStatus> : WireBase<172, true> {
  static std::int64_t sender(const ControllerStatus& x) noexcept { return x.controller_id; }
  static std::int64_t count(const ControllerStatus& x) noexcept { return x.tick; }
};
template <>
struct Wire<SimTruth> : WireBase<487, true> {
  static std::int64_t sender(const SimTruth& x) noexcept { return x.run_id; }
  static std::int64_t count(const SimTruth& x) noexcept { return x.tick; }
};
template <>
struct Wire<Estimate> : WireBase<330, true> {
  static std::int64_t sender(const Estimate& x) noexcept { return x.run_id; }
  static std::int64_t count(const Estimate& x) noexcept { return x.tick; }
};
template <>
struct Wire<Heartbeat> : WireBase<428, false> {
  static std::int64_t sender(const Heartbeat& x) noexcept { return x.process_id; }
};
template <>
struct Wire<FullHeartbeat> : Wire<Heartbeat> {};
template <>
struct Wire<Gap> : WireBase<458, false> {
  static std::int64_t sender(const Gap& x) noexcept { return x.other_run_id; }
};
template <>
struct Wire<ObstaclesPiece> : WireBase<522, false> {
  static std::int64_t sender(const ObstaclesPiece& x) noexcept { return x.scene_id; }
};
template <>
struct Wire<ModelTextPiece> : WireBase<1343, false> {
  static std::int64_t sender(const ModelTextPiece& x) noexcept { return x.run_id; }
};
template <>
struct Wire<Event> : WireBase<248, true> {
  static std::int64_t sender(const Event& x) noexcept { return x.sender_id; }
  static std::int64_t count(const Event& x) noexcept { return x.sequence; }
};

template <>
struct Wire<JournalPage> : WireBase<524, true> {
  static std::int64_t sender(const JournalPage& x) noexcept { return x.process_id; }
  static std::int64_t count(const JournalPage& x) noexcept { return x.page; }
};

// Every channel with its type, for tools that take whatever comes (status, viewer, logs).
struct ChannelInfo {
  const char* channel;
  const char* type;                                         // "robot_state_t"
  int bytes;                                                // encoded size
  std::int64_t fingerprint;                                 // type hash, the first 8 encoded bytes
  Status (*check)(std::span<const std::uint8_t>) noexcept;  // decodes and forgets
};
std::span<const ChannelInfo> channel_table();
// Null for a channel that is not ours.  A name without its prefix.
const ChannelInfo* find_channel(const char* channel) noexcept;

}  // namespace twinbus
