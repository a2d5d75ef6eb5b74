// What operators, planners and guards say, without the bus: the structs behind the messages of the same
// name.  Field comments and units: the .lcm file.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

enum class StopReason : std::int8_t {
  kNone = 0,
  kOperator = 1,
  kGamepad = 2,
  kViewer = 3,
  kGuard = 4,
  kLauncher = 5,
  kController = 6,
  kCommandTimeout = 7,  // drawn by the gate itself
  kDevice = 8,          // the adaptor failed
  kSwitch =
      9,  // the active source asks the controller to come to rest before a switch; gates do not latch it
};

struct StopRequest {  // stop_t; kind kNone asks to clear
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int32_t sequence = 0;
  std::int32_t stop_nonce = 0;
  StopKind kind = StopKind::kNone;
  StopReason reason = StopReason::kNone;
};

enum class SourceAction : std::int8_t {
  kNone = 0,
  kActivate = 1,
  kSwitch = 2,
  kStandbyTrack = 3,
  kStandbyShadow = 4,
  kPark = 5
};

enum class SwitchPolicy : std::int8_t { kNone = 0, kNow = 1, kWhenSafe = 2 };

struct SourceRequest {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t target_run_id = 0;
  std::int32_t sequence = 0;
  SourceAction action = SourceAction::kNone;
  SwitchPolicy policy = SwitchPolicy::kNone;
  bool align = false;
};

// Why a request was refused; each has its own sentence (refusal_text).
enum class Refusal : std::int8_t {
  kNone = 0,
  kNotAddressed = 1,   // run_id is not the active source
  kUnknownTarget = 2,  // the target is not heard on its own channel
  kModelHash = 3,
  kPeriod = 4,
  kStale = 5,  // either side is older than the state timeout
  kStopped = 6,
  kPosture = 7,    // a joint differs by more than 0.05 rad
  kVelocity = 8,   // a joint differs by more than 0.5 rad/s
  kAttitude = 9,   // roll or pitch differs by more than 0.05 rad
  kGyro = 10,      // angular velocity differs by more than 0.3 rad/s
  kFeet = 11,      // not the same feet loaded
  kLoad = 12,      // total foot force differs by more than 20 %
  kUnstable = 13,  // a real robot would be left while not statically stable
  kBusy = 14,      // a switch is already under way, or came too soon after the last
  kAlreadyActive = 15,
  kAnotherActive = 16,  // activation while a source is active
  kPace = 17,           // leaving lock-step towards hardware
  kCannotBeSet = 18,    // track asked of an adaptor without set_state
  kNotStandby = 19,     // the target is neither set-able nor in standby
  kDevice = 20,         // the adaptor of the target reports an error
};

// A sentence that says what is wrong and what to do; never null.
const char* refusal_text(Refusal refusal) noexcept;

struct SourceStatus {
  std::int64_t utime = 0;
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int64_t tick = 0;
  std::int64_t controller_id = 0;
  std::int64_t successor_run_id = 0;
  std::int64_t commands_accepted = 0;
  std::int64_t commands_rejected = 0;
  std::int64_t commands_late = 0;
  std::int64_t clamped = 0;
  std::int64_t ticks_missed = 0;
  std::int64_t plans_accepted = 0, plans_refused = 0, plans_followed = 0;
  std::int64_t terms_ignored = 0;
  std::int32_t term = 0;
  std::int32_t period_ns = 0;
  std::int32_t stop_nonce = 0;
  std::int32_t refusal_sequence = 0;
  SourceKind source = SourceKind::kNone;
  Role role = Role::kNone;
  StopKind stop_kind = StopKind::kNone;
  StopReason stop_reason = StopReason::kNone;
  std::int8_t adaptor_status = 0;
  std::int8_t pace = 0;
  bool can_be_set = false;
  bool hardware = false;
  std::int8_t plan_refusal = 0;  // robot/stop_plan/plan_assembler.h
  Refusal refusal = Refusal::kNone;
};

struct ControllerRequest {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t controller_id = 0;
  std::int32_t sequence = 0;
};

enum class Mode : std::int8_t {
  kNone = 0,
  kIdle = 1,
  kHold = 2,
  kPose = 3,
  kBalance = 4,
  kWalk = 5,
  kStop = 6
};
enum class Motion : std::int8_t { kNone = 0, kSway = 1, kSquat = 2 };

