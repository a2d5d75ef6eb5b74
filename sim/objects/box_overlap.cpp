#include "sim/objects/box_overlap.h"

#include <cmath>
#include <limits>

#include "common/math/index.h"

namespace twinbus::inline sim {

namespace {

constexpr double kParallel = 1e-6;  // sine of two edges that span no axis of their own
constexpr double kFaceFirst = 0.95;  // of a face's depth: only an edge's that is less is taken instead

struct Polygon {
  std::array<Eigen::Vector3d, 16> point;
  int count = 0;
};

// What is left of it where sign * x[axis] <= most.
Polygon cut(const Polygon& whole, int axis, double sign, double most) noexcept {
  Polygon left;
  for (int i = 0; i < whole.count; ++i) {
    const Eigen::Vector3d& p = whole.point[at(i)];
    const Eigen::Vector3d& q = whole.point[at((i + 1) % whole.count)];
    const double of_p = sign * p[axis] - most, of_q = sign * q[axis] - most;
    if (of_p <= 0.0 && left.count < 16) left.point[at(left.count++)] = p;
    if ((of_p < 0.0) != (of_q < 0.0) && of_p != 0.0 && of_q != 0.0 && left.count < 16)
      left.point[at(left.count++)] = p + of_p / (of_p - of_q) * (q - p);
  }
  return left;
}

// Points of `other` under the face of `box` that looks along out, in the frame of the poses.
void under_face(const Eigen::Isometry3d& box, const Eigen::Vector3d& half, int axis,
                const Eigen::Vector3d& out, const Eigen::Isometry3d& other,
                const Eigen::Vector3d& other_half, BoxOverlap& overlap) noexcept {
  const Eigen::Vector3d facing = other.linear().transpose() * out;
  int face = 0;
  facing.cwiseAbs().maxCoeff(&face);
  const int u = (face + 1) % 3, v = (face + 2) % 3;
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  corner[face] = facing[face] > 0.0 ? -other_half[face] : other_half[face];
  const Eigen::Isometry3d other_in_box = box.inverse(Eigen::Isometry) * other;
  Polygon polygon;
  for (const auto& [x, y] : {std::array{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
    corner[u] = x * other_half[u];
    corner[v] = y * other_half[v];
    polygon.point[at(polygon.count++)] = other_in_box * corner;
  }
  for (int side = 1; side <= 2; ++side) {
    const int across = (axis + side) % 3;
    polygon = cut(polygon, across, 1.0, half[across]);
    polygon = cut(polygon, across, -1.0, half[across]);
  }
  const double sign = out.dot(box.linear().col(axis)) > 0.0 ? 1.0 : -1.0;
  for (int i = 0; i < polygon.count && overlap.count < BoxOverlap::kMost; ++i) {
    const double deep = half[axis] - sign * polygon.point[at(i)][axis];
    if (!(deep > 0.0)) continue;
    overlap.deep[at(overlap.count)] = deep;
    overlap.point[at(overlap.count++)] = box * polygon.point[at(i)] + 0.5 * deep * out;
  }
}

// The middle of the edge of a box along an axis that lies farthest in a direction.
Eigen::Vector3d edge_towards(const Eigen::Isometry3d& box, const Eigen::Vector3d& half, int axis,
                             const Eigen::Vector3d& to) noexcept {
  Eigen::Vector3d middle = box.translation();
  for (int side = 1; side <= 2; ++side) {
    const int k = (axis + side) % 3;
    middle += (to.dot(box.linear().col(k)) > 0.0 ? half[k] : -half[k]) * box.linear().col(k);
  }
  return middle;
}

}  // namespace

BoxOverlap box_overlap(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a,
                       const Eigen::Isometry3d& b, const Eigen::Vector3d& half_b) noexcept {
  const Eigen::Matrix3d turn = a.linear().transpose() * b.linear();
  const Eigen::Matrix3d size = turn.cwiseAbs();
  const Eigen::Vector3d apart = a.linear().transpose() * (b.translation() - a.translation());
  BoxOverlap result;
  result.depth = std::numeric_limits<double>::infinity();
  Eigen::Vector3d out = Eigen::Vector3d::UnitX();  // A's axes, from A to B
  const auto better = [&](double depth, double way, int axis, const Eigen::Vector3d& along) {
    result.depth = depth;
    result.axis = axis;
    out = way < 0.0 ? Eigen::Vector3d(-along) : along;
  };
  for (int i = 0; i < 3; ++i) {
    const double of_a = half_a[i] + size.row(i).dot(half_b) - std::abs(apart[i]);
    if (of_a < result.depth) better(of_a, apart[i], i, Eigen::Vector3d::Unit(i));
    const double way = turn.col(i).dot(apart);
    const double of_b = half_b[i] + size.col(i).dot(half_a) - std::abs(way);
    if (of_b < result.depth) better(of_b, way, 3 + i, turn.col(i));
  }
  // Along a_i x b_j, in A's axes; first of all whether it keeps them apart.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Eigen::Vector3d along = Eigen::Vector3d::Unit(i).cross(turn.col(j));
      const double sine = along.norm();
      if (!(sine > kParallel)) continue;
      along /= sine;
      const double way = along.dot(apart);
      const double depth = half_a.dot(along.cwiseAbs()) +
                           half_b.dot((turn.transpose() * along).cwiseAbs()) - std::abs(way);
      const bool takes = depth < 0.0 || result.axis >= 6 ? depth < result.depth
                                                         : depth < kFaceFirst * result.depth;
      if (takes) better(depth, way, 6 + 3 * i + j, along);
    }
  }
  result.normal = -(a.linear() * out);
  return result;
}

void box_contact(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a,
                 const Eigen::Isometry3d& b, const Eigen::Vector3d& half_b,
                 BoxOverlap& overlap) noexcept {
  overlap.count = 0;
  if (!(overlap.depth > 0.0)) return;
  const Eigen::Vector3d& n = overlap.normal;
  if (overlap.axis < 3) {
    under_face(a, half_a, overlap.axis, -n, b, half_b, overlap);
  } else if (overlap.axis < 6) {
    under_face(b, half_b, overlap.axis - 3, n, a, half_a, overlap);
  } else {
    const int i = (overlap.axis - 6) / 3, j = (overlap.axis - 6) % 3;
    const Eigen::Vector3d p = edge_towards(a, half_a, i, -n), q = edge_towards(b, half_b, j, n);
    const Eigen::Vector3d u = a.linear().col(i), v = b.linear().col(j), w = q - p;
    const double uv = u.dot(v), det = 1.0 - uv * uv;
    const double s = (u.dot(w) - uv * v.dot(w)) / det, t = (uv * u.dot(w) - v.dot(w)) / det;
    overlap.point[0] = 0.5 * (p + s * u + q + t * v);
    overlap.deep[0] = overlap.depth;
    overlap.count = 1;
  }
}

}  // namespace twinbus::sim
