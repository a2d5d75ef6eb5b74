#include "robot/convex_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr double kSquare = 1e-3;  // below this cosine a direction counts as square to an axis

double signed_half(double n, double half) {
  return n > kSquare ? half : (n < -kSquare ? -half : 0.0);
}

struct Best {
  Vector3d n = Vector3d::UnitZ();
  double value = -1e300;
};

void try_direction(const PlacedShape& a, const PlacedShape& b, const Vector3d& direction,
                   Best& best) {
  const double length = direction.norm();
  if (!(length > 1e-9)) return;
  const Vector3d n = direction / length;
  for (const double sign : {1.0, -1.0}) {
    const double value = separation(a, b, sign * n);
    if (value > best.value) best = {sign * n, value};
  }
}

// Directions in which the surface of a shape faces, as far as they are few; and towards `other`.
void try_faces(const PlacedShape& self, const PlacedShape& a, const PlacedShape& b,
               const Vector3d& between, Best& best) {
  if (self.shape->kind == ShapeKind::kSphere) return;
  const Eigen::Matrix3d axes = self.pose->linear();
  if (self.shape->kind == ShapeKind::kCylinder) {
    const Vector3d axis = axes.col(2);
    try_direction(a, b, axis, best);
    try_direction(a, b, between - axis.dot(between) * axis, best);
    return;
  }
  for (int k = 0; k < 3; ++k) try_direction(a, b, axes.col(k), best);
}

}  // namespace

double ConvexShape::extent(const Vector3d& n) const noexcept {
  switch (kind) {
    case ShapeKind::kSphere:
      return half.x();
    case ShapeKind::kCylinder:
      return half.x() * std::sqrt(n.x() * n.x() + n.y() * n.y()) + half.y() * std::abs(n.z());
    case ShapeKind::kBox:
    case ShapeKind::kMesh:
      break;
  }
  return half.x() * std::abs(n.x()) + half.y() * std::abs(n.y()) + half.z() * std::abs(n.z());
}

Vector3d ConvexShape::support(const Vector3d& n) const noexcept {
  switch (kind) {
    case ShapeKind::kSphere:
      return half.x() * n;
    case ShapeKind::kCylinder: {
      const double across = std::sqrt(n.x() * n.x() + n.y() * n.y());
      const double scale = across > kSquare ? half.x() / across : 0.0;
      return {scale * n.x(), scale * n.y(), signed_half(n.z(), half.y())};
    }
    case ShapeKind::kBox:
    case ShapeKind::kMesh:
      break;
  }
  return {signed_half(n.x(), half.x()), signed_half(n.y(), half.y()), signed_half(n.z(), half.z())};
}

double ConvexShape::radius() const noexcept {
  switch (kind) {
    case ShapeKind::kSphere:
      return half.x();
    case ShapeKind::kCylinder:
      return std::hypot(half.x(), half.y());
    case ShapeKind::kBox:
    case ShapeKind::kMesh:
      break;
  }
  return half.norm();
}

double separation(const PlacedShape& a, const PlacedShape& b, const Vector3d& n) noexcept {
  const Vector3d between = b.pose->translation() - a.pose->translation();
  return n.dot(between) - a.shape->extent(a.pose->linear().transpose() * n) -
         b.shape->extent(b.pose->linear().transpose() *
                         n);  // the shapes are symmetric: h(-n) = h(n)
}

Vector3d way_out(const PlacedShape& a, const PlacedShape& b) noexcept {
  const Vector3d between = b.pose->translation() - a.pose->translation();
  Best best;
  try_direction(a, b, Vector3d::UnitZ(), best);
  try_direction(a, b, between, best);
  try_faces(a, a, b, between, best);
  try_faces(b, a, b, between, best);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d edge = a.pose->linear().col(i);
      try_direction(a, b, edge.cross(b.pose->linear().col(k)), best);
    }
  }
  // The gradient of separation(n) is the vector between the support points.
  double step = 1.0;  // [1/m], shrinks when it overshoots
  for (int i = 0; i < 16; ++i) {
    const Vector3d& n = best.n;
    const Vector3d gap = between -
                         a.pose->linear() * a.shape->support(a.pose->linear().transpose() * n) +
                         b.pose->linear() * b.shape->support(b.pose->linear().transpose() * n);
    const Vector3d uphill = gap - n.dot(gap) * n;
    const Vector3d next = (n + step * uphill).normalized();
    const double value = separation(a, b, next);
    if (value > best.value) {
      best = {next, value};
    } else {
      step *= 0.4;
    }
  }
  return best.n;
}

}  // namespace twinbus
