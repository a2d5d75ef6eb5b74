#include "robot/gjk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/vec4.h"

namespace twinbus {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kConverged = 1e-9;  // upper and lower bound agree to this [m]
constexpr double kTouching = 1e-12;  // [m]
constexpr int kMostSteps = 64;

struct Corner {  // of the difference of the shapes
  Vector3d v, on_a, on_b;
};

// The corners that hold the point nearest to zero, and its weights.
struct Nearest {
  Vector3d point = Vector3d::Zero();
  int count = 0;
  std::array<int, 3> corner{};
  std::array<double, 3> weight{};
  bool inside = false;  // zero is inside the tetrahedron
};

Nearest of_corner(const Corner* c, int i) { return {c[i].v, 1, {i, 0, 0}, {1.0, 0.0, 0.0}, false}; }

Nearest of_edge(const Corner* c, int i, int j) {
  const Vector3d edge = c[j].v - c[i].v;
  const double length2 = edge.squaredNorm();
  const double t = -c[i].v.dot(edge);
  if (!(t > 0.0)) return of_corner(c, i);
  if (!(t < length2)) return of_corner(c, j);
  const double s = t / length2;
  return {c[i].v + s * edge, 2, {i, j, 0}, {1.0 - s, s, 0.0}, false};
}

// Which of the regions around the triangle zero is in (Ericson, Real-Time Collision Detection, 5.1.5).
Nearest of_triangle(const Corner* c, int i, int j, int k) {
  const Vector3d ab = c[j].v - c[i].v, ac = c[k].v - c[i].v;
  const double d1 = -ab.dot(c[i].v), d2 = -ac.dot(c[i].v);
  if (d1 <= 0.0 && d2 <= 0.0) return of_corner(c, i);
  const double d3 = -ab.dot(c[j].v), d4 = -ac.dot(c[j].v);
  if (d3 >= 0.0 && d4 <= d3) return of_corner(c, j);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return of_edge(c, i, j);
  const double d5 = -ab.dot(c[k].v), d6 = -ac.dot(c[k].v);
  if (d6 >= 0.0 && d5 <= d6) return of_corner(c, k);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return of_edge(c, i, k);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return of_edge(c, j, k);
  const double sum = va + vb + vc;
  const double s = vb / sum, t = vc / sum;
  // Along the normal, which rounding harms less than the sum of the corners.
  const Vector3d normal = ab.cross(ac);
  const Vector3d point = normal * (normal.dot(c[i].v) / normal.squaredNorm());
  return {point, 3, {i, j, k}, {1.0 - s - t, s, t}, false};
}

Nearest of_tetrahedron(const Corner* c) {
  constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  Nearest best;
  double least = 1e300;
  bool inside = true;
  for (const auto& f : kFaces) {
    const Vector3d normal = (c[f[1]].v - c[f[0]].v).cross(c[f[2]].v - c[f[0]].v);
    const double zero = -normal.dot(c[f[0]].v);
    const double other = normal.dot(c[f[3]].v - c[f[0]].v);
    if (zero * other > 0.0) continue;  // zero is on the side of the fourth corner
    inside = false;
    const Nearest face = of_triangle(c, f[0], f[1], f[2]);
    const double d = face.point.squaredNorm();
    if (d < least) {
      least = d;
      best = face;
    }
  }
  best.inside = inside;
  return best;
}

// The point of the hull farthest along d.
TWINBUS_AVX2_CLONES
std::size_t farthest(const double* x, std::size_t n, double dx, double dy, double dz) noexcept {
  const double* y = x + n;
  const double* z = y + n;
  Vec4 best = load4(x) * dx + load4(y) * dy + load4(z) * dz;
  Int4 where{0, 1, 2, 3}, now = where;
  for (std::size_t i = 4; i < n; i += 4) {
    now += 4;
    const Vec4 value = load4(x + i) * dx + load4(y + i) * dy + load4(z + i) * dz;
    const Int4 better = value > best;
    best = better ? value : best;
    where = better ? now : where;
  }
  int lane = 0;
  for (int k = 1; k < 4; ++k) {
    if (best[k] > best[lane]) lane = k;
  }
  return static_cast<std::size_t>(where[lane]);
}

// Without the radius of a sphere.
Vector3d support(const GjkShape& s, const Vector3d& d) noexcept {
  switch (s.kind) {
    case ShapeKind::kSphere:
      return Vector3d::Zero();
    case ShapeKind::kBox:
      return {std::copysign(s.half.x(), d.x()), std::copysign(s.half.y(), d.y()),
              std::copysign(s.half.z(), d.z())};
    case ShapeKind::kCylinder: {
      const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
      const double scale = across > 1e-12 ? s.half.x() / across : 0.0;
      return {scale * d.x(), scale * d.y(), std::copysign(s.half.y(), d.z())};
    }
    case ShapeKind::kMesh:
      break;
  }
  const std::size_t n = s.points.size() / 3;
  const std::size_t i = farthest(s.points.data(), n, d.x(), d.y(), d.z());
  return {s.points[i], s.points[n + i], s.points[2 * n + i]};
}

double skin(const GjkShape& s) noexcept { return s.kind == ShapeKind::kSphere ? s.half.x() : 0.0; }

}  // namespace

