// The way between the frames of a motion: a uniform cubic B-spline, so that position, velocity and acceleration are
// continuous, and no value leaves what its four neighbouring frames span.
//
//     x(t) = sum_i b_i(u) c_(k+i),   i = -1 .. 2,   t = (k + u) h
//
// Beyond the ends it goes on straight.  Frames are control points: spline_frames() finds those whose curve passes through
// given values.

#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace twinbus::inline robot {

struct SplinePlace {
  std::array<int, 4> frame{};  // control points
  std::array<double, 4> position{}, velocity{},
      acceleration{};  // weights; of the last two per second, per second squared
};

// time [s] >= 0; frames >= 1; period: between frames [s].
inline SplinePlace spline_place(double time, int frames, double period) noexcept {
  const double along = std::clamp(time / period, 0.0, static_cast<double>(frames - 1));
  const int k = std::min(static_cast<int>(along), std::max(0, frames - 2));
  const double u = along - k, v = 1.0 - u, h = 1.0 / period;
  SplinePlace place;
  for (int i = 0; i < 4; ++i)
    place.frame[static_cast<std::size_t>(i)] = std::clamp(k + i - 1, 0, frames - 1);
  place.position = {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                    (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0};
  place.velocity = {-0.5 * v * v * h, (1.5 * u * u - 2.0 * u) * h, (-1.5 * v * v + 2.0 * v) * h,
                    0.5 * u * u * h};
  place.acceleration = {v * h * h, (3.0 * u - 2.0) * h * h, (3.0 * v - 2.0) * h * h, u * h * h};
  // c_(-1) = 2 c_0 - c_1, and so at the other end.
  const auto go_straight = [](std::array<double, 4>& w, std::size_t beyond, std::size_t inner) {
    w[inner] -= w[beyond];
    w[beyond] *= 2.0;
  };
  for (std::array<double, 4>* w : {&place.position, &place.velocity, &place.acceleration}) {
    if (frames > 1 && k == 0) go_straight(*w, 0, 2);
    if (frames > 1 && k == frames - 2) go_straight(*w, 3, 1);
  }
  return place;
}

// Values at the frames -> control points, in place: (c_(k-1) + 4 c_k + c_(k+1)) / 6 = x_k, solved by elimination; the first
// and the last are themselves.
inline void spline_frames(std::vector<double>& x) {
  const std::size_t n = x.size();
  if (n < 3) return;
  std::vector<double> upper(n, 0.0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double diagonal = 4.0 - upper[k - 1];
    upper[k] = 1.0 / diagonal;
    x[k] = (6.0 * x[k] - x[k - 1]) / diagonal;
  }
  for (std::size_t k = n - 2; k > 0; --k) x[k] -= upper[k] * x[k + 1];
}

}  // namespace twinbus::robot
