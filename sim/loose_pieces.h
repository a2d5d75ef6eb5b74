// The loose bodies of a world as the numbered pieces that go out on LOOSE.

#pragma once

#include <cstddef>
#include <vector>

#include "robot/obstacle_row.h"
#include "sim/obstacle_pieces.h"
#include "sim/world.h"

namespace twinbus {

class LoosePieces {
 public:
  explicit LoosePieces(const std::vector<LooseBody>& bodies) {
    std::vector<Obstacle> shapes;
    const auto add = [&](int body, ObstacleShape shape, const Eigen::Vector3d& size, double up) {
      shapes.push_back({.shape = shape, .size = size, .pose = Eigen::Isometry3d::Identity()});
      rows_.push_back({body, up});
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto body = static_cast<int>(i);
      const Solid& solid = bodies[i].solid;
      if (solid.shape == SolidShape::kBox) {
        add(body, ObstacleShape::kBox, solid.size, 0.0);
      } else if (solid.shape == SolidShape::kSphere) {
        add(body, ObstacleShape::kSphere, solid.size, 0.0);
      } else {
        add(body, ObstacleShape::kCylinder, solid.size, 0.0);
        if (solid.shape == SolidShape::kCylinder) continue;
        const Eigen::Vector3d cap(solid.size.x(), 0.0, 0.0);
        for (const double side : {0.5, -0.5})
          add(body, ObstacleShape::kSphere, cap, side * solid.size.y());
      }
    }
    if (!shapes.empty()) pieces_ = obstacle_pieces(shapes, 0);
  }

  // As of the last step of the world.  How many pieces there are; none is filled beyond them.
  int fill(const World& world, int piece, ObstaclesPiece& out) const noexcept {
    const auto count = static_cast<int>(pieces_.size());
    if (piece >= count) return count;
    out = pieces_[static_cast<std::size_t>(piece)];
    for (std::size_t row = 0; row < static_cast<std::size_t>(out.count); ++row) {
      const Row& of = rows_[static_cast<std::size_t>(piece * kObstaclesPerPiece) + row];
      place_row(world.loose(of.body).pose * Eigen::Translation3d(0.0, 0.0, of.up), row, out);
    }
    return count;
  }

 private:
  struct Row {
    int body;
    double up;  // along the body's z axis [m]
  };
  std::vector<Row> rows_;
  std::vector<ObstaclesPiece> pieces_;
};

}  // namespace twinbus
