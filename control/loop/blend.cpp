#include "control/loop/blend.h"

#include <algorithm>
#include <cstddef>

namespace twinbus::inline control {

namespace {
constexpr double kTorque = 0.05;  // of torques where set-points are what is measured [s]

// 1 -> 0 while s goes from 0 to 1.
double left_at(double s) noexcept { return 1.0 - s * s * s * (10.0 - 15.0 * s + 6.0 * s * s); }
}  // namespace

void Blend::start(const SetPoint& last, const SetPoint& fresh, std::int64_t measured,
                  double duration) noexcept {
  duration_ = std::max(1e-3, duration);
  time_ = 0.0;
  measured_ = measured;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count_); ++j) {
    difference_.q[j] = last.q[j] - fresh.q[j];
    difference_.qd[j] = follows(j) ? 0.0 : last.qd[j] - fresh.qd[j];
    difference_.tau[j] = last.tau[j] - fresh.tau[j];
    difference_.kp[j] = last.kp[j] - fresh.kp[j];
    difference_.kd[j] = last.kd[j] - fresh.kd[j];
  }
}

void Blend::apply(SetPoint& set_point, double dt) noexcept {
  if (!active()) return;
  time_ = std::min(duration_, time_ + dt);
  const double s = time_ / duration_;
  const double s2 = s * s;
  const double s3 = s2 * s;
  const double keep = left_at(s);
  const double keep_torque = left_at(std::min(1.0, time_ / std::min(kTorque, duration_)));
  const double keep_rate = -30.0 * s2 * (1.0 - 2.0 * s + s2) / duration_;
  const double drift = duration_ * (s - s3 * (6.0 - 8.0 * s + 3.0 * s2));
  const double drift_rate = 1.0 - 18.0 * s2 + 32.0 * s3 - 15.0 * s2 * s2;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count_); ++j) {
    const double d = difference_.q[j];
    const double v = difference_.qd[j];
    set_point.q[j] += d * keep + v * drift;
    set_point.qd[j] += d * keep_rate + v * drift_rate;
    set_point.tau[j] += difference_.tau[j] * (follows(j) ? keep_torque : keep);
    set_point.kp[j] += difference_.kp[j] * keep;
    set_point.kd[j] += difference_.kd[j] * keep;
  }
}

}  // namespace twinbus::control
