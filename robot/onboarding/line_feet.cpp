#include "robot/onboarding/line_feet.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline robot {

namespace {

constexpr double kLonger = 4.0;    // than wide
constexpr double kNarrow = 0.025;  // wider is a sole [m]
constexpr double kLies = 0.2;      // sine: so level an axis lies
constexpr double kTouches = 0.003, kThin = 0.001;  // above the lowest point [m]
constexpr double kShortest = 0.03;                 // of a line; what is shorter is a point [m]

bool is_line(double along, double across) noexcept {
  const double longer = std::max(along, across), shorter = std::min(along, across);
  return longer >= kShortest && shorter <= kNarrow && longer >= kLonger * shorter;
}

// Of the round shapes that touch; empty if anything else does.
Eigen::AlignedBox2d round_contact(const Link& link, const Eigen::Isometry3d& pose, double ground) {
  Eigen::AlignedBox2d box;
  for (const Shape& shape : link.collision) {
    const Eigen::Isometry3d at = pose * shape.pose;
    if (shape.kind == ShapeKind::kSphere) {
      if (at.translation().z() - shape.size.x() < ground + kTouches) box.extend(at.translation().head<2>());
      continue;
    }
    if (shape.kind != ShapeKind::kCylinder) continue;
    const Eigen::Vector3d axis = at.linear().col(2);
    if (std::abs(axis.z()) > kLies) continue;
    for (const double end : {-0.5, 0.5}) {
      const Eigen::Vector3d place = at.translation() + end * shape.size.y() * axis;
      if (place.z() - shape.size.x() < ground + kTouches) box.extend(place.head<2>());
    }
  }
  return box;
}

// What lies so near to the ground is of a flat shape.
bool flat_contact(const Link& link, const Eigen::Isometry3d& pose, double ground) {
  return std::any_of(link.collision.begin(), link.collision.end(), [&](const Shape& shape) {
    if (shape.kind != ShapeKind::kBox) return shape.kind == ShapeKind::kMesh;
    const Eigen::Isometry3d at = pose * shape.pose;
    return at.translation().z() - 0.5 * (at.linear().row(2).cwiseAbs() * shape.size).value() < ground + kTouches;
  });
}

}  // namespace

bool is_line(const Sole& sole) noexcept { return is_line(sole.front + sole.back, sole.left + sole.right); }

std::optional<Eigen::AlignedBox2d> line_on_ground(const Link& link, const Eigen::Isometry3d& pose,
                                                  const std::vector<Eigen::Vector3d>& points, double ground) {
  Eigen::AlignedBox2d box = round_contact(link, pose, ground);
  if (!box.isEmpty() && !flat_contact(link, pose, ground)) {
    if (is_line(box.sizes().x(), box.sizes().y())) return box;
    return std::nullopt;
  }
  box.setEmpty();
  for (const Eigen::Vector3d& point : points) {
    if (point.z() < ground + kThin) box.extend(point.head<2>());
  }
  if (box.isEmpty() || !is_line(box.sizes().x(), box.sizes().y()) || box.sizes().x() < box.sizes().y()) return std::nullopt;
  return box;
}

}  // namespace twinbus::robot
