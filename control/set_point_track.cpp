#include "control/set_point_track.h"

#include <algorithm>
#include <cmath>

#include "robot/brake.h"

namespace twinbus {

namespace {

// A first command farther than this from its joint is not taken for its set-point [rad or m].
constexpr double kServoError = 0.1;
// A set-point of ours that is farther than this from its joint is a wrong guess [rad or m].
constexpr double kLost = 0.3;

}  // namespace

SetPointTrack::SetPointTrack(const Model& model, double delay)
    : delay_(delay),
      period_(model.period()),
      count_(static_cast<std::size_t>(std::min(model.bus_count(), kMaxJoints))) {
  for (std::size_t k = 0; k < count_; ++k) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
    // A robot that names no rate is taken to be as fast as its joints.
    limit_[k] = joint.rate > 0.0 ? joint.rate : joint.velocity;
    brake_[k] = brake_deceleration(joint);
  }
}

double SetPointTrack::look_ahead(std::size_t k, double speed) const noexcept {
  return speed * delay_ + 0.5 * speed * std::abs(speed) / brake_[k];
}

void SetPointTrack::start(const RobotState& state, const JointCommand& command) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    q_[k] = std::clamp(command.q[k], state.q[k] - kServoError, state.q[k] + kServoError);
    v_[k] = 0.0;
    asked_[k] = command.q[k];
  }
  started_ = true;
}

void SetPointTrack::move(std::size_t k, double measured, double asked, bool held) noexcept {
  const double limit = limit_[k];
  const double asked_speed = std::clamp((asked - asked_[k]) / period_, -limit, limit);
  asked_[k] = asked;
  if (held) {
    v_[k] = std::copysign(std::max(0.0, std::abs(v_[k]) - brake_[k] * period_), v_[k]);
  } else {
    v_[k] = std::clamp((asked - q_[k]) / period_, -limit, limit);
  }
  q_[k] = std::clamp(q_[k] + v_[k] * period_, measured - kLost, measured + kLost);

  const double left = asked - q_[k];
  if (!held && !(std::abs(left) > 1e-9)) {  // at its command
    rest_[k] = q_[k] + look_ahead(k, asked_speed);
    return;
  }
  const double most = look_ahead(k, limit);
  const double wanted = std::clamp(left + look_ahead(k, asked_speed), -most, most);
  const double under_way = look_ahead(k, v_[k]);
  const bool shorter = held && wanted * under_way > 0.0 && std::abs(wanted) < std::abs(under_way);
  rest_[k] = q_[k] + (shorter ? under_way : wanted);
}

void SetPointTrack::follow(const RobotState& state, const JointCommand& command,
                           std::int64_t mask) noexcept {
  if (!started_) start(state, command);
  for (std::size_t k = 0; k < count_; ++k)
    move(k, state.q[k], command.q[k], ((mask >> k) & 1) != 0);
}

}  // namespace twinbus
