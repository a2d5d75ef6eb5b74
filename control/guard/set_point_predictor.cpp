#include "control/guard/set_point_predictor.h"

#include <utility>

#include "robot/kinematics/brake.h"
#include "common/math/index.h"
#include "common/math/quintic_fade.h"
#include "common/simd/vec4.h"

namespace twinbus::inline control {

namespace {

// A first command farther than this from its joint is not taken for its set-point [rad or m].
constexpr double kServoError = 0.1;
// A set-point of ours that is farther than this from its joint is a wrong guess [rad or m].
constexpr double kLongestLost = 0.3;
// A set-point this close to its command is there [rad or m].
constexpr double kFollowsWithin = 1e-9;

TWINBUS_INLINE double between(double x, double least, double most) noexcept {
  x = x < least ? least : x;
  return most < x ? most : x;
}

}  // namespace

SetPointTrack::SetPointTrack(const Model& model, int delay_ticks, double lag)
    : period_(model.period()),
      lag_(lag),
      delay_((std::clamp(delay_ticks, 0, kMostDelay) + 1) * model.period() + lag),
      fade_s_(model.blend_s),
      count_(at(std::min(model.bus_count(), kMaxJoints))),
      delay_ticks_(std::clamp(delay_ticks, 0, kMostDelay)) {
  for (std::size_t k = 0; k < count_; ++k) {
    const Joint& joint = model.joints[at(model.bus_joints[k])];
    // A robot that names no rate is taken to be as fast as its joints.
    limit_[k] = joint.rate > 0.0 ? joint.rate : joint.velocity;
    brake_[k] = brake_deceleration(joint);
  }
  reset();
}

void SetPointTrack::reset() noexcept {
  started_ = changed_ = false;
  masks_.fill(0);
  for (std::size_t k = 0; k < count_; ++k) obeyed_[k] = held_[k] = {0.0, 0.0, brake_[k]};
}

void SetPointTrack::start(const RobotState& state, const JointCommand& command) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    q_[k] = std::clamp(command.q[k], state.q[k] - kServoError, state.q[k] + kServoError);
    asked_[k] = command.q[k];
    v_[k] = asked_v_[k] = asked_qd_[k] = 0.0;
  }
  held_now_ = fading_ = 0;
  heard_tick_ = command.tick - 1;
  looked_tick_ = state.tick - 1;
  started_ = true;
}

// What is asked of every joint, and how that moves.  since: the command before [s].
TWINBUS_AVX2_CLONES
void SetPointTrack::hear(const JointCommand& command, double since) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    const double limit = limit_[k], asked = command.q[k];
    const double asked_v = between((asked - asked_[k]) / since, -limit, limit);
    // What speeds up is taken to go on so, as far as joints can; what slows down may stop slowing.
    const double gain = between((asked_v - asked_v_[k]) / since, -brake_[k], brake_[k]);
    acceleration_[k] = gain * asked_v > 0.0 ? gain : 0.0;
    asked_[k] = asked;
    asked_v_[k] = asked_v;
    asked_qd_[k] = between(static_cast<double>(command.qd[k]), -limit, limit);
  }
}

void SetPointTrack::hear_first(const RobotState& state, const JointCommand& command) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    const double limit = limit_[k];
    asked_[k] = command.q[k];
    asked_v_[k] = asked_qd_[k] = between(static_cast<double>(command.qd[k]), -limit, limit);
    acceleration_[k] = 0.0;
    if (((held_now_ | fading_) & bit(static_cast<int>(k))) == 0)
      q_[k] = between(command.q[k], state.q[k] - kServoError, state.q[k] + kServoError);
  }
}

void SetPointTrack::faded(std::size_t k, double t, double& q, double& v) const noexcept {
  q = v = 0.0;
  const Fade& p = fade_[k];
  const double s = (p.time + t) / fade_s_;
  if (!(s < 1.0)) return;
  const QuinticFade fade = quintic_fade(s);
  q = p.q * fade.h0 + p.v * fade_s_ * fade.h1;
  v = p.q * fade.h0_rate / fade_s_ + p.v * fade.h1_rate;
}

double SetPointTrack::farthest(std::size_t k) const noexcept {
  return Course{limit_[k] * delay_, limit_[k], brake_[k]}.rest();
}

