#include "geometry/bounds/coarse_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "geometry/bounds/convex_hull.h"
#include "common/math/index.h"
#include "geometry/shapes.h"
#include "common/simd/vec4.h"

namespace twinbus::inline geometry {

namespace {

constexpr int kHullDirections = 50;   // corners to begin with
constexpr std::size_t kAtOnce = 8;    // corners that a round adds
constexpr double kHullRoom = 1e-6;    // against rounding, of the extent
constexpr double kSharp = 0.25;       // cosine: a corner sharper than this is not moved farther
constexpr double kMostShare = 10.0;   // of what sticks out: what must be moved farther is nearly flat

using Eigen::Vector3d;

// Evenly spread over the sphere.
Vector3d hull_direction(int i) {
  const double z = 1.0 - (2.0 * i + 1.0) / kHullDirections;
  const double turn = std::numbers::pi * (1.0 + std::sqrt(5.0)) * i;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

struct Plane {
  Vector3d normal;  // unit, outwards
  double offset;
};

// Of the triangles, in their order.
std::vector<Plane> planes_of(const TriangleMesh& hull) {
  std::vector<Plane> planes;
  for (const auto& t : hull.triangles) {
    const Vector3d& a = hull.points[at(t[0])];
    const Vector3d n = (hull.points[at(t[1])] - a).cross(Vector3d(hull.points[at(t[2])] - a));
    const double length = n.norm();
    const Vector3d unit = length > 0.0 ? Vector3d(n / length) : Vector3d(Vector3d::Zero());  // nothing is above a sliver
    planes.push_back({unit, unit.dot(a)});
  }
  return planes;
}

// x of all, y of all, z of all; padded with the first point to a multiple of four.
class Cloud {
 public:
  explicit Cloud(const std::vector<Vector3d>& points) : count_(points.size()), row_((points.size() + 3) / 4 * 4) {
    numbers_.resize(3 * row_);
    for (std::size_t i = 0; i < row_; ++i) {
      for (std::size_t d = 0; d < 3; ++d)
        numbers_[d * row_ + i] = points[i < count_ ? i : 0][static_cast<Eigen::Index>(d)];
    }
  }
  std::size_t size() const { return count_; }
  Vector3d point(std::size_t i) const { return {numbers_[i], numbers_[row_ + i], numbers_[2 * row_ + i]}; }
  const double* row(std::size_t d) const { return numbers_.data() + d * row_; }
  std::size_t padded() const { return row_; }

 private:
  std::size_t count_, row_;
  std::vector<double> numbers_;
};

TWINBUS_INLINE Vec4 along4(const double* x, const double* y, const double* z, const Vec4* n) {
  return load4(x) * n[0] + load4(y) * n[1] + load4(z) * n[2];
}

// The largest of all points along a direction.
TWINBUS_AVX2_CLONES
double most_along(const Cloud& cloud, const Vector3d& direction) {
  const double *x = cloud.row(0), *y = cloud.row(1), *z = cloud.row(2);
  const Vec4 n[3] = {Vec4{} + direction.x(), Vec4{} + direction.y(), Vec4{} + direction.z()};
  Vec4 most = Vec4{} - 1e300;
  for (std::size_t i = 0; i < cloud.padded(); i += 4) {
    const Vec4 here = along4(x + i, y + i, z + i, n);
    most = here > most ? here : most;
  }
  return std::max({most[0], most[1], most[2], most[3]});
}

// The first point that is so far along it.
TWINBUS_AVX2_CLONES
std::size_t first_along(const Cloud& cloud, const Vector3d& direction, double so_far) {
  const double *x = cloud.row(0), *y = cloud.row(1), *z = cloud.row(2);
  const Vec4 n[3] = {Vec4{} + direction.x(), Vec4{} + direction.y(), Vec4{} + direction.z()};
  for (std::size_t i = 0; i < cloud.padded(); i += 4) {
    const Vec4 here = along4(x + i, y + i, z + i, n);
    for (std::size_t k = 0; k < 4; ++k) {
      if (here[static_cast<int>(k)] >= so_far) return std::min(i + k, cloud.size() - 1);
    }
  }
  return 0;
}

// How far each of four points from `first` on is above the highest of the planes below it.
TWINBUS_AVX2_CLONES
void above_all(const Cloud& cloud, const std::vector<Plane>& planes, std::size_t first, double* above) {
  const double *x = cloud.row(0) + first, *y = cloud.row(1) + first, *z = cloud.row(2) + first;
  Vec4 most = Vec4{} - 1e300;
  for (const Plane& plane : planes) {
    const Vec4 n[3] = {Vec4{} + plane.normal.x(), Vec4{} + plane.normal.y(), Vec4{} + plane.normal.z()};
    const Vec4 here = along4(x, y, z, n) - plane.offset;
    most = here > most ? here : most;
  }
  store4(above, most);
}

// The points outside of the hull: what lies in it, lies in every larger one.
std::vector<Vector3d> outside_of(const TriangleMesh& hull, const Cloud& cloud) {
  const std::vector<Plane> planes = planes_of(hull);
  std::vector<Vector3d> result;
  for (std::size_t i = 0; i < cloud.size(); i += 4) {
    double above[4];
    above_all(cloud, planes, i, above);
    for (std::size_t k = 0; k < std::min(cloud.size() - i, std::size_t{4}); ++k) {
      if (!(above[k] <= 0.0)) result.push_back(cloud.point(i + k));
    }
  }
  return result;
}

// Every point once.
std::vector<Vector3d> once_each(std::vector<Vector3d> points) {
  const auto before = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Corners are added where points stick out most, until these do so by little or there are many corners.
class Refinement {
 public:
  Refinement(TriangleMesh hull, const Cloud& points) : hull_(std::move(hull)), left_(once_each(outside_of(hull_, points))) {}

  void run() {
    while (hull_.points.size() < at(kMostCorners) && !left_.empty()) {
      std::vector<Peak> peaks = highest();
      if (peaks.empty()) return;
      if (peaks.size() > kAtOnce) peaks.resize(kAtOnce);
      std::vector<Vector3d> corners = hull_.points;
      for (const Peak& peak : peaks) {
        if (corners.size() < at(kMostCorners)) corners.push_back(peak.point);
      }
      TriangleMesh more = convex_hull(corners);
      if (more.triangles.empty() || more.points.size() <= hull_.points.size()) return;
      hull_ = std::move(more);
      left_ = outside_of(hull_, Cloud(left_));
    }
  }

  const TriangleMesh& hull() const { return hull_; }
  const std::vector<Vector3d>& left() const { return left_; }  // that still stick out

 private:
  struct Peak {
    double above;
    Vector3d point;
  };
  using Key = std::array<double, 9>;  // corners of a face

  // Of each face the point that is farthest above it, if by more than is allowed; farthest first.  What a face that has
  // stayed says has stayed too: its farthest point is still outside.
  std::vector<Peak> highest() {
    const Cloud cloud(left_);
    const std::vector<Plane> planes = planes_of(hull_);
    std::map<Key, Peak> seen;
    std::vector<Peak> peaks;
    for (std::size_t f = 0; f < planes.size(); ++f) {
      Key key{};
      for (std::size_t k = 0; k < 9; ++k)
        key[k] = hull_.points[at(hull_.triangles[f][k / 3])][static_cast<Eigen::Index>(k % 3)];
      const auto known = seen_.find(key);
      Peak peak{0.0, Vector3d::Zero()};
      if (known != seen_.end()) {
        peak = known->second;
      } else {
        const double most = most_along(cloud, planes[f].normal);
        peak.above = most - planes[f].offset;
        if (peak.above > kSticksOut) peak.point = cloud.point(first_along(cloud, planes[f].normal, most));
      }
      seen.emplace(key, peak);
      if (peak.above > kSticksOut) peaks.push_back(peak);
    }
    seen_ = std::move(seen);
    std::stable_sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.above > b.above; });
    return peaks;
  }

  TriangleMesh hull_;
  std::vector<Vector3d> left_;
  std::map<Key, Peak> seen_;
};

// The hull with every corner moved outwards, by `share` of what sticks out most of its faces and `room`.
TriangleMesh widened(const TriangleMesh& hull, const std::vector<double>& above, double share, double room) {
  const std::vector<Plane> planes = planes_of(hull);
  std::vector<Vector3d> outwards(hull.points.size(), Vector3d::Zero());
  std::vector<double> most(hull.points.size(), 0.0);
  std::vector<double> along(hull.points.size(), 1.0);  // the least of the faces' normals along the corner's
  const auto each_corner = [&](auto visit) {
    for (std::size_t f = 0; f < planes.size(); ++f) {
      for (const int corner : hull.triangles[f]) visit(f, at(corner));
    }
  };
  each_corner([&](std::size_t f, std::size_t c) { most[c] = std::max(most[c], above[f]); });
  for (std::size_t f = 0; f < planes.size(); ++f) {  // faces weigh as much as their angle at the corner is wide
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) -> const Vector3d& { return hull.points[at(hull.triangles[f][(k + i) % 3])]; };
      const Vector3d a = (corner(1) - corner(0)).normalized(), b = (corner(2) - corner(0)).normalized();
      outwards[at(hull.triangles[f][k])] += std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * planes[f].normal;
    }
  }
  for (Vector3d& n : outwards) n.normalize();
  each_corner([&](std::size_t f, std::size_t c) { along[c] = std::min(along[c], planes[f].normal.dot(outwards[c])); });
  std::vector<Vector3d> corners;
  for (std::size_t c = 0; c < hull.points.size(); ++c)
    corners.push_back(hull.points[c] + (share * most[c] + room) / std::max(along[c], kSharp) * outwards[c]);
  return convex_hull(corners);
}

}  // namespace

