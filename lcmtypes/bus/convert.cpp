#include "lcmtypes/bus/convert.h"

#include <cstdint>

#include "lcmtypes/bus/field_copier.h"

namespace twinbus {

namespace {
// One list of fields per message serves both directions.

template <class C, class M, Is<RobotState> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.instant(m.time_ns, s.time_ns);
  c.instant(m.source_time_ns, s.source_time_ns);
  c.id(m.run_id, s.run_id);
  c.id(m.model_hash, s.model_hash);
  c.id(m.grant_run_id, s.grant_run_id);
  c.id(m.grant_tick, s.grant_tick);
  c(m.enabled, s.enabled);
  c.id(m.plan_tick, s.plan_tick);
  c.counter(m.term, s.term);
  c.within(m.period_ns, s.period_ns, 1, 1'000'000'000);
  c(m.stop_nonce, s.stop_nonce);
  c.counter(m.plan_number, s.plan_number);
  c(m.sensor_flags, s.sensor_flags);
  c.joint_count(m.joint_count, s.joint_count);
  c(m.source, s.source);
  c(m.role, s.role);
  c(m.stop_kind, s.stop_kind);
  c(m.wrench_kind, s.wrench_kind);
  c.per_joint(m.q, s.q, s.joint_count);
  c.per_joint(m.qd, s.qd, s.joint_count);
  c.per_joint(m.tau, s.tau, s.joint_count);
  c.rotation(m.attitude, s.attitude, (s.sensor_flags & kImuValid) != 0);
  c(m.gyro, s.gyro);
  c(m.accel, s.accel);
  c(m.wrench, s.wrench);
}

template <class C, class M, Is<JointCommand> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.id(m.run_id, s.run_id);
  c.id(m.model_hash, s.model_hash);
  c.id(m.controller_id, s.controller_id);
  c.counter(m.term, s.term);
  c.joint_count(m.joint_count, s.joint_count);
  c(m.flags, s.flags);
  c.per_joint(m.q, s.q, s.joint_count);
  c.per_joint(m.qd, s.qd, s.joint_count);
  c.per_joint(m.tau, s.tau, s.joint_count);
  c.per_joint(m.kp, s.kp, s.joint_count);
  c.per_joint(m.kd, s.kd, s.joint_count);
  for (std::size_t i = 0; i < s.kp.size(); ++i) c.require(s.kp[i] >= 0 && s.kd[i] >= 0);
}

template <class C, class M, Is<StopRequest> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.counter(m.sequence, s.sequence);
  c(m.stop_nonce, s.stop_nonce);
  c(m.kind, s.kind);
  c(m.reason, s.reason);
}

template <class C, class M, Is<SourceRequest> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.target_run_id, s.target_run_id);
  c.counter(m.sequence, s.sequence);
  c(m.action, s.action);
  c(m.policy, s.policy);
  c(m.align, s.align);
}

template <class C, class M, Is<SourceStatus> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.run_id, s.run_id);
  c.id(m.model_hash, s.model_hash);
  c.id(m.tick, s.tick);
  c.id(m.controller_id, s.controller_id);
  c.id(m.successor_run_id, s.successor_run_id);
  c.id(m.commands_accepted, s.commands_accepted);
  c.id(m.commands_rejected, s.commands_rejected);
  c.id(m.commands_late, s.commands_late);
  c.id(m.clamped, s.clamped);
  c.id(m.ticks_missed, s.ticks_missed);
  c.id(m.plans_accepted, s.plans_accepted);
  c.id(m.plans_refused, s.plans_refused);
  c.id(m.plans_followed, s.plans_followed);
  c.id(m.terms_ignored, s.terms_ignored);
  c.counter(m.term, s.term);
  c.within(m.period_ns, s.period_ns, 0, 1'000'000'000);
  c(m.stop_nonce, s.stop_nonce);
  c.counter(m.refusal_sequence, s.refusal_sequence);
  c.within(m.faded_in, s.faded_in, 0.0f, 1.0f);
  c(m.source, s.source);
  c(m.role, s.role);
  c(m.stop_kind, s.stop_kind);
  c(m.stop_reason, s.stop_reason);
  c.within(m.adaptor_status, s.adaptor_status, 0, 127);
  c.within(m.pace, s.pace, 0, 6);
  c(m.can_be_set, s.can_be_set);
  c(m.hardware, s.hardware);
  c.within(m.plan_refusal, s.plan_refusal, 0, 127);
  c(m.refusal, s.refusal);
}

template <class C, class M, Is<ControllerRequest> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.controller_id, s.controller_id);
  c.counter(m.sequence, s.sequence);
}

