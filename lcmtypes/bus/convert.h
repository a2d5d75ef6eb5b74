// Generated messages <-> structs of robot/, with every check of an input in this one place.
//
// Refused whole: a number that is NaN, infinite or beyond 1e12; a count outside its array; an
// enumeration outside its list; an identifier outside 0 .. 2^53 - 1; a quaternion that is no
// rotation; a text without its end.  Entries beyond joint_count come out as zero.  Code behind this
// trusts its input, and still knows nothing of limits: those are the command gate's.

#pragma once

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
#include "twinbus/arm_goal_t.hpp"
#include "twinbus/arm_path_t.hpp"
#include "twinbus/controller_request_t.hpp"
#include "twinbus/controller_status_t.hpp"
#include "twinbus/estimate_t.hpp"
#include "twinbus/event_t.hpp"
#include "twinbus/gamepad_t.hpp"
#include "twinbus/gap_t.hpp"
#include "twinbus/guard_report_t.hpp"
#include "twinbus/heartbeat_t.hpp"
#include "twinbus/joint_command_t.hpp"
#include "twinbus/journal_t.hpp"
#include "twinbus/mode_request_t.hpp"
#include "twinbus/model_text_t.hpp"
#include "twinbus/obstacles_t.hpp"
#include "twinbus/robot_state_t.hpp"
#include "twinbus/sim_truth_t.hpp"
#include "twinbus/source_request_t.hpp"
#include "twinbus/source_status_t.hpp"
#include "twinbus/sim_request_t.hpp"
#include "twinbus/step_list_t.hpp"
#include "twinbus/stop_plan_t.hpp"
#include "twinbus/stop_t.hpp"
#include "twinbus/walk_command_t.hpp"

namespace twinbus {

template <class T>
struct MessageOf;
template <>
struct MessageOf<RobotState> {
  using type = robot_state_t;
};
template <>
struct MessageOf<JointCommand> {
  using type = joint_command_t;
};
template <>
struct MessageOf<StopPlanPiece> {
  using type = stop_plan_t;
};
template <>
struct MessageOf<StopRequest> {
  using type = stop_t;
};
template <>
struct MessageOf<SourceRequest> {
  using type = source_request_t;
};
template <>
struct MessageOf<SourceStatus> {
  using type = source_status_t;
};
template <>
struct MessageOf<ControllerRequest> {
  using type = controller_request_t;
};
template <>
struct MessageOf<ModeRequest> {
  using type = mode_request_t;
};
template <>
struct MessageOf<WalkCommand> {
  using type = walk_command_t;
};
template <>
struct MessageOf<StepList> {
  using type = step_list_t;
};
template <>
struct MessageOf<SimRequest> {
  using type = sim_request_t;
};
template <>
struct MessageOf<Gamepad> {
  using type = gamepad_t;
};
template <>
struct MessageOf<ArmGoal> {
  using type = arm_goal_t;
};
template <>
struct MessageOf<ArmPathPiece> {
  using type = arm_path_t;
};
template <>
struct MessageOf<GuardReport> {
  using type = guard_report_t;
};
template <>
struct MessageOf<ControllerStatus> {
  using type = controller_status_t;
};
template <>
struct MessageOf<SimTruth> {
  using type = sim_truth_t;
};
template <>
struct MessageOf<Estimate> {
  using type = estimate_t;
};
template <>
struct MessageOf<FullHeartbeat> {
  using type = heartbeat_t;
};
template <>
struct MessageOf<Heartbeat> {
  using type = heartbeat_t;
};
template <>
struct MessageOf<Gap> {
  using type = gap_t;
};
template <>
struct MessageOf<ObstaclesPiece> {
  using type = obstacles_t;
};
template <>
struct MessageOf<ModelTextPiece> {
  using type = model_text_t;
};
template <>
struct MessageOf<Event> {
  using type = event_t;
};
template <>
struct MessageOf<JournalPage> {
  using type = journal_t;
};

template <class T>
using Message = typename MessageOf<T>::type;

// Both directions check; the output is complete only when kOk comes back.
template <class T>
Status to_message(const T& value, Message<T>& message) noexcept;
template <class T>
Status from_message(const Message<T>& message, T& value) noexcept;

template <>
Status to_message<StopPlanPiece>(const StopPlanPiece& value, stop_plan_t& message) noexcept;
template <>
Status from_message<StopPlanPiece>(const stop_plan_t& message, StopPlanPiece& value) noexcept;
template <>
Status to_message<Estimate>(const Estimate& value, estimate_t& message) noexcept;
template <>
Status from_message<Estimate>(const estimate_t& message, Estimate& value) noexcept;

}  // namespace twinbus
