#include "planner/batch/scene.h"

#include <algorithm>
#include <cmath>


namespace twinbus::inline planner {

namespace {

void put(float* to, const Eigen::Vector3d& from) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

// Half the edges of the box around a shape, along the world's axes.
void bounds(const BlockShape& s, int i, float& low, float& high) {
  float reach = s.half[0];
  float end = s.center[i];
  switch (s.kind) {
    case BlockShape::Kind::kBox:
      reach = 0.0F;
      for (int k = 0; k < 3; ++k) reach += std::fabs(s.axis[k][i]) * s.half[k];
      break;
    case BlockShape::Kind::kCylinder:
      reach = std::fabs(s.axis[2][i]) * s.half[2] +
              s.half[0] * std::sqrt(std::max(0.0F, 1.0F - s.axis[2][i] * s.axis[2][i]));
      break;
    case BlockShape::Kind::kCapsule:
      end += s.axis[0][i];
      break;
    case BlockShape::Kind::kSphere:
      break;
  }
  constexpr float kWiden = 1e-5F;  // [m]
  low = std::min(s.center[i], end) - reach - kWiden;
  high = std::max(s.center[i], end) + reach + kWiden;
}

}  // namespace

BlockScene::BlockScene(const std::vector<Obstacle>& obstacles) {
  for (const Obstacle& obstacle : obstacles) {
    const std::size_t before = shapes.size();
    if (obstacle.hand < 0) add(obstacle);
    shape_of.push_back(shapes.size() > before ? static_cast<int>(before) : -1);
  }
  finish();
}

void BlockScene::add(const Obstacle& obstacle) {
  BlockShape shape;
  const Eigen::Vector3d& size = obstacle.size;
  put(shape.center, obstacle.pose.translation());
  for (int k = 0; k < 3; ++k) put(shape.axis[k], obstacle.pose.linear().col(k));
  switch (obstacle.shape) {
    case ObstacleShape::kBox:
      if (!(size.minCoeff() > 0.0)) return;
      shape.kind = BlockShape::Kind::kBox;
      put(shape.half, 0.5 * size);
      shape.upright = obstacle.pose.linear().col(2) == Eigen::Vector3d::UnitZ();
      break;
    case ObstacleShape::kSphere:
      if (!(size.x() > 0.0)) return;
      shape.half[0] = static_cast<float>(size.x());
      break;
    case ObstacleShape::kCylinder:
      if (!(size.x() > 0.0 && size.y() > 0.0)) return;
      shape.kind = BlockShape::Kind::kCylinder;
      shape.half[0] = static_cast<float>(size.x());
      shape.half[2] = static_cast<float>(0.5 * size.y());
      break;
    default:
      return;
  }
  shapes.push_back(shape);
}

void BlockScene::add_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                             double radius) {
  BlockShape shape;
  shape.kind = BlockShape::Kind::kCapsule;
  put(shape.center, from);
  put(shape.axis[0], to - from);
  shape.half[0] = static_cast<float>(radius);
  shape.inverse = static_cast<float>(1.0 / (to - from).squaredNorm());
  shapes.push_back(shape);
}

void BlockScene::finish() {
  const std::size_t filled = (shapes.size() + 7) / 8 * 8;
  for (int i = 0; i < 3; ++i) {
    low[i].assign(filled, 1e9F);
    high[i].assign(filled, -1e9F);
    for (std::size_t s = 0; s < shapes.size(); ++s) bounds(shapes[s], i, low[i][s], high[i][s]);
  }
}

}  // namespace twinbus::planner
