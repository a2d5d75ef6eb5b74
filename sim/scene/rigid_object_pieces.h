// What moves in a world beside the robot, loose bodies and further robots, as the numbered pieces
// that go out on LOOSE.  Of a further robot its simple shapes are shown, no meshes.

#pragma once

#include <cstddef>
#include <vector>

#include "lcmtypes/msg/obstacle_row.h"
#include "sim/scene/obstacle_pieces.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class LoosePieces {
 public:
  LoosePieces() = default;
  explicit LoosePieces(const WorldConfig& config) {
    std::vector<Obstacle> shapes;
    const auto add = [&](const Row& row, ObstacleShape shape, const Eigen::Vector3d& size) {
      shapes.push_back({.shape = shape, .size = size, .pose = Eigen::Isometry3d::Identity()});
      rows_.push_back(row);
    };
    for (std::size_t i = 0; i < config.loose.size(); ++i) {
      Row row;
      row.body = static_cast<int>(i);
      row.in_body = config.loose[i].solid_pose;
      const Solid& solid = config.loose[i].solid;
      if (solid.shape == SolidShape::kBox) {
        add(row, ObstacleShape::kBox, solid.size);
      } else if (solid.shape == SolidShape::kSphere) {
        add(row, ObstacleShape::kSphere, solid.size);
      } else {
        add(row, ObstacleShape::kCylinder, solid.size);
        if (solid.shape == SolidShape::kCylinder) continue;
        const Eigen::Vector3d cap(solid.size.x(), 0.0, 0.0);
        for (const double side : {0.5, -0.5}) {
          row.in_body =
              config.loose[i].solid_pose * Eigen::Translation3d(0.0, 0.0, side * solid.size.y());
          add(row, ObstacleShape::kSphere, cap);
        }
      }
    }
    for (std::size_t i = 0; i < config.robots.size(); ++i) {
      const Model& model = *config.robots[i].model;
      for (int link = 0; link < model.link_count(); ++link) {
        for (const Shape& shape : model.links[static_cast<std::size_t>(link)].collision) {
          if (shape.kind == ShapeKind::kMesh) continue;
          const Row row{static_cast<int>(i), link, shape.pose};
          add(row, shape.kind == ShapeKind::kBox      ? ObstacleShape::kBox
                   : shape.kind == ShapeKind::kSphere ? ObstacleShape::kSphere
                                                      : ObstacleShape::kCylinder,
              shape.size);
        }
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
      const Eigen::Isometry3d body =
          of.link < 0 ? world.loose(of.body).pose : world.robot_link(of.body, of.link);
      place_row(body * of.in_body, row, out);
    }
    return count;
  }

  // The shapes of a loose body in a frame, as many as a piece has rows for.
  void body(int body, const Eigen::Isometry3d& body_in_frame, ObstaclesPiece& out) const noexcept {
    constexpr auto kRows = static_cast<std::size_t>(kObstaclesPerPiece);
    for (std::size_t i = 0; i < rows_.size() && out.count < kObstaclesPerPiece; ++i) {
      if (rows_[i].link >= 0 || rows_[i].body != body) continue;
      const ObstaclesPiece& from = pieces_[i / kRows];
      const auto row = static_cast<std::size_t>(out.count++);
      out.shape[row] = from.shape[i % kRows];
      out.size[row] = from.size[i % kRows];
      place_row(body_in_frame * rows_[i].in_body, row, out);
    }
  }

 private:
  struct Row {
    int body = 0;   // loose body, or further robot
    int link = -1;  // of that robot; -1: a loose body
    Eigen::Isometry3d in_body = Eigen::Isometry3d::Identity();
  };
  std::vector<Row> rows_;
  std::vector<ObstaclesPiece> pieces_;
};

}  // namespace twinbus::sim
