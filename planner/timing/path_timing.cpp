#include "planner/timing/path_timing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace twinbus::inline planner {

namespace {

constexpr double kStride = 0.02;  // of the passes over s [rad]
constexpr double kForever = 1e9;  // no limit
constexpr double kTiny = 1e-9;
constexpr int kNewton = 24;        // steps; a few do
constexpr double kSlowest = 0.01;  // of the largest x that coasting may lower it to
constexpr int kLongest = 24;       // averages, in spaces of control points
constexpr double kEnough = 1.02;   // times the limit of jerk: the rest is stretched
constexpr int kPasses = 16;        // of softening
constexpr int kReach = 16;         // to either side of too much jerk, and of the ends, in points
constexpr double kShare = 0.3;     // of the way to the mean of the neighbours, at most

// What holds between two nodes of s, from the derivatives in their middle: joint k allows every u
// within most[k] of -drift[k] x, x being the one at the stride's start.
struct Stride {
  double ds = 0.0;
  JointPoint most, drift;
  double speed = kForever;  // largest x there
};

// The range of u as it depends on x: its ends, and how they change with x.
struct Range {
  double low = -kForever, high = kForever, low_slope = 0.0, high_slope = 0.0;
  void at_least(double u, double slope) {
    if (!(u > low)) return;
    low = u;
    low_slope = slope;
  }
  void at_most(double u, double slope) {
    if (!(u < high)) return;
    high = u;
    high_slope = slope;
  }
};

Range range_of(const Stride& stride, double x) {
  Range range;
  for (int k = 0; k < stride.most.size(); ++k) {
    range.at_least(-stride.most[k] - stride.drift[k] * x, -stride.drift[k]);
    range.at_most(stride.most[k] - stride.drift[k] * x, -stride.drift[k]);
  }
  return range;
}

// |(q' + q'' ds) u + q'' x| <= limit of every joint, and sqrt(x) |q'| <= its velocity.
Stride stride_of(double ds, const JointPoint& dq, const JointPoint& ddq,
                 const TimingLimits& limits) {
  Stride stride{.ds = ds, .most = dq, .drift = dq};
  for (int k = 0; k < dq.size(); ++k) {
    if (std::abs(dq[k]) > kTiny)
      stride.speed = std::min(stride.speed, std::pow(limits.velocity[k] / dq[k], 2));
    const double slope = dq[k] + ddq[k] * ds;
    const bool stands = std::abs(slope) < kTiny;
    stride.most[k] = stands ? kForever : limits.acceleration[k] / std::abs(slope);
    stride.drift[k] = stands ? 0.0 : ddq[k] / slope;
    if (stands && std::abs(ddq[k]) > kTiny)
      stride.speed = std::min(stride.speed, limits.acceleration[k] / std::abs(ddq[k]));
  }
  return stride;
}

std::vector<Stride> strides_of(const RoundedPath& part, const TimingLimits& limits,
                               double longest) {
  std::vector<Stride> strides;
  JointPoint q, dq, ddq;
  for (std::size_t piece = 0; piece + 1 < part.seams().size(); ++piece) {
    const double start = part.seams()[piece], length = part.seams()[piece + 1] - start;
    const int count = std::max(4, static_cast<int>(std::ceil(length / longest)));
    for (int i = 0; i < count; ++i) {
      part.at(start + (i + 0.5) * length / count, q, dq, ddq);
      strides.push_back(stride_of(length / count, dq, ddq, limits));
    }
  }
  return strides;
}

// The largest x <= most from which some u leads to at most `next`, and not below 0. Low end less
// high end of the range is convex in x and not positive at 0, so Newton's steps from above do not
// pass the answer.
double controllable(const Stride& stride, double most, double next) {
  const double rate = 1.0 / (2.0 * stride.ds);
  double x = most;
  for (int step = 0; step < kNewton; ++step) {
    Range range = range_of(stride, x);
    range.at_most((next - x) * rate, -rate);
    range.at_least(-x * rate, -rate);
    const double gap = range.low - range.high, slope = range.low_slope - range.high_slope;
    if (!(gap > 1e-12 * std::abs(range.low))) return x;
    x = slope > 0.0 ? std::max(0.0, x - gap / slope) : 0.0;
  }
  return x;
}

// The fastest motion along one part: x and time at every node.
struct Profile {
  std::vector<double> s, x, time;
};

void set_times(Profile& profile) {
  for (std::size_t i = 1; i < profile.s.size(); ++i)
    profile.time[i] = profile.time[i - 1] +
                      2.0 * (profile.s[i] - profile.s[i - 1]) /
                          std::max(kTiny, std::sqrt(profile.x[i - 1]) + std::sqrt(profile.x[i]));
}

Profile fastest(const RoundedPath& part, const TimingLimits& limits, double longest) {
  const std::vector<Stride> strides = strides_of(part, limits, longest);
  const std::size_t last = strides.size();
  Profile profile;
  profile.s.resize(last + 1);
  profile.x.resize(last + 1);
  profile.time.resize(last + 1);
  std::vector<double>& x = profile.x;
  for (std::size_t i = last; i-- > 1;) {
    const double cap = std::min(strides[i].speed, strides[i - 1].speed);
    // Braking from more than this is beyond every limit on a straight stride: a start near the
    // answer.
    x[i] = controllable(strides[i], cap, x[i + 1]);
  }
  for (std::size_t i = 0; i < last; ++i) {
    const double ds = strides[i].ds;
    const double u = std::min((x[i + 1] - x[i]) / (2.0 * ds), range_of(strides[i], x[i]).high);
    x[i + 1] = std::max(0.0, x[i] + 2.0 * u * ds);
    profile.s[i + 1] = profile.s[i] + ds;
  }
  x.back() = 0.0;  // and not the rounding of it
  set_times(profile);
  return profile;
}

// Between speeding up and slowing down the motion goes on steadily for `least` seconds: averaged
// over that long, the push then never changes from one limit to the other at once. Costs least^2 /
// (2 duration).
void coast(Profile& profile, double least) {
  std::vector<double>& x = profile.x;
  const std::vector<double>& s = profile.s;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (x[i] < x[i - 1] || x[i] < x[i + 1]) continue;
    std::size_t left = i, right = i;
    double level = x[i];
    while (s[right] - s[left] < least * std::sqrt(level)) {
      const double next = std::max(x[left - 1], x[right + 1]);
      if (!(next > kSlowest * x[i]) || next > level) break;
      level = next;
      if (x[left - 1] == next)
        --left;
      else
        ++right;
    }
    for (std::size_t k = left; k <= right; ++k) x[k] = std::min(x[k], level);
    i = right;
  }
  set_times(profile);
}

