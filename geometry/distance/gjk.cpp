#include "geometry/distance/gjk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/distance/gjk_support.h"
#include "geometry/distance/support_cells.h"
#include "common/simd/vec4.h"

namespace twinbus::inline geometry {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Of fewer points than these all are looked at; of more it would take long to find where each is farthest.
constexpr std::size_t kFewPoints = 8, kManyPoints = 512;

struct Corner {  // of the difference of the shapes
  Vec4 v, on_a, on_b;
};

// The corners that hold the point nearest to zero, and its weights.
struct Nearest {
  Vec4 point{};
  int count = 0;
  int corner[3] = {};
  double weight[3] = {};
  bool inside = false;  // zero is inside the tetrahedron
};

TWINBUS_INLINE Nearest of_corner(const Corner* c, int i) noexcept {
  return {c[i].v, 1, {i, 0, 0}, {1.0, 0.0, 0.0}, false};
}

TWINBUS_INLINE Nearest of_edge(const Corner* c, int i, int j) noexcept {
  const Vec4 edge = c[j].v - c[i].v;
  const double length2 = dot3(edge, edge);
  const double t = -dot3(c[i].v, edge);
  if (!(t > 0.0)) return of_corner(c, i);
  if (!(t < length2)) return of_corner(c, j);
  const double s = t / length2;
  return {c[i].v + s * edge, 2, {i, j, 0}, {1.0 - s, s, 0.0}, false};
}

// Which of the regions around the triangle zero is in (Ericson, Real-Time Collision Detection, 5.1.5).
TWINBUS_INLINE Nearest of_triangle(const Corner* c, int i, int j, int k) noexcept {
  const Vec4 p = c[i].v, q = c[j].v, r = c[k].v;
  const Vec4 ab = q - p, ac = r - p;
  // The three corners by coordinate: six products of them with the edges at once.
  const Vec4 x = {p[0], q[0], r[0], 0.0}, y = {p[1], q[1], r[1], 0.0}, z = {p[2], q[2], r[2], 0.0};
  const Vec4 along_ab = -(x * ab[0] + y * ab[1] + z * ab[2]);
  const Vec4 along_ac = -(x * ac[0] + y * ac[1] + z * ac[2]);
  const double d1 = along_ab[0], d2 = along_ac[0];
  if (d1 <= 0.0 && d2 <= 0.0) return of_corner(c, i);
  const double d3 = along_ab[1], d4 = along_ac[1];
  if (d3 >= 0.0 && d4 <= d3) return of_corner(c, j);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return of_edge(c, i, j);
  const double d5 = along_ab[2], d6 = along_ac[2];
  if (d6 >= 0.0 && d5 <= d6) return of_corner(c, k);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return of_edge(c, i, k);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return of_edge(c, j, k);
  const double scale = 1.0 / (va + vb + vc);
  const double s = vb * scale, t = vc * scale;
  // Along the normal, which rounding harms less than the sum of the corners.
  const Vec4 normal = cross4(ab, ac);
  const Vec4 point = normal * (dot3(normal, p) / dot3(normal, normal));
  return {point, 3, {i, j, k}, {1.0 - s - t, s, t}, false};
}

TWINBUS_INLINE Nearest of_tetrahedron(const Corner* c) noexcept {
  constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  Nearest best;
  double least = 1e300;
  bool inside = true;
  for (const auto& f : kFaces) {
    const Vec4 p = c[f[0]].v;
    const Vec4 normal = cross4(c[f[1]].v - p, c[f[2]].v - p);
    const double zero = -dot3(normal, p);
    const double other = dot3(normal, c[f[3]].v - p);
    if (zero * other > 0.0) continue;  // zero is on the side of the fourth corner
    inside = false;
    const Nearest face = of_triangle(c, f[0], f[1], f[2]);
    const double d = dot3(face.point, face.point);
    if (d < least) {
      least = d;
      best = face;
    }
  }
  best.inside = inside;
  return best;
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
    shape.half = shape.half.cwiseMax(p.cwiseAbs());
  }
  if (n > kFewPoints && n <= kManyPoints) shape.cells = support_cells(points);
  for (std::size_t cell = 0; cell < kSupportCells && !shape.cells.empty(); ++cell) {
    if (shape.cells.size(cell) > kMostInARow) shape.cells = {};  // nearly all of them in one direction
  }
  return shape;
}

// The point of the shape nearest to p, in its axes; not of a mesh.
static Vector3d nearest_to(const GjkShape& s, const Vector3d& p) noexcept {
  if (s.kind == ShapeKind::kBox) return p.cwiseMin(s.half).cwiseMax(-s.half);
  if (s.kind == ShapeKind::kSphere) return Vector3d::Zero();
  const double across = std::sqrt(p.x() * p.x() + p.y() * p.y());
  const double scale = across > s.half.x() ? s.half.x() / across : 1.0;
  return {scale * p.x(), scale * p.y(), std::clamp(p.z(), -s.half.y(), s.half.y())};
}

// A ball is as far away as its centre, less its radius; no search is needed.
static GjkResult to_ball(const GjkShape& a, const Eigen::Isometry3d& pose_a, const GjkShape& ball,
                         const Vector3d& center) noexcept {
  const Vector3d in_a = pose_a.linear().transpose() * (center - pose_a.translation());
  const Vector3d on_a = nearest_to(a, in_a);
  const double length = (in_a - on_a).norm(), radius = skin(ball), skins = skin(a) + radius;
  if (!(length > skins + kGjkTouching)) return {};
  GjkResult result;
  const Vector3d normal = (in_a - on_a) / length;
  result.distance = result.below = length - skins;
  result.point_a = pose_a * Vector3d(on_a + skin(a) * normal);
  result.normal = pose_a.linear() * normal;
  result.point_b = center - radius * result.normal;
  return result;
}

