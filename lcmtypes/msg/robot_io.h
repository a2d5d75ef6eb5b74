// What passes between a robot and whoever moves it: the state it can measure, the command it obeys.
//
// The same structs as the messages robot_state_t and joint_command_t, without the bus.  Arrays have the
// bus's fixed size; only the first joint_count entries mean anything, the rest is zero.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus {

inline constexpr int kMaxJoints = 48;  // actuated joints that fit in one Ethernet frame

enum class SourceKind : std::int8_t { kNone = 0, kSimulator = 1, kBridge = 2, kReplay = 3 };

// doc/protocol.md section 4.
enum class Role : std::int8_t {
  kNone = 0,
  kParked = 1,
  kActive = 2,
  kReleasing = 3,
  kStandbyTrack = 4,
  kStandbyShadow = 5,
  kStopped = 6
};

// Higher wins.  doc/protocol.md section 6.
enum class StopKind : std::int8_t { kNone = 0, kBalanced = 1, kHold = 2, kOff = 3 };

enum Limb : int { kLeftFoot = 0, kRightFoot = 1, kLeftHand = 2, kRightHand = 3, kLimbs = 4 };

enum class WrenchKind : std::int8_t { kAbsent = 0, kMeasured = 1, kEstimated = 2 };

// Bits of RobotState::sensor_flags.
inline constexpr std::int32_t kEncodersValid = 1 << 0;
inline constexpr std::int32_t kImuValid = 1 << 1;
inline constexpr std::int32_t wrench_valid(Limb limb) { return 1 << (2 + limb); }

template <class T>
using PerJoint = std::array<T, kMaxJoints>;

struct RobotState {
  std::int64_t tick = 0;
  std::int64_t time_ns = 0;         // advances by period_ns per tick, goes on across a switch
  std::int64_t source_time_ns = 0;  // the source's own clock
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int64_t grant_run_id = 0;  // 0, or the run that may take over
  std::int64_t grant_tick = 0;    // the first tick that run may publish
  std::int64_t enabled = 0;       // bit per joint: servo on
  std::int64_t plan_tick = 0;     // first tick at which a stop plan was followed instead of commands; 0 none is followed
  std::int32_t term = 0;
  std::int32_t period_ns = 0;
  std::int32_t stop_nonce = 0;
  std::int32_t plan_number = 0;  // of that plan; 0 none is followed
  std::int32_t sensor_flags = 0;
  std::int16_t joint_count = 0;
  SourceKind source = SourceKind::kNone;
  Role role = Role::kNone;
  StopKind stop_kind = StopKind::kNone;
  std::array<WrenchKind, kLimbs> wrench_kind{};
  PerJoint<double> q{};                       // [rad or m]
  PerJoint<float> qd{};                       // [rad/s or m/s]
  PerJoint<float> tau{};                      // [N m or N]
  std::array<float, 4> attitude{1, 0, 0, 0};  // w x y z, IMU link in world, heading arbitrary
  std::array<float, 3> gyro{};                // in the IMU frame [rad/s]
  std::array<float, 3> accel{};               // specific force in the IMU frame [m/s^2]
  std::array<std::array<float, 6>, kLimbs>
      wrench{};  // force [N], torque [N m] on the robot, sensor frame
};

// Bits of JointCommand::flags.
inline constexpr std::int16_t kCommandStopping = 1;
inline constexpr std::int16_t kCommandNoFade = 2;  // not faded in: begins where the set-point is

// torque = tau + kp (q - q_measured) + kd (qd - qd_measured)
struct JointCommand {
  std::int64_t tick = 0;  // the state tick it answers
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int64_t controller_id = 0;
  std::int32_t term = 0;
  std::int16_t joint_count = 0;
  std::int16_t flags = 0;
  PerJoint<double> q{};   // [rad or m]
  PerJoint<float> qd{};   // [rad/s or m/s]
  PerJoint<float> tau{};  // feed-forward [N m or N]
  PerJoint<float> kp{};   // [N m/rad or N/m]
  PerJoint<float> kd{};   // [N m s/rad or N s/m]
};

}  // namespace twinbus
