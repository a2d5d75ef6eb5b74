#include "control/loop/footstep_shapes.h"

#include <array>

#include "lcmtypes/msg/obstacle_row.h"

namespace twinbus::inline control {

namespace {

constexpr int kHolds = 4, kPlaces = 8;
constexpr double kThick = 0.004;  // of a sole that is drawn [m]
constexpr float kDot = 0.008F;    // radius along the way of the foot [m]
static_assert(kHolds + kPlaces <= kObstaclesPerPiece);

void add(const Eigen::Isometry3d& ground, const Foothold& at, const Eigen::Vector3d& middle,
         ObstaclesPiece& out) noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(at.position.x(), at.position.y(), at.height);
  pose.linear() = at.rotation();
  pose = ground.inverse() * pose * Eigen::Translation3d(middle);
  place_row(pose, static_cast<std::size_t>(out.count++), out);
}

}  // namespace

void footstep_shapes(const Model& model, const Estimator& estimator, const Walk* walk,
                     ObstaclesPiece& out) noexcept {
  out = ObstaclesPiece{};
  out.pieces = 1;
  out.attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
  if (walk == nullptr) return;
  const Eigen::Isometry3d& ground = estimator.ground_in_world();
  const WalkPattern& pattern = walk->pattern();
  std::array<Foothold, kHolds> holds;
  const int steps = pattern.ahead(holds.data(), kHolds);
  for (int k = 0; k < steps; ++k) {
    const int side = (k % 2 == 0) ? 1 - pattern.support() : pattern.support();
    const Sole& sole = model.soles[static_cast<std::size_t>(side)];
    const auto row = static_cast<std::size_t>(out.count);
    out.shape[row] = ObstacleShape::kBox;
    out.size[row] = {static_cast<float>(sole.front + sole.back),
                     static_cast<float>(sole.left + sole.right), static_cast<float>(kThick)};
    const Eigen::Vector3d middle(0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right),
                                 0.5 * kThick);
    add(ground, holds[static_cast<std::size_t>(k)], middle, out);
  }
  std::array<Foothold, kPlaces> places;
  const int count = pattern.swing_way(places.data(), kPlaces);
  for (int k = 0; k < count; ++k) {
    const auto row = static_cast<std::size_t>(out.count);
    out.shape[row] = ObstacleShape::kSphere;
    out.size[row] = {kDot, 0.0F, 0.0F};
    add(ground, places[static_cast<std::size_t>(k)], Eigen::Vector3d::Zero(), out);
  }
}

}  // namespace twinbus::control