// What the search leaves: the corners that hold the nearest point.
struct Search {
  Corner corner[4], kept[3];
  Nearest nearest;
  double length = 0.0, below = 0.0;
  bool far = false;
};

TWINBUS_AVX2_CLONES
static void search(const GjkShape& a, const GjkShape& b, const double (&to_a)[4][4], double far,
                   double close, const double (&first)[4], Search& found) noexcept {
  const Vec4 column[3] = {load4(to_a[0]), load4(to_a[1]), load4(to_a[2])};
  const Vec4 shift = load4(to_a[3]);
  const Vec4 row[3] = {{to_a[0][0], to_a[1][0], to_a[2][0], 0.0},
                       {to_a[0][1], to_a[1][1], to_a[2][1], 0.0},
                       {to_a[0][2], to_a[1][2], to_a[2][2], 0.0}};
  // Along -p, of a minus b.
  const auto look = [&](const Vec4& p, Corner& c) __attribute__((always_inline)) {
    c.on_a = support(a, -p);
    const Vec4 on_b = support(b, row[0] * p[0] + row[1] * p[1] + row[2] * p[2]);
    c.on_b = column[0] * on_b[0] + column[1] * on_b[1] + column[2] * on_b[2] + shift;
    c.v = c.on_a - c.on_b;
  };
  Corner(&corner)[4] = found.corner;
  Nearest& nearest = found.nearest;
  look(-load4(first), corner[0]);
  nearest = of_corner(corner, 0);
  int count = 1;
  double length = std::sqrt(dot3(nearest.point, nearest.point));
  const double said = -dot3(load4(first), corner[0].v);
  found.below = said > 0.0 ? said / std::sqrt(dot3(load4(first), load4(first))) : 0.0;
  found.far = found.below > far;
  if (found.far) return;
  for (int step = 0; step < kGjkMostSteps && length > kGjkTouching; ++step) {
    Corner next;
    look(nearest.point, next);
    const double below = dot3(nearest.point, next.v) / length;
    if (below > found.below) found.below = below;
    if (below > far) {
      found.far = true;
      return;
    }
    if (length - below <= close) break;
    bool known = false;
    for (int i = 0; i < count; ++i) {
      const Vec4 same = corner[i].v - next.v;
      known = known || dot3(same, same) == 0.0;
    }
    if (known) break;
    corner[count++] = next;
    const Nearest better = count == 2   ? of_edge(corner, 0, 1)
                           : count == 3 ? of_triangle(corner, 0, 1, 2)
                                        : of_tetrahedron(corner);
    if (better.inside) {
      length = 0.0;
      break;
    }
    const double now = std::sqrt(dot3(better.point, better.point));
    if (!(now < length)) break;  // rounding: what was found is as good as it gets
    nearest = better;
    length = now;
    count = nearest.count;
    for (int i = 0; i < count; ++i) found.kept[i] = corner[nearest.corner[i]];
    for (int i = 0; i < count; ++i) {
      corner[i] = found.kept[i];
      nearest.corner[i] = i;
    }
  }
  found.length = length;
}

GjkResult gjk_distance(const GjkShape& a, const Eigen::Isometry3d& pose_a, const GjkShape& b,
                       const Eigen::Isometry3d& pose_b, double far, const Vector3d& towards_b,
                       double close) noexcept {
  if (b.kind == ShapeKind::kSphere && a.kind != ShapeKind::kMesh)
    return to_ball(a, pose_a, b, pose_b.translation());
  if (a.kind == ShapeKind::kSphere && b.kind != ShapeKind::kMesh) {
    GjkResult result = to_ball(b, pose_b, a, pose_a.translation());
    std::swap(result.point_a, result.point_b);
    result.normal = -result.normal;
    return result;
  }
  // In the axes of a.
  double to_a[4][4] = {}, first[4] = {};
  const Matrix3d turn = pose_a.linear().transpose() * pose_b.linear();
  const Vector3d shift =
      pose_a.linear().transpose() * (pose_b.translation() - pose_a.translation());
  const Vector3d towards = towards_b.squaredNorm() > 0.0 ? towards_b : shift;
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < 3; ++k) to_a[k][d] = turn(d, k);
    to_a[3][d] = shift[d];
    first[d] = towards[d];
  }
  const double skins = skin(a) + skin(b);
  Search found;
  search(a, b, to_a, far + skins, close, first, found);
  GjkResult result;
  if (found.far) {
    result.below = found.below - skins;
    result.distance = std::max(result.below, 0.0);
    return result;
  }
  const double length = found.length;
  if (!(length > kGjkTouching)) return {};  // cores overlap
  result.below = std::max(found.below, 0.0) - skins;
  if (!(length > skins)) return {};
  Vec4 on_a{}, on_b{};
  for (int i = 0; i < found.nearest.count; ++i) {
    on_a += found.nearest.weight[i] * found.corner[i].on_a;
    on_b += found.nearest.weight[i] * found.corner[i].on_b;
  }
  const Vector3d normal = vector3(-found.nearest.point / length);
  result.distance = length - skins;
  result.point_a = pose_a * Vector3d(vector3(on_a) + skin(a) * normal);
  result.point_b = pose_a * Vector3d(vector3(on_b) - skin(b) * normal);
  result.normal = pose_a.linear() * normal;
  return result;
}

}  // namespace twinbus::geometry
