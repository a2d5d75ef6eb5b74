#include "planner/path_timing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace twinbus {

namespace {

constexpr double kTick = 0.001;   // of the table s(t) [s]
constexpr double kStride = 0.01;  // of the passes over s [rad]
constexpr double kForCurvature =
    0.7;  // share of the acceleration that going round a corner may use
constexpr double kTiny = 1e-9;

// s(t) of one part at multiples of kTick, from rest to rest.
struct Profile {
  std::vector<double> s, speed;
};

// Largest |u| when moving with x where the path has these derivatives.
double free_acceleration(const JointPoint& dq, const JointPoint& ddq, double x,
                         const JointPoint& limit) {
  double most = 1e9;
  for (int k = 0; k < dq.size(); ++k) {
    const double left = limit[k] - std::abs(ddq[k]) * x;
    if (std::abs(dq[k]) > kTiny) most = std::min(most, std::max(0.0, left) / std::abs(dq[k]));
  }
  return most;
}

double speed_limit_squared(const JointPoint& dq, const JointPoint& ddq,
                           const TimingLimits& limits) {
  double most = 1e9;
  for (int k = 0; k < dq.size(); ++k) {
    if (std::abs(dq[k]) > kTiny) most = std::min(most, std::pow(limits.velocity[k] / dq[k], 2));
    if (std::abs(ddq[k]) > kTiny)
      most = std::min(most, kForCurvature * limits.acceleration[k] / std::abs(ddq[k]));
  }
  return most;
}

Profile fastest(const RoundedPath& part, const TimingLimits& limits) {
  const int count = std::max(20, static_cast<int>(std::ceil(part.length() / kStride)));
  const double ds = part.length() / count;
  const auto size = static_cast<std::size_t>(count) + 1;
  std::vector<double> x(size);
  std::vector<JointPoint> dq(size), ddq(size);
  JointPoint q;
  for (std::size_t i = 0; i < size; ++i) {
    part.at(std::min(ds * static_cast<double>(i), part.length()), q, dq[i], ddq[i]);
    x[i] = speed_limit_squared(dq[i], ddq[i], limits);
  }
  x.front() = x.back() = 0.0;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    const double u = std::min(
        free_acceleration(dq[i], ddq[i], x[i], limits.acceleration),
        free_acceleration(dq[i + 1], ddq[i + 1], std::min(x[i], x[i + 1]), limits.acceleration));
    x[i + 1] = std::min(x[i + 1], x[i] + 2.0 * u * ds);
  }
  for (std::size_t i = size - 1; i > 0; --i) {
    const double u = std::min(
        free_acceleration(dq[i], ddq[i], x[i], limits.acceleration),
        free_acceleration(dq[i - 1], ddq[i - 1], std::min(x[i], x[i - 1]), limits.acceleration));
    x[i - 1] = std::min(x[i - 1], x[i] + 2.0 * u * ds);
  }

  std::vector<double> time(size, 0.0);
  for (std::size_t i = 1; i < size; ++i) {
    time[i] = time[i - 1] + 2.0 * ds / std::max(kTiny, std::sqrt(x[i - 1]) + std::sqrt(x[i]));
  }
  // Between two strides u is constant.
  Profile profile;
  std::size_t i = 0;
  for (double t = 0.0; t < time.back(); t += kTick) {
    while (i + 2 < size && t >= time[i + 1]) ++i;
    const double u = (x[i + 1] - x[i]) / (2.0 * ds);
    const double dt = t - time[i];
    const double s = ds * static_cast<double>(i) + std::sqrt(x[i]) * dt + 0.5 * u * dt * dt;
    profile.s.push_back(std::clamp(s, 0.0, part.length()));
  }
  profile.s.push_back(part.length());
  return profile;
}

// Moving average of s over `window` seconds: as long as the window later, and with steady
// acceleration changes.
void smooth(Profile& profile, double window) {
  const auto width = static_cast<std::size_t>(std::max(1.0, std::round(window / kTick)));
  const std::size_t size = profile.s.size() + width;
  const auto raw = [&](std::size_t i) {
    return i < profile.s.size() ? profile.s[i] : profile.s.back();
  };
  std::vector<double> s(size), speed(size);
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    sum += raw(i) - (i >= width ? raw(i - width) : 0.0);
    s[i] = sum / static_cast<double>(width);
    speed[i] =
        (raw(i) - (i >= width ? raw(i - width) : 0.0)) / (static_cast<double>(width) * kTick);
  }
  // The sum runs one tick ahead of the difference; put both on the middle of the tick.
  for (std::size_t i = 0; i < size; ++i) s[i] -= 0.5 * speed[i] * kTick;
  s.front() = 0.0;
  s.back() = profile.s.back();
  speed.front() = speed.back() = 0.0;
  profile.s = std::move(s);
  profile.speed = std::move(speed);
}

