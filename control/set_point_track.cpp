#include "control/set_point_track.h"

#include "robot/brake.h"
#include "robot/index.h"

namespace twinbus {

namespace {

// A first command farther than this from its joint is not taken for its set-point [rad or m].
constexpr double kServoError = 0.1;
// A set-point of ours that is farther than this from its joint is a wrong guess [rad or m].
constexpr double kLost = 0.3;

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
  started_ = false;
  masks_.fill(0);
  for (std::size_t k = 0; k < count_; ++k) obeyed_[k] = held_[k] = {0.0, 0.0, brake_[k]};
}

void SetPointTrack::start(const RobotState& state, const JointCommand& command) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    point_[k] = {};
    point_[k].q = std::clamp(command.q[k], state.q[k] - kServoError, state.q[k] + kServoError);
    point_[k].asked = command.q[k];
  }
  started_ = true;
}

void SetPointTrack::faded(const SetPoint& p, double t, double& q, double& v) const noexcept {
  q = v = 0.0;
  const double s = (p.fade + t) / fade_s_;
  if (p.fade < 0.0 || !(s < 1.0)) return;
  const double s2 = s * s, s3 = s2 * s;
  q = p.fade_q * (1.0 - s3 * (10.0 - 15.0 * s + 6.0 * s2)) +
      p.fade_v * fade_s_ * (s - s3 * (6.0 - 8.0 * s + 3.0 * s2));
  v = p.fade_q * (-30.0 * s2 + 60.0 * s3 - 30.0 * s2 * s2) / fade_s_ +
      p.fade_v * (1.0 - 18.0 * s2 + 32.0 * s3 - 15.0 * s2 * s2);
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

void SetPointTrack::move(std::size_t k, double measured, double asked, double asked_qd,
                         bool held) noexcept {
  SetPoint& p = point_[k];
  const double limit = limit_[k];
  const double asked_v = std::clamp((asked - p.asked) / period_, -limit, limit);
  // What speeds up is taken to go on so, as far as joints can; what slows down may stop slowing.
  const double gain = std::clamp((asked_v - p.asked_v) / period_, -brake_[k], brake_[k]);
  const double acceleration = gain * asked_v > 0.0 ? gain : 0.0;
  p.asked = asked;
  p.asked_v = asked_v;
  p.asked_qd = std::clamp(asked_qd, -limit, limit);
  const double before = p.q;
  if (held) {
    const double slower = std::copysign(std::max(0.0, std::abs(p.v) - brake_[k] * period_), p.v);
    p.q += 0.5 * (p.v + slower) * period_;
    p.v = slower;
    p.fade = -1.0;
  } else {
    if (p.held && fade_s_ > 0.0) {
      p.fade_q = p.q - (asked - p.asked_qd * period_);
      p.fade_v = p.v - p.asked_qd;
      p.fade = 0.0;
    }
    if (p.fade >= 0.0 && !((p.fade += period_) < fade_s_)) p.fade = -1.0;
    double q = 0.0, v = 0.0;
    faded(p, 0.0, q, v);
    p.q = std::clamp(asked + q, before - limit * period_, before + limit * period_);
    p.v = std::clamp(p.asked_qd + v, -limit, limit);
  }
  p.held = held;
  p.q = std::clamp(p.q, measured - kLost, measured + kLost);
  look(k, measured, acceleration);
}

void SetPointTrack::look(std::size_t k, double measured, double acceleration) noexcept {
  const SetPoint& p = point_[k];
  const double limit = limit_[k], behind = p.q - measured, left = p.asked - p.q;
  const bool fading = p.fade >= 0.0;
  const auto go_on = [&](double t) {  // the command speeds up as it does, then a brake
    double q = 0.0, v = 0.0, q_now = 0.0, v_now = 0.0;
    if (fading) {
      faded(p, 0.0, q_now, v_now);
      faded(p, t, q, v);
    }
    const double a = fading ? 0.0 : acceleration;
    const double faster =
        std::abs(p.asked_qd + v) > std::abs(p.asked_v + v) ? p.asked_qd : p.asked_v;
    const double v_end = std::clamp(faster + a * t + v, -limit, limit);
    const double way = 0.5 * (p.asked_v + std::clamp(p.asked_v + a * t, -limit, limit)) * t +
                       std::clamp(q - q_now, -limit * t, limit * t);
    return Course{behind + way + v_end * lag_, v_end, brake_[k]};
  };
  const bool follows = !p.held && (fading || std::abs(left) < 1e-9);
  if (follows) {
    obeyed_[k] = go_on(delay_ - lag_);
  } else {
    const Course asked{p.asked_v * delay_, p.asked_v, brake_[k]};
    way_[k] = left + asked.rest();
    obeyed_[k] = run_after(k, std::clamp(way_[k], -farthest(k), farthest(k)));
    obeyed_[k].first += behind;
  }
  if (p.held) {
    held_[k] = {behind + p.v * lag_, p.v, brake_[k]};
  } else if (follows) {
    held_[k] = go_on(delay_ - lag_ - period_);
  } else {
    held_[k] = obeyed_[k];
  }
}

// What is let go together fades together: all held joints go the same share of their ways, as far as
// the one takes that has the longest for its rate.
void SetPointTrack::go_together(const RobotState& state) noexcept {
  double most = 0.0;
  std::size_t slowest = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double times = point_[k].held ? std::abs(way_[k]) / farthest(k) : 0.0;
    if (!(times > most)) continue;
    most = times;
    slowest = k;
  }
  if (!(most > 0.0)) return;
  const Course lead = run_after(slowest, way_[slowest] / std::max(1.0, most));
  for (std::size_t k = 0; k < count_; ++k) {
    if (!point_[k].held) continue;
    const double ratio = way_[k] / way_[slowest];
    obeyed_[k].first = point_[k].q - state.q[k] + ratio * lead.first;
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
  for (std::size_t k = 0; k < count_; ++k)
    move(k, state.q[k], command.q[k], static_cast<double>(command.qd[k]),
         (in_force & bit(static_cast<int>(k))) != 0);
  go_together(state);
}

}  // namespace twinbus
