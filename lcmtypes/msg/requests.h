// What operators and programs ask for: the structs behind the messages of the same name, without the bus.  Field comments
// and units: the .lcm file.

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
  kSwitch = 9,   // the active source wants rest before a switch; gates do not latch it
  kFallen = 10,  // the source itself saw its robot fall
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
enum class Motion : std::int8_t { kNone = 0, kSway = 1, kSquat = 2, kPlayed = 3 };

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

}  // namespace twinbus