void append_knots(const RoundedPath& part, const Profile& profile, int spaces, TimedPath& path) {
  const double start = path.empty() ? 0.0 : path.back().time;
  const double last = static_cast<double>(profile.s.size() - 1);
  JointPoint ddq;
  for (int i = path.empty() ? 0 : 1; i <= spaces; ++i) {
    const auto tick = static_cast<std::size_t>(std::round(last * i / spaces));
    Knot knot;
    knot.time = start + kTick * static_cast<double>(tick);
    part.at(std::clamp(profile.s[tick], 0.0, part.length()), knot.q, knot.qd, ddq);
    knot.qd *= profile.speed[tick];
    path.push_back(std::move(knot));
  }
}

void stretch(TimedPath& path, double factor) {
  for (Knot& knot : path) {
    knot.time *= factor;
    knot.qd /= factor;
  }
}

}  // namespace

TimedPath time_path(const std::vector<RoundedPath>& parts, const TimingLimits& limits,
                    double knot_spacing, int most_knots) {
  TimedPath path;
  std::vector<Profile> profiles;
  double duration = 0.0;
  for (const RoundedPath& part : parts) {
    profiles.push_back(fastest(part, limits));
    const double raw = kTick * static_cast<double>(profiles.back().s.size() - 1);
    smooth(profiles.back(), std::min(limits.smoothing, 0.25 * raw));
    duration += kTick * static_cast<double>(profiles.back().s.size() - 1);
  }
  const double spacing = std::max(
      knot_spacing, duration / std::max(1, most_knots - 2 * static_cast<int>(parts.size())));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double time = kTick * static_cast<double>(profiles[i].s.size() - 1);
    append_knots(parts[i], profiles[i], std::max(2, static_cast<int>(std::ceil(time / spacing))),
                 path);
  }
  if (path.size() < 2) return path;
  const LimitUse use = limit_use(path, limits);
  stretch(path, std::max({use.velocity, std::sqrt(use.acceleration), 1e-3}) * (1.0 + 1e-9));
  return path;
}

void sample(const TimedPath& path, double time, JointPoint& q, JointPoint& qd, JointPoint& qdd) {
  const auto next = std::upper_bound(path.begin() + 1, path.end() - 1, time,
                                     [](double t, const Knot& knot) { return t < knot.time; });
  const Knot& a = *(next - 1);
  const Knot& b = *next;
  const double h = b.time - a.time;
  const double t = std::clamp((time - a.time) / h, 0.0, 1.0);
  const JointPoint step = b.q - a.q;
  const JointPoint c = 3.0 * step - h * (2.0 * a.qd + b.qd);  // of t^2
  const JointPoint d = -2.0 * step + h * (a.qd + b.qd);       // of t^3
  q = a.q + t * (h * a.qd + t * (c + t * d));
  qd = a.qd + t / h * (2.0 * c + 3.0 * t * d);
  qdd = (2.0 * c + 6.0 * t * d) / (h * h);
}

// The velocity of a cubic is largest at its ends or where its acceleration vanishes, the
// acceleration at its ends.
LimitUse limit_use(const TimedPath& path, const TimingLimits& limits) {
  LimitUse use;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Knot& a = path[i];
    const Knot& b = path[i + 1];
    const double h = b.time - a.time;
    for (int k = 0; k < a.q.size(); ++k) {
      const double step = b.q[k] - a.q[k];
      const double c = 3.0 * step - h * (2.0 * a.qd[k] + b.qd[k]);
      const double d = -2.0 * step + h * (a.qd[k] + b.qd[k]);
      double fastest = std::max(std::abs(a.qd[k]), std::abs(b.qd[k]));
      const double turn = std::abs(d) > 0.0 ? -c / (3.0 * d) : -1.0;
      if (turn > 0.0 && turn < 1.0)
        fastest = std::max(fastest, std::abs(a.qd[k] + turn / h * (2.0 * c + 3.0 * turn * d)));
      const double hardest = std::max(std::abs(2.0 * c), std::abs(2.0 * c + 6.0 * d)) / (h * h);
      use.velocity = std::max(use.velocity, fastest / limits.velocity[k]);
      use.acceleration = std::max(use.acceleration, hardest / limits.acceleration[k]);
    }
  }
  return use;
}

}  // namespace twinbus