template <class C, class M, Is<ModeRequest> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.at_tick, s.at_tick);
  c(m.joint_mask, s.joint_mask);
  c.counter(m.sequence, s.sequence);
  c(m.mode, s.mode);
  c(m.motion, s.motion);
  c.within(m.duration, s.duration, 0.0f, 1e6f);
  c.within(m.amplitude, s.amplitude, 0.0f, 1e6f);
  c.within(m.frequency, s.frequency, 0.0f, 1e6f);
  c(m.q, s.q);
}

template <class C, class M, Is<WalkCommand> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.counter(m.sequence, s.sequence);
  c(m.vx, s.vx);
  c(m.vy, s.vy);
  c(m.wz, s.wz);
  c.within(m.timeout, s.timeout, 0.0f, 1e6f);
}

template <class C, class M, Is<StepList> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.counter(m.sequence, s.sequence);
  c.count(m.count, s.count, kMostSteps);
  c(m.first_foot, s.first_foot);
  c(m.x, s.x);
  c(m.y, s.y);
  c(m.yaw, s.yaw);
}

template <class C, class M, Is<SimRequest> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.model_hash, s.model_hash);
  c.counter(m.sequence, s.sequence);
  c(m.ticks, s.ticks);
  c(m.link, s.link);
  c(m.action, s.action);
  c(m.pace, s.pace);
  c(m.duration, s.duration);
  c(m.force, s.force);
  c(m.point, s.point);
}

template <class C, class M, Is<Gamepad> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.counter(m.sequence, s.sequence);
  c(m.buttons, s.buttons);
  c(m.connected, s.connected);
  c(m.deadman, s.deadman);
  c(m.stop, s.stop);
  c(m.keyboard, s.keyboard);
  c.within(m.left_x, s.left_x, -1.01f, 1.01f);
  c.within(m.left_y, s.left_y, -1.01f, 1.01f);
  c.within(m.right_x, s.right_x, -1.01f, 1.01f);
  c.within(m.right_y, s.right_y, -1.01f, 1.01f);
  c.within(m.left_trigger, s.left_trigger, -0.01f, 1.01f);
  c.within(m.right_trigger, s.right_trigger, -0.01f, 1.01f);
  c.text(m.name, s.name);
}

template <class C, class M, Is<ArmGoal> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.goal_id, s.goal_id);
  c(m.joint_mask, s.joint_mask);
  c.counter(m.sequence, s.sequence);
  c(m.side, s.side);
  c(m.kind, s.kind);
  c(m.position, s.position);
  c.rotation(m.orientation, s.orientation, s.kind == ArmGoalKind::kPose);
  c(m.q, s.q);
  c.within(m.speed, s.speed, 0.0f, 1.01f);
}

template <class C, class M, Is<ArmPathPiece> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.planner_id, s.planner_id);
  c.id(m.run_id, s.run_id);
  c.id(m.goal_id, s.goal_id);
  c.id(m.path_id, s.path_id);
  c.pieces(m, s);
  c.count(m.joint_count, s.joint_count, kArmJoints);
  c.count(m.knot_count, s.knot_count, kKnotsPerPiece);
  c(m.joint, s.joint);
  for (const std::int16_t joint : s.joint) c.require(joint >= -1 && joint < kMaxJoints);
  for (int i = 0; i < s.joint_count && i < kArmJoints; ++i) {
    c.require(s.joint[static_cast<std::size_t>(i)] >= 0);
  }
  c(m.status, s.status);
  c(m.link_a, s.link_a);
  c(m.link_b, s.link_b);
  c(m.miss, s.miss);
  c(m.clearance, s.clearance);
  c(m.time, s.time);
  double before = 0;
  for (int i = 0; i < s.knot_count && i < kKnotsPerPiece; ++i) {
    const double time = s.time[static_cast<std::size_t>(i)];
    c.require(time >= before);
    before = time;
  }
  c(m.q, s.q);
  c(m.qd, s.qd);
}

template <class C, class M, Is<GuardReport> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.id(m.run_id, s.run_id);
  c.id(m.guard_id, s.guard_id);
  c(m.hold_mask, s.hold_mask);
  c(m.compute_ns, s.compute_ns);
  c.count(m.pairs_checked, s.pairs_checked, 32767);
  c.count(m.pairs_near, s.pairs_near, kGuardPairs);
  c(m.verdict, s.verdict);
  c(m.stop_asked, s.stop_asked);
  c(m.link_a, s.link_a);
  c(m.link_b, s.link_b);
  c(m.distance, s.distance);
  c(m.time_to_contact, s.time_to_contact);
  c(m.point_a, s.point_a);
  c(m.point_b, s.point_b);
}