GjkShape gjk_hull(const std::vector<Vector3d>& points) {
  GjkShape shape;
  shape.kind = ShapeKind::kMesh;
  const std::size_t n = (points.size() + 3) / 4 * 4;
  shape.points.resize(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d& p = points[std::min(i, points.size() - 1)];
    for (std::size_t k = 0; k < 3; ++k) shape.points[k * n + i] = p[static_cast<int>(k)];
  }
  return shape;
}

GjkResult gjk_distance(const GjkShape& a, const Eigen::Isometry3d& pose_a, const GjkShape& b,
                       const Eigen::Isometry3d& pose_b, double far,
                       const Vector3d& towards_b) noexcept {
  // In the axes of a.
  const Matrix3d turn = pose_a.linear().transpose() * pose_b.linear();
  const Vector3d shift =
      pose_a.linear().transpose() * (pose_b.translation() - pose_a.translation());
  const double skins = skin(a) + skin(b);
  Corner corner[4];
  const auto look = [&](const Vector3d& d, Corner& c) {  // along d, of a minus b
    c.on_a = support(a, d);
    c.on_b = turn * support(b, -(turn.transpose() * d)) + shift;
    c.v = c.on_a - c.on_b;
  };
  look(towards_b.squaredNorm() > 0.0 ? towards_b : shift, corner[0]);
  Nearest nearest = of_corner(corner, 0);
  int count = 1;
  GjkResult result;
  double length = nearest.point.norm();
  result.below = -1e300;
  for (int step = 0; step < kMostSteps && length > kTouching; ++step) {
    Corner next;
    look(-nearest.point, next);
    const double below = nearest.point.dot(next.v) / length;
    if (below > result.below) result.below = below;
    if (below - skins > far) {
      result.below -= skins;
      result.distance = std::max(result.below, 0.0);
      return result;
    }
    if (length - below <= kConverged) break;
    bool known = false;
    for (int i = 0; i < count; ++i) known = known || corner[i].v == next.v;
    if (known) break;
    corner[count++] = next;
    const Nearest better = count == 2   ? of_edge(corner, 0, 1)
                           : count == 3 ? of_triangle(corner, 0, 1, 2)
                                        : of_tetrahedron(corner);
    if (better.inside) {
      length = 0.0;
      break;
    }
    const double now = better.point.norm();
    if (!(now < length)) break;  // rounding: what was found is as good as it gets
    nearest = better;
    length = now;
    Corner kept[3];
    for (int i = 0; i < nearest.count; ++i) {
      kept[i] = corner[nearest.corner[static_cast<std::size_t>(i)]];
      nearest.corner[static_cast<std::size_t>(i)] = i;
    }
    count = nearest.count;
    for (int i = 0; i < count; ++i) corner[i] = kept[i];
  }
  if (!(length > kTouching)) return {};  // cores overlap
  result.below = std::max(result.below, 0.0) - skins;
  if (!(length > skins)) return {};
  Vector3d on_a = Vector3d::Zero(), on_b = Vector3d::Zero();
  for (int i = 0; i < nearest.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    on_a += nearest.weight[k] * corner[nearest.corner[k]].on_a;
    on_b += nearest.weight[k] * corner[nearest.corner[k]].on_b;
  }
  const Vector3d normal = -nearest.point / length;
  result.distance = length - skins;
  result.point_a = pose_a * Vector3d(on_a + skin(a) * normal);
  result.point_b = pose_a * Vector3d(on_b - skin(b) * normal);
  result.normal = pose_a.linear() * normal;
  return result;
}

}  // namespace twinbus