struct ModeRequest {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t at_tick = 0;
  std::int64_t joint_mask = 0;
  std::int32_t sequence = 0;
  Mode mode = Mode::kNone;
  Motion motion = Motion::kNone;
  float duration = 0;
  float amplitude = 0;
  float frequency = 0;
  PerJoint<double> q{};
};

struct WalkCommand {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int32_t sequence = 0;
  float vx = 0;
  float vy = 0;
  float wz = 0;
  float timeout = 0;
};

struct Gamepad {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int32_t sequence = 0;
  std::int32_t buttons = 0;
  bool connected = false;
  bool deadman = false;
  bool stop = false;
  bool keyboard = false;
  float left_x = 0;
  float left_y = 0;
  float right_x = 0;
  float right_y = 0;
  float left_trigger = 0;
  float right_trigger = 0;
  std::array<char, 32> name{};
};

enum class ArmSide : std::int8_t { kNone = 0, kLeft = 1, kRight = 2 };
enum class ArmGoalKind : std::int8_t { kCancel = 0, kJoints = 1, kPosition = 2, kPose = 3 };

struct ArmGoal {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t goal_id = 0;
  std::int64_t joint_mask = 0;
  std::int32_t sequence = 0;
  ArmSide side = ArmSide::kNone;
  ArmGoalKind kind = ArmGoalKind::kCancel;
  std::array<double, 3> position{};
  std::array<double, 4> orientation{1, 0, 0, 0};
  PerJoint<double> q{};
  float speed = 1;
};

enum class ArmPathStatus : std::int8_t {
  kOk = 0,
  kUnreachable = 1,
  kStartInCollision = 2,
  kGoalInCollision = 3,
  kTimeLimit = 4,
  kCancelled = 5,
  kBadGoal = 6,
};

inline constexpr int kArmJoints = 12;     // columns of a path
inline constexpr int kKnotsPerPiece = 6;  // rows of one message

struct ArmPathPiece {  // arm_path_t
  std::int64_t utime = 0;
  std::int64_t planner_id = 0;
  std::int64_t run_id = 0;
  std::int64_t goal_id = 0;
  std::int64_t path_id = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t joint_count = 0;
  std::int16_t knot_count = 0;
  std::array<std::int16_t, kArmJoints> joint{};
  ArmPathStatus status = ArmPathStatus::kOk;
  std::int8_t link_a = 0;
  std::int8_t link_b = 0;
  float miss = 0;
  float clearance = 0;
  std::array<double, kKnotsPerPiece> time{};
  std::array<std::array<double, kArmJoints>, kKnotsPerPiece> q{};
  std::array<std::array<float, kArmJoints>, kKnotsPerPiece> qd{};
};

enum class GuardVerdict : std::int8_t { kClear = 0, kNear = 1, kWillCollide = 2, kInCollision = 3 };
inline constexpr int kGuardPairs = 6;

struct GuardReport {
  std::int64_t tick = 0;
  std::int64_t run_id = 0;
  std::int64_t guard_id = 0;
  std::int64_t hold_mask = 0;
  std::int32_t compute_ns = 0;
  std::int16_t pairs_checked = 0;
  std::int16_t pairs_near = 0;
  GuardVerdict verdict = GuardVerdict::kClear;
  bool stop_asked = false;
  std::array<std::int16_t, kGuardPairs> link_a{};
  std::array<std::int16_t, kGuardPairs> link_b{};
  std::array<float, kGuardPairs> distance{};
  std::array<float, kGuardPairs> time_to_contact{};
  std::array<std::array<float, 3>, kGuardPairs> point_a{};
  std::array<std::array<float, 3>, kGuardPairs> point_b{};
};

struct ControllerStatus {
  std::int64_t tick = 0;
  std::int64_t run_id = 0;
  std::int64_t controller_id = 0;
  std::int64_t guard_tick = 0;
  std::int64_t arm_path_id = 0;
  std::int32_t term = 0;
  std::int32_t mode_sequence = 0;
  std::int32_t walk_sequence = 0;
  std::int32_t compute_ns = 0;
  Mode mode = Mode::kNone;
  Motion motion = Motion::kNone;
  StopKind stopping = StopKind::kNone;
  std::int8_t arm_state = 0;
  std::array<float, 3> com{};
  std::array<float, 3> com_velocity{};
  std::array<float, 3> com_reference{};
  std::array<float, 2> dcm{};
  std::array<float, 2> zmp{};
  std::array<float, 2> zmp_reference{};
  float zmp_margin = 0;
  std::array<float, 3> base_position{};
  std::array<float, 4> base_attitude{1, 0, 0, 0};
  std::array<float, 3> base_velocity{};
};