template <class C, class M, Is<ControllerStatus> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.id(m.run_id, s.run_id);
  c.id(m.controller_id, s.controller_id);
  c.id(m.guard_tick, s.guard_tick);
  c.id(m.arm_path_id, s.arm_path_id);
  c.counter(m.term, s.term);
  c.counter(m.mode_sequence, s.mode_sequence);
  c.counter(m.walk_sequence, s.walk_sequence);
  c(m.compute_ns, s.compute_ns);
  c(m.mode, s.mode);
  c(m.motion, s.motion);
  c(m.stopping, s.stopping);
  c.within(m.arm_state, s.arm_state, 0, 3);
  c(m.com, s.com);
  c(m.com_velocity, s.com_velocity);
  c(m.com_reference, s.com_reference);
  c(m.dcm, s.dcm);
  c(m.zmp, s.zmp);
  c(m.zmp_reference, s.zmp_reference);
  c(m.zmp_margin, s.zmp_margin);
  c(m.base_position, s.base_position);
  c.rotation(m.base_attitude, s.base_attitude, true);
  c(m.base_velocity, s.base_velocity);
}

template <class C, class M, Is<SimTruth> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.id(m.run_id, s.run_id);
  c(m.sim_time, s.sim_time);
  c(m.base_position, s.base_position);
  c.rotation(m.base_attitude, s.base_attitude, true);
  c(m.base_velocity, s.base_velocity);
  c(m.base_angular_velocity, s.base_angular_velocity);
  c(m.com, s.com);
  c(m.com_velocity, s.com_velocity);
  c(m.zmp, s.zmp);
  c(m.zmp_margin, s.zmp_margin);
  c(m.foot_position, s.foot_position);
  c(m.foot_attitude, s.foot_attitude);
  c(m.foot_force, s.foot_force);
  c(m.foot_slip, s.foot_slip);
  c(m.penetration, s.penetration);
  c(m.push_force, s.push_force);
  c(m.push_point, s.push_point);
  c(m.contact_point, s.contact_point);
  c(m.contact_force, s.contact_force);
  c(m.realtime_factor, s.realtime_factor);
  c.count(m.contact_count, s.contact_count, 8);
  c(m.fell, s.fell);
}

template <class C, class M, Is<Heartbeat> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.process_id, s.process_id);
  c.id(m.messages_received, s.messages_received);
  c.id(m.messages_rejected, s.messages_rejected);
  c.id(m.messages_lost, s.messages_lost);
  c.id(m.ticks, s.ticks);
  c.id(m.ticks_missed, s.ticks_missed);
  c.id(m.ticks_stalled, s.ticks_stalled);
  c.within(m.timer_missed, s.timer_missed, std::int64_t{-1}, kIds - 1);
  c.within(m.allocations, s.allocations, std::int64_t{-1}, kIds - 1);
  c.within(m.pid, s.pid, 0, 0x7fffffff);
  c.within(m.send_failures, s.send_failures, 0, 0x7fffffff);
  c(m.rate, s.rate);
  c(m.age_us, s.age_us);
  c(m.age_p99_us, s.age_p99_us);
  c(m.tick_median_us, s.tick_median_us);
  c(m.tick_p99_us, s.tick_p99_us);
  c(m.tick_max_us, s.tick_max_us);
  c(m.wake_p99_us, s.wake_p99_us);
  c(m.kind, s.kind);
  c.within(m.realtime, s.realtime, 0, 2);
  c.within(m.state, s.state, 0, 3);
  c.leave_out(m.channels);
  c.leave_out(m.channel);
  c.leave_out(m.channel_received);
  c.leave_out(m.channel_lost);
  c.leave_out(m.channel_repeated);
  c.leave_out(m.channel_rejected);
  c.leave_out(m.channel_age_ms);
  c.leave_out(m.channel_jitter_us);
}

template <class C, class M, Is<FullHeartbeat> S>
void fields(C& c, M& m, S& s) noexcept {
  using Base = std::conditional_t<std::is_const_v<S>, const Heartbeat, Heartbeat>;
  fields(c, m, static_cast<Base&>(s));
  c.count(m.channels, s.channels, static_cast<int>(kHeardChannels));
  c(m.channel, s.channel);
  c(m.channel_received, s.channel_received);
  c(m.channel_lost, s.channel_lost);
  c(m.channel_repeated, s.channel_repeated);
  c(m.channel_rejected, s.channel_rejected);
  c(m.channel_age_ms, s.channel_age_ms);
  c(m.channel_jitter_us, s.channel_jitter_us);
}

