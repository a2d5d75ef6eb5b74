#include "robot/estimation/support_polygon.h"

#include <algorithm>
#include <limits>

namespace twinbus::inline robot {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void SupportPolygon::add(const Eigen::Vector2d& point) noexcept {
  if (count_ < kCapacity) points_[static_cast<std::size_t>(count_++)] = point;
}

void SupportPolygon::add(const Sole& sole, const Eigen::Isometry3d& frame) noexcept {
  for (const double x : {sole.front, -sole.back}) {
    for (const double y : {sole.left, -sole.right}) add((frame * Eigen::Vector3d(x, y, 0.0)).head<2>());
  }
}

// Andrew's monotone chain.
void SupportPolygon::finish() noexcept {
  if (count_ < 3) return;
  std::array<Eigen::Vector2d, kCapacity> sorted;
  const auto n = static_cast<std::size_t>(count_);
  std::copy_n(points_.begin(), n, sorted.begin());
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n),
            [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
              return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
            });
  std::size_t k = 0;
  const auto push = [&](const Eigen::Vector2d& p, std::size_t floor) {
    while (k >= floor && cross(points_[k - 1] - points_[k - 2], p - points_[k - 2]) <= 0.0) --k;
    points_[k++] = p;
  };
  for (std::size_t i = 0; i < n; ++i) push(sorted[i], 2);
  const std::size_t lower = k + 1;
  for (std::size_t i = n - 1; i-- > 0;) push(sorted[i], lower);
  count_ = static_cast<int>(k) - 1;  // the last one is the first again
}

double SupportPolygon::margin(const Eigen::Vector2d& point) const noexcept {
  if (count_ < 3) return -1.0;
  double inside = std::numeric_limits<double>::infinity();   // smallest distance to an edge's line
  double outside = std::numeric_limits<double>::infinity();  // distance to the nearest edge
  for (int i = 0; i < count_; ++i) {
    const Eigen::Vector2d& a = corner(i);
    const Eigen::Vector2d edge = corner((i + 1) % count_) - a;
    const Eigen::Vector2d to_point = point - a;
    const double length = edge.norm();
    if (!(length > 0.0)) continue;
    inside = std::min(inside, cross(edge, to_point) / length);
    const double along = std::clamp(edge.dot(to_point) / (length * length), 0.0, 1.0);
    outside = std::min(outside, (to_point - along * edge).norm());
  }
  return inside >= 0.0 ? inside : -outside;
}

Eigen::Vector2d SupportPolygon::centre() const noexcept {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double area = 0.0;
  for (int i = 1; i + 1 < count_; ++i) {
    const double part = cross(corner(i) - corner(0), corner(i + 1) - corner(0));
    sum += part / 3.0 * (corner(0) + corner(i) + corner(i + 1));
    area += part;
  }
  if (area > 0.0) return sum / area;
  return count_ > 0 ? corner(0) : Eigen::Vector2d::Zero();
}

}  // namespace twinbus::robot