std::optional<TriangleMesh> coarse_hull(const TriangleMesh& mesh) {
  if (mesh.triangles.size() <= at(kFineTriangles)) return std::nullopt;
  const Cloud points(mesh.points);
  // As seen in a box of equal edges, so that long things get as many corners at their ends.
  const Vector3d size = box_around(mesh.points).sizes(), edge = size.cwiseMax(1e-3 * size.maxCoeff());
  if (!(edge.minCoeff() > 0.0)) return std::nullopt;
  std::vector<Vector3d> chosen;
  for (int i = 0; i < kHullDirections; ++i) {
    const Vector3d d = hull_direction(i).cwiseQuotient(edge);
    chosen.push_back(points.point(first_along(points, d, most_along(points, d))));
  }
  TriangleMesh few = convex_hull(chosen);
  if (few.triangles.empty()) return std::nullopt;
  Refinement refinement(std::move(few), points);
  refinement.run();
  const TriangleMesh& hull = refinement.hull();
  // What still sticks out is taken in by moving faces, by no more than it takes.
  std::vector<Vector3d> held = hull.points;
  held.insert(held.end(), refinement.left().begin(), refinement.left().end());
  const Cloud hold(held);
  std::vector<double> above;
  for (const Plane& plane : planes_of(hull)) above.push_back(std::max(0.0, most_along(hold, plane.normal) - plane.offset));
  for (double share = 0.5; share < kMostShare; share *= 1.25) {
    TriangleMesh large = widened(hull, above, share, 2.0 * share * kHullRoom * edge.maxCoeff());
    if (large.triangles.empty()) return std::nullopt;
    if (outside_of(large, hold).empty()) return large;
  }
  return std::nullopt;
}

bool holds(const TriangleMesh& hull, const std::vector<Vector3d>& points) {
  return hull.triangles.size() >= 4 && !points.empty() && outside_of(hull, Cloud(points)).empty();
}

}  // namespace twinbus::geometry
