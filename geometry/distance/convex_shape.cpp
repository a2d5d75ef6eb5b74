#include "geometry/distance/convex_shape.h"

#include <cmath>

namespace twinbus::inline geometry {

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

// Both shapes in the axes of the first.
struct Together {
  const ConvexShape& a;
  const ConvexShape& b;
  Eigen::Matrix3d turn;  // from b's axes
  Vector3d between;

  double separation(const Vector3d& n) const {
    return n.dot(between) - a.extent(n) - b.extent(turn.transpose() * n);
  }
  // The shapes are symmetric: of a direction and its opposite the one towards b is better.
  void consider(const Vector3d& direction, Best& best) const {
    const double length = direction.norm();
    if (!(length > 1e-9)) return;
    const Vector3d n = (direction.dot(between) < 0.0 ? -1.0 : 1.0) / length * direction;
    const double value = separation(n);
    if (value > best.value) best = {n, value};
  }
  // Directions in which the surface of a shape faces, as far as they are few; and towards the other.
  void consider_faces(const ConvexShape& shape, const Eigen::Matrix3d& axes, Best& best) const {
    if (shape.kind == ShapeKind::kSphere) return;
    if (shape.kind == ShapeKind::kCylinder) {
      const Vector3d axis = axes.col(2);
      consider(axis, best);
      consider(between - axis.dot(between) * axis, best);
      return;
    }
    for (int k = 0; k < 3; ++k) consider(axes.col(k), best);
  }
};

bool flat(const ConvexShape& shape) {
  return shape.kind == ShapeKind::kBox || shape.kind == ShapeKind::kMesh;
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

Vector3d way_out(const PlacedShape& first, const PlacedShape& second) noexcept {
  const Eigen::Matrix3d to_a = first.pose->linear().transpose();
  const Together t{*first.shape, *second.shape, to_a * second.pose->linear(),
                   to_a * (second.pose->translation() - first.pose->translation())};
  Best best;
  t.consider(Vector3d::UnitZ(), best);
  t.consider(t.between, best);
  t.consider_faces(t.a, Eigen::Matrix3d::Identity(), best);
  t.consider_faces(t.b, t.turn, best);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) t.consider(Vector3d::Unit(i).cross(t.turn.col(k)), best);
  }
  // Of boxes these are all there are.  Else: the gradient of separation(n) is the vector between the
  // support points.
  double step = flat(t.a) && flat(t.b) ? 0.0 : 1.0;  // [1/m], shrinks when it overshoots
  for (int i = 0; i < 16 && step > 1e-3; ++i) {
    const Vector3d& n = best.n;
    const Vector3d gap = t.between - t.a.support(n) + t.turn * t.b.support(t.turn.transpose() * n);
    const Vector3d next = (n + step * (gap - n.dot(gap) * n)).normalized();
    const double value = t.separation(next);
    if (value > best.value) {
      best = {next, value};
    } else {
      step *= 0.4;
    }
  }
  return first.pose->linear() * best.n;
}

}  // namespace twinbus::geometry