// s at times that do not go back; `i` is where the last one was found.
double s_at(const Profile& profile, double t, std::size_t& i) {
  const std::size_t size = profile.s.size();
  while (i + 2 < size && t >= profile.time[i + 1]) ++i;
  const double ds = profile.s[i + 1] - profile.s[i];
  const double u = (profile.x[i + 1] - profile.x[i]) / (2.0 * ds);
  const double dt = std::clamp(t - profile.time[i], 0.0, profile.time[i + 1] - profile.time[i]);
  return std::clamp(profile.s[i] + std::sqrt(profile.x[i]) * dt + 0.5 * u * dt * dt, profile.s[i],
                    profile.s[i + 1]);
}

// Largest |third difference| / limit when each control point is the mean of `width` of them.
double jerk_use(const std::vector<JointPoint>& raw, int width, double h, const JointPoint& limit) {
  const int last = static_cast<int>(raw.size()) - 1;
  const auto point = [&](int i) -> const JointPoint& {
    return raw[static_cast<std::size_t>(std::clamp(i, 0, last))];
  };
  const auto bend = [&](int i, int k) {
    return point(i + 1)[k] - 2.0 * point(i)[k] + point(i - 1)[k];
  };
  double most = 0.0;
  for (int i = -1; i <= last + width; ++i) {
    for (int k = 0; k < limit.size(); ++k)
      most = std::max(most, std::abs(bend(i, k) - bend(i - width, k)) / limit[k]);
  }
  return most / (width * h * h * h);
}

// Where the jerk between control points is beyond its limit these are drawn to the means of their
// neighbours, the less the farther away and the nearer to an end: a mean of motions keeps what they
// keep, and takes as long.
void soften(std::vector<JointPoint>& control, double h, const JointPoint& limit) {
  const int size = static_cast<int>(control.size());
  std::vector<double> weight(control.size());
  const JointPoint most = kEnough * h * h * h * limit;
  for (int pass = 0; pass < kPasses; ++pass) {
    bool hot = false;
    std::fill(weight.begin(), weight.end(), 0.0);
    for (int i = 1; i + 2 < size; ++i) {
      const JointPoint* c = &control[static_cast<std::size_t>(i)];
      bool over = false;
      for (int k = 0; k < limit.size(); ++k)
        over = over || std::abs(c[2][k] - c[-1][k] - 3.0 * (c[1][k] - c[0][k])) > most[k];
      if (!over) continue;
      hot = true;
      for (int away = -kReach; away <= kReach + 1; ++away) {
        const int at = i + away;
        if (at <= 0 || at >= size - 1) continue;
        const double far = (std::abs(away - 0.5) - 0.5) / (kReach + 1.0);
        const double inside =
            std::min(1.0, static_cast<double>(std::min(at, size - 1 - at)) / kReach);
        double& w = weight[static_cast<std::size_t>(at)];
        w = std::max(w, kShare * (1.0 - far * far) * (1.0 - far * far) * inside * inside);
      }
    }
    if (!hot) return;
    JointPoint before = control.front();
    for (std::size_t i = 1; i + 1 < control.size(); ++i) {
      const JointPoint here = control[i];
      control[i] += weight[i] * (before - 2.0 * here + control[i + 1]);
      before = here;
    }
  }
}

