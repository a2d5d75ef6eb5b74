// One valid value of every struct that goes over the bus, with no number left at a special value by
// accident.

#pragma once

#include <cstddef>

#include "lcmtypes/msg/estimate.h"
#include "lcmtypes/msg/pieces.h"
#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/stop_plan.h"

namespace twinbus {

template <class T>
T sample();

template <class Array>
void count_up(Array& values, double first = 0.01, double step = 0.01) {
  double value = first;
  for (auto& x : values) {
    x = static_cast<std::remove_reference_t<decltype(x)>>(value);
    value += step;
  }
}
template <class Rows>
void count_up_rows(Rows& rows) {
  double first = 0.01;
  for (auto& row : rows) count_up(row, first += 0.1);
}
template <class Text>
void write(Text& text, const char* words) {
  for (std::size_t i = 0; words[i] != '\0' && i + 1 < text.size(); ++i) text[i] = words[i];
}

template <>
inline RobotState sample<RobotState>() {
  RobotState x{.tick = 1000,
               .time_ns = 2'000'000'000,
               .source_time_ns = 5,
               .run_id = 77,
               .model_hash = 4242,
               .grant_run_id = 78,
               .grant_tick = 1005,
               .enabled = 0x1fffffff,
               .plan_tick = 990,
               .term = 3,
               .period_ns = 2'000'000,
               .stop_nonce = 9,
               .plan_number = 12,
               .sensor_flags = 0x3f,
               .joint_count = kMaxJoints,
               .source = SourceKind::kSimulator,
               .role = Role::kActive};
  x.wrench_kind.fill(WrenchKind::kMeasured);
  count_up(x.q);
  count_up(x.qd);
  count_up(x.tau);
  x.attitude = {0.5f, 0.5f, -0.5f, 0.5f};
  count_up(x.gyro);
  count_up(x.accel);
  count_up_rows(x.wrench);
  return x;
}
template <>
inline JointCommand sample<JointCommand>() {
  JointCommand x{.tick = 1000,
                 .run_id = 77,
                 .model_hash = 4242,
                 .controller_id = 5,
                 .term = 3,
                 .joint_count = kMaxJoints,
                 .flags = 1};
  count_up(x.q);
  count_up(x.qd);
  count_up(x.tau);
  count_up(x.kp);
  count_up(x.kd);
  return x;
}
template <>
inline StopPlanPiece sample<StopPlanPiece>() {
  StopPlanPiece x;
  x.head = {.run_id = 77,
            .model_hash = 4242,
            .controller_id = 5,
            .tick = 1000,
            .joints = 0x1fffffff,
            .term = 3,
            .number = 12,
            .pieces = 6,
            .knot_count = 27,
            .spacing = 20,
            .joint_count = kMaxJoints,
            .walks = true,
            .omega = 3.6F,
            .mass = 130.0F,
            .sole_low = {-0.06F, -0.05F},
            .sole_high = {0.13F, 0.05F},
            .sole_zmp = {0.03F, 0.005F}};
  x.piece = 2;
  x.phase = {0, 1, 3, 1, 0};
  std::int16_t value = 1;
  for (auto* rows : {&x.q, &x.tau}) {
    for (PlanRow& row : *rows) {
      for (std::int16_t& number : row) number = value++;
    }
  }
  for (PlanBalanceRow& row : x.balance) {
    for (std::int16_t& number : row) number = value++;
  }
  return x;
}
template <>
inline StopRequest sample<StopRequest>() {
  return {.utime = 1,
          .sender_id = 2,
          .sequence = 3,
          .stop_nonce = -4,
          .kind = StopKind::kHold,
          .reason = StopReason::kOperator};
}
template <>
inline SourceRequest sample<SourceRequest>() {
  return {.utime = 1,
          .sender_id = 2,
          .run_id = 3,
          .target_run_id = 4,
          .sequence = 5,
          .action = SourceAction::kSwitch,
          .policy = SwitchPolicy::kWhenSafe,
          .align = true};
}
template <>
inline SourceStatus sample<SourceStatus>() {
  SourceStatus x;
  x.utime = 1;
  x.run_id = 2;
  x.period_ns = 2'000'000;
  x.source = SourceKind::kBridge;
  x.role = Role::kStandbyShadow;
  x.stop_kind = StopKind::kOff;
  x.stop_reason = StopReason::kDevice;
  x.pace = 1;
  x.hardware = true;
  x.refusal = Refusal::kStale;
  return x;
}
template <>
inline ControllerRequest sample<ControllerRequest>() {
  return {.utime = 1, .sender_id = 2, .run_id = 3, .controller_id = 4, .sequence = 5};
}
template <>
inline ModeRequest sample<ModeRequest>() {
  ModeRequest x{.utime = 1,
                .sender_id = 2,
                .run_id = 3,
                .at_tick = 4,
                .joint_mask = -1,
                .sequence = 5,
                .mode = Mode::kPose,
                .motion = Motion::kSway,
                .duration = 1.5f,
                .amplitude = 0.02f,
                .frequency = 0.5f};
  count_up(x.q);
  return x;
}
template <>
inline WalkCommand sample<WalkCommand>() {
  return {.utime = 1,
          .sender_id = 2,
          .run_id = 3,
          .sequence = 4,
          .vx = 0.3f,
          .vy = -0.1f,
          .wz = 0.2f,
          .timeout = 0.5f};
}
template <>
inline StepList sample<StepList>() {
  StepList x{.utime = 1, .sender_id = 2, .run_id = 3, .sequence = 4, .count = 32};
  x.first_foot = FootSide::kRight;
  count_up(x.x);
  count_up(x.y);
  count_up(x.yaw);
  return x;
}
template <>
inline SimRequest sample<SimRequest>() {
  SimRequest x{.utime = 1, .sender_id = 2, .run_id = 3, .model_hash = 4, .sequence = 5};
  x.ticks = 6;
  x.link = 7;
  x.action = SimAction::kPush;
  x.pace = 0.5f;
  x.duration = 0.1f;
  count_up(x.force);
  count_up(x.point);
  return x;
}
template <>
inline Gamepad sample<Gamepad>() {
  Gamepad x{.utime = 1,
            .sender_id = 2,
            .run_id = 3,
            .sequence = 4,
            .buttons = 0x201,
            .connected = true,
            .deadman = true,
            .stop = false,
            .keyboard = false,
            .left_x = 0.5f,
            .left_y = -0.5f,
            .right_x = 1.0f,
            .right_y = -1.0f,
            .left_trigger = 0.1f,
            .right_trigger = 0.9f};
  write(x.name, "pad");
  return x;
}
template <>
inline ArmGoal sample<ArmGoal>() {
  ArmGoal x{.utime = 1,
            .sender_id = 2,
            .run_id = 3,
            .goal_id = 4,
            .joint_mask = 0x1fc0,
            .sequence = 5,
            .side = ArmSide::kRight,
            .kind = ArmGoalKind::kPose,
            .position = {0.3, -0.2, 0.9},
            .orientation = {0.5, 0.5, 0.5, -0.5}};
  count_up(x.q);
  x.speed = 0.5f;
  return x;
}
template <>
inline ArmPathPiece sample<ArmPathPiece>() {
  ArmPathPiece x{.utime = 1,
                 .planner_id = 2,
                 .run_id = 3,
                 .goal_id = 4,
                 .path_id = 5,
                 .piece = 1,
                 .pieces = 3,
                 .joint_count = kArmJoints,
                 .knot_count = kKnotsPerPiece};
  for (std::size_t i = 0; i < x.joint.size(); ++i) x.joint[i] = static_cast<std::int16_t>(i + 6);
  x.miss = 0.1f;
  x.clearance = 0.2f;
  count_up(x.time);
  count_up_rows(x.q);
  count_up_rows(x.qd);
  return x;
}
template <>
inline GuardReport sample<GuardReport>() {
  GuardReport x{.tick = 1000,
                .run_id = 77,
                .guard_id = 8,
                .hold_mask = 0xff,
                .compute_ns = 90000,
                .pairs_checked = 300,
                .pairs_near = kGuardPairs,
                .verdict = GuardVerdict::kNear};
  count_up(x.distance);
  count_up(x.time_to_contact);
  count_up_rows(x.point_a);
  count_up_rows(x.point_b);
  return x;
}
template <>
inline ControllerStatus sample<ControllerStatus>() {
  ControllerStatus x{.tick = 1000, .run_id = 77, .controller_id = 5};
  x.mode = Mode::kBalance;
  x.motion = Motion::kSquat;
  count_up(x.com);
  count_up(x.com_velocity);
  count_up(x.com_reference);
  count_up(x.dcm);
  count_up(x.zmp);
  count_up(x.zmp_reference);
  x.zmp_margin = 0.04f;
  count_up(x.base_position);
  x.base_attitude = {0.5f, 0.5f, -0.5f, 0.5f};
  count_up(x.base_velocity);
  return x;
}
template <>
inline SimTruth sample<SimTruth>() {
  SimTruth x{.tick = 1000, .run_id = 77, .sim_time = 2.0};
  count_up(x.base_position);
  x.base_attitude = {0.5, 0.5, -0.5, 0.5};
  count_up(x.base_velocity);
  count_up(x.base_angular_velocity);
  count_up(x.com);
  count_up(x.com_velocity);
  count_up(x.zmp);
  x.zmp_margin = 0.03f;
  count_up_rows(x.foot_position);
  count_up_rows(x.foot_attitude);
  count_up_rows(x.foot_force);
  count_up(x.foot_slip);
  x.penetration = 1e-4f;
  count_up(x.push_force);
  count_up(x.push_point);
  count_up_rows(x.contact_point);
  count_up_rows(x.contact_force);
  x.realtime_factor = 1.0f;
  x.contact_count = 8;
  return x;
}
template <>
inline Estimate sample<Estimate>() {
  Estimate x{.tick = 1000, .run_id = 77};
  count_up(x.base_position);
  x.base_attitude = {0.5, 0.5, -0.5, 0.5};
  double first = 0.1;
  for (auto* vector : {&x.base_velocity, &x.base_angular_velocity, &x.velocity_in_base, &x.angular_velocity_in_base, &x.imu_velocity,
                       &x.position_deviation, &x.attitude_deviation, &x.velocity_deviation, &x.angular_velocity_deviation}) {
    count_up(*vector, first += 0.1);
  }
  count_up(x.foot_load);
  count_up(x.foot_certainty);
  count_up_rows(x.foot_position);
  x.foot_joint = {5, 11, 17, 23, 29, 35};
  x.foot_count = kMaxFeet;
  x.foot_stands.fill(true);
  x.load_from = LoadFrom::kTorques;
  x.velocity_from = VelocityFrom::kFeetAndAccelerometer;
  return x;
}
template <>
inline Heartbeat sample<Heartbeat>() {
  Heartbeat x{.utime = 1, .process_id = 5, .messages_received = 10, .messages_rejected = 1};
  x.pid = 4321;
  x.rate = 500.0f;
  x.age_us = 45.0f;
  x.age_p99_us = 90.0f;
  x.ticks_stalled = 2;
  x.timer_missed = 3;
  x.tick_median_us = 20.0f;
  x.tick_p99_us = 60.0f;
  x.tick_max_us = 100.0f;
  x.wake_p99_us = 30.0f;
  x.kind = ProcessKind::kController;
  x.realtime = 2;
  x.state = 2;
  return x;
}
template <>
inline Gap sample<Gap>() {
  Gap x{.utime = 1, .run_id = 77, .other_run_id = 78, .tick = 1000, .joint_count = kMaxJoints};
  count_up(x.q);
  count_up(x.tau);
  count_up_rows(x.foot_force);
  count_up(x.tilt);
  return x;
}
template <>
inline ObstaclesPiece sample<ObstaclesPiece>() {
  ObstaclesPiece x{.utime = 1, .scene_id = 2, .piece = 0, .pieces = 1, .count = kObstaclesPerPiece};
  x.shape.fill(ObstacleShape::kBox);
  count_up_rows(x.size);
  count_up_rows(x.position);
  for (auto& attitude : x.attitude) attitude = {0.5f, 0.5f, -0.5f, 0.5f};
  return x;
}
template <>
inline ModelTextPiece sample<ModelTextPiece>() {
  ModelTextPiece x{.utime = 1,
                   .run_id = 77,
                   .model_hash = 4242,
                   .size = 7,
                   .piece = 0,
                   .pieces = 1,
                   .count = 7,
                   .kind = 1};
  write(x.text, "<robot>");
  return x;
}
template <>
inline Event sample<Event>() {
  Event x{.utime = 1,
          .sender_id = 2,
          .run_id = 3,
          .tick = 4,
          .sequence = 5,
          .code = 6,
          .severity = 1,
          .kind = ProcessKind::kBridge};
  write(x.text, "switch refused: posture differs");
  return x;
}

template <>
inline JournalPage sample<JournalPage>() {
  JournalPage x{.process_id = 5, .page = 3, .step = 2, .run_id = 77, .tick = 1000, .now_ns = 99};
  x.state_hash = -5;
  x.answer_hash = 6;
  x.report_hash = 7;
  x.input_hash.fill(-8);
  x.input_ns.fill(9);
  x.setting = {4.0, 1.0, 0.5, 0.25};
  x.inputs = 24;
  x.kind = ProcessKind::kController;
  x.whole = true;
  x.input.fill(JournalInput::kGuard);
  return x;
}

// Calls f.template operator()<T>() for every struct that goes over the bus.
template <class F>
void for_every_type(F&& f) {
  f.template operator()<RobotState>();
  f.template operator()<JointCommand>();
  f.template operator()<StopPlanPiece>();
  f.template operator()<StopRequest>();
  f.template operator()<SourceRequest>();
  f.template operator()<SourceStatus>();
  f.template operator()<ControllerRequest>();
  f.template operator()<ModeRequest>();
  f.template operator()<WalkCommand>();
  f.template operator()<StepList>();
  f.template operator()<SimRequest>();
  f.template operator()<Gamepad>();
  f.template operator()<ArmGoal>();
  f.template operator()<ArmPathPiece>();
  f.template operator()<GuardReport>();
  f.template operator()<ControllerStatus>();
  f.template operator()<SimTruth>();
  f.template operator()<Estimate>();
  f.template operator()<Heartbeat>();
  f.template operator()<Gap>();
  f.template operator()<ObstaclesPiece>();
  f.template operator()<ModelTextPiece>();
  f.template operator()<Event>();
  f.template operator()<JournalPage>();
}

}  // namespace twinbus