// At full rate for `way`, braked when it pays.
Course SetPointTrack::run_after(std::size_t k, double way) const noexcept {
  const double b = brake_[k], length = std::abs(way);
  const double v =
      std::min(limit_[k], b * (std::sqrt(delay_ * delay_ + 2.0 * length / b) - delay_));
  return {std::copysign(v * delay_, way), std::copysign(v, way), b};
}

// What was held and is no more begins to fade back to its command; what has faded is free.
void SetPointTrack::hold(const RobotState& state, std::int64_t joints) noexcept {
  for (std::size_t k = 0; k < count_ && (joints & ~held_now_) != 0; ++k) {
    if ((joints & ~held_now_ & bit(static_cast<int>(k))) == 0) continue;
    const BrakeStart start = brake_start(q_[k], v_[k], state.q[k], static_cast<double>(state.qd[k]), limit_[k], false);
    q_[k] = start.q;
    v_[k] = start.v;
  }
  const std::int64_t released = fade_s_ > 0.0 ? held_now_ & ~joints : 0;
  fading_ = (fading_ | released) & ~joints;
  held_now_ = joints;
  if (fading_ == 0) return;
  for (std::size_t k = 0; k < count_; ++k) {
    const std::int64_t joint = bit(static_cast<int>(k));
    if ((released & joint) != 0)
      fade_[k] = {q_[k] - (asked_[k] - asked_qd_[k] * period_), v_[k] - asked_qd_[k], 0.0};
    if ((fading_ & joint) != 0 && !((fade_[k].time += period_) < fade_s_)) fading_ &= ~joint;
  }
}

// A joint that is held or fades.
void SetPointTrack::move_bound(std::size_t k, double measured) noexcept {
  const double limit = limit_[k], before = q_[k];
  if ((held_now_ & bit(static_cast<int>(k))) != 0) {
    brake_step(brake_[k], period_, q_[k], v_[k]);
  } else {
    double q = 0.0, v = 0.0;
    faded(k, 0.0, q, v);
    q_[k] = std::clamp(asked_[k] + q, before - limit * period_, before + limit * period_);
    v_[k] = std::clamp(asked_qd_[k] + v, -limit, limit);
  }
  q_[k] = std::clamp(q_[k], measured - kLongestLost, measured + kLongestLost);
  look(k, measured);
}

// Of a joint that is held, fades or lags behind its command.
void SetPointTrack::look(std::size_t k, double measured) noexcept {
  const double limit = limit_[k], behind = q_[k] - measured, left = asked_[k] - q_[k];
  const bool fading = (fading_ & bit(static_cast<int>(k))) != 0;
  const bool held = (held_now_ & bit(static_cast<int>(k))) != 0;
  const auto go_on = [&](double t) {  // the fade goes on, then a brake
    double q = 0.0, v = 0.0, q_now = 0.0, v_now = 0.0;
    faded(k, 0.0, q_now, v_now);
    faded(k, t, q, v);
    const double faster =
        std::abs(asked_qd_[k] + v) > std::abs(asked_v_[k] + v) ? asked_qd_[k] : asked_v_[k];
    const double v_end = std::clamp(faster + v, -limit, limit);
    const double way = asked_v_[k] * t + std::clamp(q - q_now, -limit * t, limit * t);
    return Course{behind + way + v_end * lag_, v_end, brake_[k]};
  };
  if (fading) {
    obeyed_[k] = go_on(delay_ - lag_);
  } else {
    const Course asked{asked_v_[k] * delay_, asked_v_[k], brake_[k]};
    way_[k] = left + asked.rest();
    obeyed_[k] = run_after(k, std::clamp(way_[k], -farthest(k), farthest(k)));
    obeyed_[k].first += behind;
  }
  if (held) {
    held_[k] = {behind + v_[k] * lag_, v_[k], brake_[k]};
  } else {
    held_[k] = fading ? go_on(delay_ - lag_ - period_) : obeyed_[k];
  }
}

