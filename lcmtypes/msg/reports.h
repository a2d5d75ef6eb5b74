// What processes say of themselves, of the robot and of the world: the structs behind the messages of the same name, without
// the bus.  Field comments and units: the .lcm file.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

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
  float faded_in = 0.0f;
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