// The control points averaged over `width` of them, at rest at both ends; as slow as the limits
// ask.
TimedPath spline(const std::vector<JointPoint>& raw, int width, double h, bool softened,
                 const TimingLimits& limits) {
  const int count = static_cast<int>(raw.size()) - 1;
  std::vector<JointPoint> control(raw.size() + static_cast<std::size_t>(width) - 1);
  const auto at = [&](int i) -> const JointPoint& {
    return raw[static_cast<std::size_t>(std::clamp(i, 0, count))];
  };
  JointPoint sum = width * raw.front();
  for (int i = 0; i < static_cast<int>(control.size()); ++i) {
    sum += at(i) - at(i - width);
    control[static_cast<std::size_t>(i)] = sum / width;
  }
  control.back() = raw.back();
  if (softened) soften(control, h, limits.jerk);
  const int last = static_cast<int>(control.size()) - 1;
  const auto c = [&](int i) -> const JointPoint& {
    return control[static_cast<std::size_t>(std::clamp(i, 0, last))];
  };
  TimedPath path;
  path.reserve(control.size() + 2);
  for (int i = -1; i <= last + 1; ++i) {
    path.push_back(
        {(i + 1) * h, (c(i - 1) + 4.0 * c(i) + c(i + 1)) / 6.0, (c(i + 1) - c(i - 1)) / (2.0 * h)});
  }
  const LimitUse use = limit_use(path, limits);
  const double slower =
      std::max({use.velocity, std::sqrt(use.acceleration), std::cbrt(use.jerk), 1e-3}) *
      (1.0 + 1e-9);
  slow_down(path, slower);
  return path;
}

void append_part(const RoundedPath& part, const Profile& profile, const TimingLimits& limits,
                 double h, TimedPath& path) {
  const double duration = profile.time.back();
  const int count = std::max(1, static_cast<int>(std::ceil(duration / h)));
  const double spacing = duration / count;
  std::vector<JointPoint> raw(static_cast<std::size_t>(count) + 1);
  JointPoint dq, ddq;
  std::size_t found = 0;
  for (int i = 0; i <= count; ++i)
    part.at(s_at(profile, i * spacing, found), raw[static_cast<std::size_t>(i)], dq, ddq);
  const double full_push = limits.acceleration.cwiseQuotient(limits.jerk).maxCoeff();
  int width = std::clamp(static_cast<int>(std::ceil(full_push / spacing)), 1, kLongest);
  TimedPath timed = spline(raw, width, spacing, true, limits);
  // Where softening alone does not do, at the ends, a longer average may be the shorter motion.
  while (width < kLongest && jerk_use(raw, width, spacing, limits.jerk) > kEnough) ++width;
  if (timed.back().time > (count + width + 1) * spacing) {
    TimedPath wider = spline(raw, width, spacing, false, limits);
    if (wider.back().time < timed.back().time) timed = std::move(wider);
  }
  const double start = path.empty() ? 0.0 : path.back().time;
  for (std::size_t i = path.empty() ? 0 : 1; i < timed.size(); ++i)
    path.push_back({start + timed[i].time, timed[i].q, timed[i].qd});
}

}  // namespace

double fastest_time(const std::vector<RoundedPath>& parts, const TimingLimits& limits,
                    double stride) {
  double sum = 0.0;
  for (const RoundedPath& part : parts) sum += fastest(part, limits, stride).time.back();
  return sum;
}

TimedPath time_path(const std::vector<RoundedPath>& parts, const TimingLimits& limits,
                    double knot_spacing, int most_knots) {
  TimedPath path;
  std::vector<Profile> profiles;
  double duration = 0.0;
  for (const RoundedPath& part : parts) {
    profiles.push_back(fastest(part, limits, kStride));
    coast(profiles.back(), limits.acceleration.cwiseQuotient(limits.jerk).maxCoeff());
    duration += profiles.back().time.back();
  }
  const int of_ends = (kLongest + 4) * static_cast<int>(parts.size());
  const double spacing =
      std::max(knot_spacing, duration / std::max(most_knots / 4, most_knots - of_ends));
  for (std::size_t i = 0; i < parts.size(); ++i)
    append_part(parts[i], profiles[i], limits, spacing, path);
  return path;
}

void slow_down(TimedPath& path, double factor) {
  for (Knot& knot : path) {
    knot.time *= factor;
    knot.qd /= factor;
  }
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

std::array<JointPoint, 4> bezier_between(const Knot& a, const Knot& b) {
  const double third = (b.time - a.time) / 3.0;
  return {a.q, a.q + third * a.qd, b.q - third * b.qd, b.q};
}

// The velocity of a cubic is largest at its ends or where its acceleration vanishes, the
// acceleration at its ends; the jerk is the same all along.
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
      use.jerk = std::max(use.jerk, std::abs(6.0 * d) / (h * h * h) / limits.jerk[k]);
      use.velocity = std::max(use.velocity, fastest / limits.velocity[k]);
      use.acceleration = std::max(use.acceleration, hardest / limits.acceleration[k]);
    }
  }
  return use;
}

}  // namespace twinbus::planner