struct SimTruth {
  std::int64_t tick = 0;
  std::int64_t run_id = 0;
  double sim_time = 0;
  std::array<double, 3> base_position{};
  std::array<double, 4> base_attitude{1, 0, 0, 0};
  std::array<double, 3> base_velocity{};
  std::array<double, 3> base_angular_velocity{};
  std::array<float, 3> com{};
  std::array<float, 3> com_velocity{};
  std::array<float, 2> zmp{};
  float zmp_margin = 0;
  std::array<std::array<float, 3>, 2> foot_position{};
  std::array<std::array<float, 4>, 2> foot_attitude{};
  std::array<std::array<float, 3>, 2> foot_force{};
  std::array<float, 2> foot_slip{};
  float penetration = 0;
  std::array<float, 3> push_force{};
  std::array<float, 3> push_point{};
  std::array<std::array<float, 3>, 8> contact_point{};
  std::array<std::array<float, 3>, 8> contact_force{};
  float realtime_factor = 0;
  std::int16_t contact_count = 0;
  bool fell = false;
};

enum class ProcessKind : std::int8_t {
  kNone = 0,
  kSimulator = 1,
  kBridge = 2,
  kReplay = 3,
  kController = 4,
  kGuard = 5,
  kPlanner = 6,
  kViewer = 7,
  kGamepad = 8,
  kLog = 9,
  kLauncher = 10,
  kUser = 11
};

struct Heartbeat {
  std::int64_t utime = 0;
  std::int64_t process_id = 0;
  std::int64_t messages_received = 0;
  std::int64_t messages_rejected = 0;
  std::int64_t messages_lost = 0;
  std::int64_t ticks = 0;
  std::int64_t ticks_missed = 0;
  std::int64_t ticks_stalled = 0;
  std::int64_t timer_missed = -1;
  std::int64_t allocations = -1;
  std::int32_t pid = 0;
  std::int32_t send_failures = 0;
  float rate = 0;
  float age_us = 0;
  float age_p99_us = 0;
  float tick_median_us = 0;
  float tick_p99_us = 0;
  float tick_max_us = 0;
  float wake_p99_us = 0;
  ProcessKind kind = ProcessKind::kNone;
  std::int8_t realtime = 0;
  std::int8_t state = 0;
};

struct Gap {
  std::int64_t utime = 0;
  std::int64_t run_id = 0;
  std::int64_t other_run_id = 0;
  std::int64_t tick = 0;
  std::int16_t joint_count = 0;
  PerJoint<float> q{};
  PerJoint<float> tau{};
  std::array<std::array<float, 3>, 2> foot_force{};
  std::array<float, 2> tilt{};
};

inline constexpr int kObstaclesPerPiece = 12;
enum class ObstacleShape : std::int8_t { kNone = 0, kBox = 1, kSphere = 2, kCylinder = 3 };

struct ObstaclesPiece {
  std::int64_t utime = 0;
  std::int64_t scene_id = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t count = 0;
  std::array<ObstacleShape, kObstaclesPerPiece> shape{};
  std::array<std::array<float, 3>, kObstaclesPerPiece> size{};
  std::array<std::array<float, 3>, kObstaclesPerPiece> position{};
  std::array<std::array<float, 4>, kObstaclesPerPiece> attitude{};
};

inline constexpr int kModelTextBytes = 1300;

struct ModelTextPiece {
  std::int64_t utime = 0;
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int32_t size = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t count = 0;
  std::int8_t kind = 0;
  std::array<char, kModelTextBytes> text{};
};

struct Event {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t tick = 0;
  std::int32_t sequence = 0;
  std::int16_t code = 0;
  std::int8_t severity = 0;
  ProcessKind kind = ProcessKind::kNone;
  std::array<char, 200> text{};
};

}  // namespace twinbus
