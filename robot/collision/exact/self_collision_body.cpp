#include "robot/collision/exact/self_collision_body.h"

#include <algorithm>

#include "robot/collision/links/inscribed_spheres.h"

namespace twinbus::inline robot {

namespace {

constexpr int kInnerBalls = 24, kInnerPoints = 8;  // of a link, at most

CollisionTriangleBoxes boxes_of(const TriangleCluster& cluster) {
  constexpr float kGrow = 1e-6F;  // [m]
  CollisionTriangleBoxes boxes;
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t lane = 0; lane < TriangleCluster::kLanes; ++lane) {
      const auto [low, high] = std::minmax(
          {cluster.corner[0][d][lane], cluster.corner[1][d][lane], cluster.corner[2][d][lane]});
      boxes.low[d][lane] = low - kGrow;
      boxes.high[d][lane] = high + kGrow;
    }
  }
  return boxes;
}

}  // namespace

void set4(const Eigen::Vector3d& v, double last, float (&to)[4]) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(v[k]);
  to[3] = static_cast<float>(last);
}

// Clusters come in the order of their tree, so eight in a row lie together.
void CollisionBodyStore::group() {
  const std::vector<TriangleCluster>& clusters = clusters_;
  const std::size_t blocks = padded_lanes(clusters.size()) / kCollisionLanes;
  for (AlignedNumbers& c : block_center_) c.resize(padded_lanes(blocks), 1e9F);
  block_radius_.resize(padded_lanes(blocks));
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t end = std::min(clusters.size(), kCollisionLanes * (b + 1));
    const auto center = [&](std::size_t i) {
      return Eigen::Vector3d(static_cast<double>(clusters[i].center[0]),
                             static_cast<double>(clusters[i].center[1]),
                             static_cast<double>(clusters[i].center[2]));
    };
    Eigen::Vector3d low = center(kCollisionLanes * b), high = low;
    for (std::size_t i = kCollisionLanes * b; i < end; ++i) {
      const Eigen::Vector3d reach =
          Eigen::Vector3d::Constant(static_cast<double>(clusters[i].radius));
      low = low.cwiseMin(center(i) - reach);
      high = high.cwiseMax(center(i) + reach);
    }
    const Eigen::Vector3d middle = 0.5 * (low + high);
    double radius = 0.0;
    for (std::size_t i = kCollisionLanes * b; i < end; ++i) {
      radius =
          std::max(radius, (center(i) - middle).norm() + static_cast<double>(clusters[i].radius));
    }
    for (std::size_t d = 0; d < 3; ++d)
      block_center_[d].data[b] = static_cast<float>(middle[static_cast<int>(d)]);
    block_radius_.data[b] = static_cast<float>(radius + 2e-6);
  }
}

void CollisionBodyStore::add_clusters(const LinkGeometry& link) {
  clusters_ = link.clusters;
  const std::size_t count = padded_lanes(clusters_.size());
  for (AlignedNumbers& c : center_) c.resize(count, 1e9F);
  for (auto* row : {&box_middle_, &box_low_, &box_high_}) {
    for (AlignedNumbers& c : *row) c.resize(count, 1e9F);
  }
  for (AlignedNumbers& c : box_half_) c.resize(count);
  radius_.resize(count);
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const TriangleCluster& cluster = clusters_[c];
    std::array<float, 4> middle{}, half{};
    for (std::size_t d = 0; d < 3; ++d) {
      center_[d].data[c] = cluster.center[d];
      middle[d] = 0.5F * (cluster.low[d] + cluster.high[d]);
      half[d] = 0.5F * (cluster.high[d] - cluster.low[d]) + 1e-6F;
      box_middle_[d].data[c] = middle[d];
      box_half_[d].data[c] = half[d];
      box_low_[d].data[c] = middle[d] - half[d];
      box_high_[d].data[c] = middle[d] + half[d];
    }
    radius_.data[c] = cluster.radius;
    middle_.push_back(middle);
    half_.push_back(half);
    triangle_boxes_.push_back(boxes_of(cluster));
  }
  group();
  for (int d = 0; d < 3; ++d) {
    view_.center[d] = center_[d].data;
    view_.block_center[d] = block_center_[d].data;
    view_.box_middle[d] = box_middle_[d].data;
    view_.box_half[d] = box_half_[d].data;
    view_.box_low[d] = box_low_[d].data;
    view_.box_high[d] = box_high_[d].data;
  }
  view_.radius = radius_.data;
  view_.block_radius = block_radius_.data;
  view_.middle = reinterpret_cast<const float(*)[4]>(middle_.data());
  view_.half = reinterpret_cast<const float(*)[4]>(half_.data());
  view_.triangle_boxes = triangle_boxes_.data();
  view_.cluster = clusters_.data();
  view_.clusters = static_cast<int>(clusters_.size());
}

void CollisionBodyStore::add_inner(const LinkGeometry& link) {
  const std::vector<Ball> balls = inner_balls(link, kInnerBalls, kInnerPoints);
  const std::size_t count = padded_lanes(balls.size());
  for (int d = 0; d < 4; ++d) inner_[d].resize(count, d == 3 ? -1e9F : 0.0F);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    for (int d = 0; d < 3; ++d) inner_[d].data[k] = static_cast<float>(balls[k].center[d]);
    inner_[3].data[k] = static_cast<float>(balls[k].radius);
  }
  for (int d = 0; d < 4; ++d) view_.inner[d] = inner_[d].data;
  view_.inner_balls = static_cast<int>(count);
}

CollisionBodyStore::CollisionBodyStore(const LinkGeometry& link, bool inner) {
  set4(link.sphere.center, link.sphere.radius, view_.sphere);
  set4(link.capsule.a, link.capsule.radius, view_.from);
  set4(link.capsule.b, link.capsule.radius, view_.to);
  set4(link.low, 0.0, view_.low);
  set4(link.high, 0.0, view_.high);
  view_.link = link.link;
  add_clusters(link);
  if (inner) add_inner(link);
  const std::vector<Eigen::Vector3d>& corners = link.hull.points;
  const std::size_t count = padded_lanes(corners.size());
  for (int d = 0; d < 3; ++d) {
    hull_[d].resize(count);
    for (std::size_t c = 0; c < count; ++c)
      hull_[d].data[c] = static_cast<float>(corners[std::min(c, corners.size() - 1)][d]);
    view_.hull[d] = hull_[d].data;
  }
  view_.hull_corners = static_cast<int>(count);
  for (const Eigen::Vector3d& p : link.witnesses) {
    witness_.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0F});
  }
  view_.witness = reinterpret_cast<const float(*)[4]>(witness_.data());
  view_.witnesses = static_cast<int>(witness_.size());
}

}  // namespace twinbus::robot
