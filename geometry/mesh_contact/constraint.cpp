#include "geometry/mesh_contact/constraint.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>


namespace twinbus::inline geometry {

namespace {

constexpr std::size_t kMostNormals = 160;
constexpr std::size_t kMostFaces = 80;  // of them
constexpr std::size_t kFewFaces = 6;    // more than these are round, or rough
constexpr std::size_t kMostDirections = 6;  // of edges of each body
constexpr double kSame = 0.9998;            // cosine between normals that are one
constexpr double kOneFace = 0.985;          // cosine between normals under one constraint
constexpr double kAlong = 0.99;             // cosine between a face and the constraint it ends at
constexpr double kLevel = 0.1;              // sine of an edge that does not lead beyond the end
constexpr double kEnd = 0.05;               // of the width: what is near the end
constexpr double kSide = 0.3;               // cosine: steeper faces are walls
constexpr double kFlat = 1e-3;             // of the width: a level side
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool of_edge(const CrossingPoint& p) noexcept {
  return p.kind == CrossingPoint::kEdgeA || p.kind == CrossingPoint::kEdgeB;
}

bool of_a(const CrossingPoint& p) noexcept {
  return p.kind == CrossingPoint::kVertexA || p.kind == CrossingPoint::kEdgeA;
}

// Whether a point lies on the side of A that faces B, or on that of B that faces A.
bool is_end_of(const CrossingPoint& p, const Eigen::Vector3d& n, bool a) noexcept {
  if (of_a(p) == a) return !of_edge(p) || std::abs(p.normal.dot(n)) < 1.0 - kSide;
  return of_edge(p) && (a ? -p.normal.dot(n) : p.normal.dot(n)) > kSide;
}

// The face that an edge goes through, as a direction from B to A.
Eigen::Vector3d towards_a(const CrossingPoint& p) noexcept {
  return p.kind == CrossingPoint::kEdgeA ? p.normal : Eigen::Vector3d(-p.normal);
}

}  // namespace

void Constraints::reserve(std::size_t points) {
  gathered_.reserve(points);
  normals_.reserve(kMostNormals);
  groups_.reserve(kMostNormals);
}

int Constraints::find(const std::vector<CrossingPoint>& points, int regions, int region, int first,
                      std::vector<Penetration>& found) noexcept {
  gather(points, regions, region);
  if (points_.empty()) return first;
  suggest_faces();
  const bool round = normals_.size() > kFewFaces;
  suggest_crossed_edges();
  if (round) suggest_thinnest();
  const Eigen::Vector3d* best = nullptr;
  const Eigen::Vector3d* thinnest = nullptr;
  Extent best_extent, thinnest_extent;
  double best_width = kInfinity, thinnest_width = kInfinity;
  for (auto tried = normals_.rbegin(); tried != normals_.rend(); ++tried) {
    const Eigen::Vector3d& n = *tried;
    Extent extent;
    if (!extent_along(n, best_width, extent)) continue;
    if (extent.width() < thinnest_width) {
      thinnest = &n;
      thinnest_extent = extent;
      thinnest_width = extent.width();
    }
    if (!(extent.width() < best_width) || !ends_here(n, extent)) continue;
    best = &n;
    best_extent = extent;
    best_width = extent.width();
  }
  if (best != nullptr) {
    under_one(*best, best_extent, first, found);
    return first + 1;
  }
  const int next = under_faces(first, found);
  if (next > first || thinnest == nullptr) return next;
  under_one(*thinnest, thinnest_extent, first, found);
  return first + 1;
}

void Constraints::gather(const std::vector<CrossingPoint>& points, int regions,
                         int region) noexcept {
  normals_.clear();
  points_ = points;
  if (regions == 1) return;
  gathered_.clear();
  for (const CrossingPoint& point : points) {
    if (point.region == region && gathered_.size() < gathered_.capacity()) {
      gathered_.push_back(point);
    }
  }
  points_ = gathered_;
}

void Constraints::suggest(const Eigen::Vector3d& normal) noexcept {
  if (normals_.size() >= kMostNormals) return;
  for (const Eigen::Vector3d& known : normals_) {
    if (known.dot(normal) > kSame) return;
  }
  normals_.push_back(normal);
}

void Constraints::suggest_faces() noexcept {
  for (const CrossingPoint& p : points_) {
    if (of_edge(p) && normals_.size() < kMostFaces) suggest(towards_a(p));
  }
}

// Of two sharp edges that cross, the direction square to both.
void Constraints::suggest_crossed_edges() noexcept {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::array<std::array<Eigen::Vector3d, kMostDirections>, 2> along;
  std::array<std::size_t, 2> count{0, 0};
  for (const CrossingPoint& p : points_) {
    if (!of_edge(p)) continue;
    mean += towards_a(p);
    const std::size_t side = p.kind == CrossingPoint::kEdgeA ? 0 : 1;
    if (!p.sharp || count[side] >= kMostDirections) continue;
    bool known = false;
    for (std::size_t i = 0; i < count[side]; ++i) {
      known = known || std::abs(along[side][i].dot(p.leaves)) > kSame;
    }
    if (!known) along[side][count[side]++] = p.leaves;
  }
  for (std::size_t i = 0; i < count[0]; ++i) {
    for (std::size_t k = 0; k < count[1]; ++k) {
      const Eigen::Vector3d across = along[0][i].cross(along[1][k]);
      const double size = across.norm();
      if (!(size > 0.05)) continue;
      const Eigen::Vector3d n = (across.dot(mean) < 0.0 ? -1.0 : 1.0) / size * across;
      suggest(n);
      suggest(-n);  // walls on both sides say nothing about up and down
    }
  }
}

// Of surfaces that are round: square to the line along which they cross.
void Constraints::suggest_thinnest() noexcept {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const CrossingPoint& p : points_) {
    if (!of_edge(p)) continue;
    middle += p.point;
    mean += towards_a(p);
    count += 1.0;
  }
  if (!(count > 3.0)) return;
  middle /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const CrossingPoint& p : points_) {
    if (of_edge(p)) spread += (p.point - middle) * (p.point - middle).transpose();
  }
  // By the invariants, not by iteration: bounded time.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  const Eigen::Vector3d thin = axes.eigenvectors().col(0);
  if (!thin.allFinite() || !(std::abs(thin.squaredNorm() - 1.0) < 1e-6)) return;
  const Eigen::Vector3d n = thin.dot(mean) < 0.0 ? Eigen::Vector3d(-thin) : thin;
  suggest(n);
  suggest(-n);
}

