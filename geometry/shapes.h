// Shapes in space: of a link as its file describes them, and the balls and capsules around them.  [m]

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace twinbus::inline geometry {

enum class ShapeKind { kBox, kSphere, kCylinder, kMesh };

struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // box: full edges; sphere: radius, -, -;
                                                   // cylinder: radius, length, -; mesh: scale
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // in the link frame; cylinder axis is z
  std::string mesh;                                        // resolved file name
};

struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// All points at most `radius` from the segment a b.
struct Capsule {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// Along the axes; empty without points.
inline Eigen::AlignedBox3d box_around(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  return box;
}

}  // namespace twinbus::geometry
