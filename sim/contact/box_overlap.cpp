#include "sim/contact/box_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinbus {

namespace {
constexpr double kParallel = 1e-6;  // sine of two edges that span no axis of their own
}

double box_overlap(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a, const Eigen::Isometry3d& b,
                   const Eigen::Vector3d& half_b) noexcept {
  const Eigen::Matrix3d turn = a.linear().transpose() * b.linear();
  const Eigen::Matrix3d size = turn.cwiseAbs();
  const Eigen::Vector3d apart = a.linear().transpose() * (b.translation() - a.translation());
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, half_a[i] + size.row(i).dot(half_b) - std::abs(apart[i]));
    least = std::min(least, half_b[i] + size.col(i).dot(half_a) - std::abs(turn.col(i).dot(apart)));
    if (!(least > 0.0)) return least;
  }
  // Along a_i x b_j, in A's axes.
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double sine = std::sqrt(turn(i1, j) * turn(i1, j) + turn(i2, j) * turn(i2, j));
      if (!(sine > kParallel)) continue;
      const double reach = half_a[i1] * size(i2, j) + half_a[i2] * size(i1, j) +
                           half_b[j1] * size(i, j2) + half_b[j2] * size(i, j1);
      const double way = std::abs(apart[i2] * turn(i1, j) - apart[i1] * turn(i2, j));
      least = std::min(least, (reach - way) / sine);
    }
  }
  return least;
}

}  // namespace twinbus