bool Constraints::extent_along(const Eigen::Vector3d& n, double most,
                               Extent& extent) const noexcept {
  double low = kInfinity, high = -kInfinity;
  for (std::size_t i = 0; i < points_.size();) {
    const std::size_t end = std::min(points_.size(), i + 16);
    for (; i < end; ++i) {
      const double height = n.dot(points_[i].point);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (!(high - low < most)) return false;
  }
  extent = {low, high};
  return true;
}

// Whether B ends at the high side and A at the low one, rather than going on beyond what they share.
bool Constraints::ends_here(const Eigen::Vector3d& n, const Extent& extent) const noexcept {
  const double near = kEnd * extent.width() + 1e-12;
  for (const CrossingPoint& p : points_) {
    const double height = n.dot(p.point);
    if (height > extent.high - near) {
      if (p.kind == CrossingPoint::kVertexA) return false;  // B is all around it
      if (p.kind == CrossingPoint::kEdgeA && !(p.normal.dot(n) > kAlong)) return false;
      if (p.kind == CrossingPoint::kEdgeB && p.leaves.dot(n) > kLevel) return false;
    }
    if (height < extent.low + near) {
      if (p.kind == CrossingPoint::kVertexB) return false;
      if (p.kind == CrossingPoint::kEdgeB && !(-p.normal.dot(n) > kAlong)) return false;
      if (p.kind == CrossingPoint::kEdgeA && p.leaves.dot(n) < -kLevel) return false;
    }
  }
  return true;
}

void Constraints::under_one(const Eigen::Vector3d& n, const Extent& extent, int number,
                            std::vector<Penetration>& found) const noexcept {
  const double touch = 1e-6 * extent.width();
  // A flat side of the shared body has one level; of a round one it is looked up.
  bool flat_top = true, flat_bottom = true, none = true;
  for (const CrossingPoint& p : points_) {
    const double height = n.dot(p.point);
    if (is_end_of(p, n, false)) {
      flat_top = flat_top && height > extent.high - kFlat * extent.width();
    }
    if (is_end_of(p, n, true)) {
      flat_bottom = flat_bottom && height < extent.low + kFlat * extent.width();
    }
  }
  for (const CrossingPoint& p : points_) {
    // Where an edge goes in through the end itself the depth is zero.
    if (of_edge(p) && std::abs(p.normal.dot(n)) > kSide) continue;
    const double height = n.dot(p.point);
    const double depth =
        of_a(p) ? (flat_top ? extent.high : level(n, p.point, false)) - height
                : height - (flat_bottom ? extent.low : level(n, p.point, true));
    if (!(depth > touch) || found.size() >= found.capacity()) continue;
    found.push_back({p.kind, p.id, p.face, p.point, n, depth, number});
    none = false;
  }
  if (none) between_edges(n, extent, number, found);
}

// Two edges that cross, neither with a corner in the other body: where they are deepest.
void Constraints::between_edges(const Eigen::Vector3d& n, const Extent& extent, int number,
                                std::vector<Penetration>& found) const noexcept {
  const double near = kEnd * extent.width();
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  double count_low = 0.0, count_high = 0.0;
  Penetration deepest{CrossingPoint::kEdgeA, 0, -1, low, n, extent.width(), number};
  for (const CrossingPoint& p : points_) {
    const double height = n.dot(p.point);
    if (height < extent.low + near) {
      low += p.point;
      count_low += 1.0;
      deepest.id = p.id;
    } else if (height > extent.high - near) {
      high += p.point;
      count_high += 1.0;
    }
  }
  if (!(count_low * count_high > 0.0) || found.size() >= found.capacity()) return;
  deepest.point = 0.5 * (low / count_low + high / count_high) - 0.5 * extent.width() * n;
  found.push_back(deepest);
}

// Of a surface under or over a point: where it is nearest from aside.
double Constraints::level(const Eigen::Vector3d& n, const Eigen::Vector3d& point,
                          bool surface_of_a) const noexcept {
  double nearest = kInfinity, result = n.dot(point);
  for (const CrossingPoint& p : points_) {
    if (!is_end_of(p, n, surface_of_a)) continue;
    const Eigen::Vector3d away = p.point - point;
    const double height = n.dot(away);
    const double aside = away.squaredNorm() - height * height;
    if (!(aside < nearest)) continue;
    nearest = aside;
    result = n.dot(p.point);
  }
  return result;
}

int Constraints::under_faces(int first, std::vector<Penetration>& found) noexcept {
  groups_.clear();
  for (const CrossingPoint& p : points_) {
    if (of_edge(p)) continue;
    double least = kInfinity;
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    for (const CrossingPoint& edge : points_) {
      // Faces of the other body.
      if (edge.kind != (of_a(p) ? CrossingPoint::kEdgeA : CrossingPoint::kEdgeB)) continue;
      const double depth = edge.normal.dot(edge.point - p.point);
      if (!(depth >= 0.0 && depth < least)) continue;
      least = depth;
      best = towards_a(edge);
    }
    if (!(least > 0.0 && least < kInfinity) || found.size() >= found.capacity()) continue;
    std::size_t group = 0;
    while (group < groups_.size() && !(groups_[group].dot(best) > kOneFace)) ++group;
    if (group == groups_.size()) {
      if (groups_.size() >= kMostNormals) continue;
      groups_.push_back(best);
    }
    found.push_back({p.kind, p.id, p.face, p.point, best, least, first + static_cast<int>(group)});
  }
  return first + static_cast<int>(groups_.size());
}

}  // namespace twinbus::geometry