template <class C, class M, Is<Gap> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.run_id, s.run_id);
  c.id(m.other_run_id, s.other_run_id);
  c.id(m.tick, s.tick);
  c.joint_count(m.joint_count, s.joint_count);
  c.per_joint(m.q, s.q, s.joint_count);
  c.per_joint(m.tau, s.tau, s.joint_count);
  c(m.foot_force, s.foot_force);
  c(m.tilt, s.tilt);
}

template <class C, class M, Is<ObstaclesPiece> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.scene_id, s.scene_id);
  c.pieces(m, s);
  c.count(m.count, s.count, kObstaclesPerPiece);
  c(m.shape, s.shape);
  c(m.size, s.size);
  c(m.position, s.position);
  for (std::size_t i = 0; i < kObstaclesPerPiece; ++i) {
    const bool used = static_cast<int>(i) < s.count;
    c.rotation(m.attitude[i], s.attitude[i], used);
    for (const float size : s.size[i]) c.require(!used || size >= 0);
  }
}

template <class C, class M, Is<ModelTextPiece> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.run_id, s.run_id);
  c.id(m.model_hash, s.model_hash);
  c.within(m.size, s.size, 0, 1 << 24);
  c.pieces(m, s);
  c.count(m.count, s.count, kModelTextBytes);
  c.within(m.kind, s.kind, 0, 127);
  c(m.text, s.text);
}

template <class C, class M, Is<Event> S>
void fields(C& c, M& m, S& s) noexcept {
  c.instant(m.utime, s.utime);
  c.id(m.sender_id, s.sender_id);
  c.id(m.run_id, s.run_id);
  c.id(m.tick, s.tick);
  c.counter(m.sequence, s.sequence);
  c(m.code, s.code);
  c.within(m.severity, s.severity, 0, 2);
  c(m.kind, s.kind);
  c.text(m.text, s.text);
}

template <class C, class M, Is<JournalPage> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.process_id, s.process_id);
  c.id(m.page, s.page);
  c.id(m.step, s.step);
  c.id(m.run_id, s.run_id);
  c.id(m.tick, s.tick);
  c.instant(m.now_ns, s.now_ns);
  c(m.state_hash, s.state_hash);
  c(m.answer_hash, s.answer_hash);
  c(m.report_hash, s.report_hash);
  c(m.input_hash, s.input_hash);
  for (std::size_t i = 0; i < kJournalInputs; ++i) c.instant(m.input_ns[i], s.input_ns[i]);
  c(m.setting, s.setting);
  c.count(m.inputs, s.inputs, static_cast<int>(kJournalInputs));
  c(m.kind, s.kind);
  c(m.whole, s.whole);
  c(m.input, s.input);
}
}  // namespace

template <class T>
Status to_message(const T& value, Message<T>& message) noexcept {
  Copier<true> copier;
  fields(copier, message, value);
  return copier.status();
}

template <class T>
Status from_message(const Message<T>& message, T& value) noexcept {
  Copier<false> copier;
  fields(copier, message, value);
  return copier.status();
}

#define TWINBUS_CONVERT(T)                                       \
  template Status to_message<T>(const T&, Message<T>&) noexcept; \
  template Status from_message<T>(const Message<T>&, T&) noexcept;
TWINBUS_CONVERT(RobotState)
TWINBUS_CONVERT(JointCommand)
TWINBUS_CONVERT(StopRequest)
TWINBUS_CONVERT(SourceRequest)
TWINBUS_CONVERT(SourceStatus)
TWINBUS_CONVERT(ControllerRequest)
TWINBUS_CONVERT(ModeRequest)
TWINBUS_CONVERT(WalkCommand)
TWINBUS_CONVERT(StepList)
TWINBUS_CONVERT(SimRequest)
TWINBUS_CONVERT(Gamepad)
TWINBUS_CONVERT(ArmGoal)
TWINBUS_CONVERT(ArmPathPiece)
TWINBUS_CONVERT(GuardReport)
TWINBUS_CONVERT(ControllerStatus)
TWINBUS_CONVERT(SimTruth)
TWINBUS_CONVERT(Heartbeat)
TWINBUS_CONVERT(FullHeartbeat)
TWINBUS_CONVERT(Gap)
TWINBUS_CONVERT(ObstaclesPiece)
TWINBUS_CONVERT(ModelTextPiece)
TWINBUS_CONVERT(Event)
TWINBUS_CONVERT(JournalPage)
#undef TWINBUS_CONVERT

}  // namespace twinbus