// Joints that nothing holds and that are where they are asked to be: the command speeds up as it does, then a brake comes.
// since: the look before [s].
TWINBUS_AVX2_CLONES
void SetPointTrack::move_free(const RobotState& state, double since) noexcept {
  const double obeyed_s = delay_ - lag_, held_s = obeyed_s - period_;
  for (std::size_t k = 0; k < count_; ++k) {
    const double limit = limit_[k], measured = state.q[k];
    const double most = limit * since;
    const double q =
        between(between(asked_[k], q_[k] - most, q_[k] + most), measured - kLongestLost, measured + kLongestLost);
    const double behind = q - measured, v = asked_v_[k], a = acceleration_[k];
    const double faster = std::abs(asked_qd_[k]) > std::abs(v) ? asked_qd_[k] : v;
    free_.q[k] = q;
    free_.obeyed_v[k] = between(faster + a * obeyed_s, -limit, limit);
    free_.obeyed[k] = behind + 0.5 * (v + between(v + a * obeyed_s, -limit, limit)) * obeyed_s +
                      free_.obeyed_v[k] * lag_;
    free_.held_v[k] = between(faster + a * held_s, -limit, limit);
    free_.held[k] = behind + 0.5 * (v + between(v + a * held_s, -limit, limit)) * held_s +
                    free_.held_v[k] * lag_;
  }
}

// What is let go together fades together: all held joints go the same share of their ways, as far as
// the one takes that has the longest for its rate.
void SetPointTrack::go_together(const RobotState& state) noexcept {
  double most = 0.0;
  std::size_t slowest = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double times =
        (held_now_ & bit(static_cast<int>(k))) != 0 ? std::abs(way_[k]) / farthest(k) : 0.0;
    if (!(times > most)) continue;
    most = times;
    slowest = k;
  }
  if (!(most > 0.0)) return;
  const Course lead = run_after(slowest, way_[slowest] / std::max(1.0, most));
  for (std::size_t k = 0; k < count_; ++k) {
    if ((held_now_ & bit(static_cast<int>(k))) == 0) continue;
    const double ratio = way_[k] / way_[slowest];
    obeyed_[k].first = q_[k] - state.q[k] + ratio * lead.first;
    obeyed_[k].speed = ratio * lead.speed;
    obeyed_[k].brake = std::max(std::abs(ratio) * lead.brake, 1e-6);
  }
}

std::int64_t SetPointTrack::on_hold() const noexcept {
  std::int64_t held = masks_[0];
  for (int i = 1; i < delay_ticks_; ++i) held |= masks_[at(i)];
  return held;
}

void SetPointTrack::follow(const RobotState& state, const JointCommand& command,
                           std::int64_t mask) noexcept {
  if (!started_) start(state, command);
  for (std::size_t i = masks_.size(); i-- > 1;) masks_[i] = masks_[i - 1];
  masks_[0] = mask;
  const std::int64_t in_force = delay_ticks_ > 0 ? masks_[at(delay_ticks_ - 1)] : mask;
  // One that is heard again says nothing new; where commands or looks were left out, the set-point has moved for longer than
  // a period.
  const std::int64_t ticks = command.tick - heard_tick_;
  if (ticks != 0 && std::exchange(changed_, false))
    hear_first(state, command);
  else if (ticks != 0)
    hear(command, static_cast<double>(std::clamp<std::int64_t>(ticks, 1, kMostLeftOut)) * period_);
  heard_tick_ = command.tick;
  // A guard that stood still has not seen the set-points move.
  const std::int64_t looks = std::clamp<std::int64_t>(state.tick - looked_tick_, 1, kMostLeftOut);
  looked_tick_ = state.tick;
  move_free(state, static_cast<double>(looks) * period_);
  hold(state, in_force & (bit(static_cast<int>(count_)) - 1));
  const std::int64_t bound = held_now_ | fading_;
  for (std::size_t k = 0; k < count_; ++k) {
    if ((bound & bit(static_cast<int>(k))) != 0) {
      move_bound(k, state.q[k]);
      continue;
    }
    q_[k] = free_.q[k];
    v_[k] = asked_qd_[k];
    if (std::abs(asked_[k] - q_[k]) < kFollowsWithin) {
      obeyed_[k] = {free_.obeyed[k], free_.obeyed_v[k], brake_[k]};
      held_[k] = {free_.held[k], free_.held_v[k], brake_[k]};
    } else {
      look(k, state.q[k]);
    }
  }
  if (held_now_ != 0) go_together(state);
}

}  // namespace twinbus::control
