// The shapes of links and obstacles as Collision wants them.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/distance/convex_shape.h"
#include "robot/collision/links/link_geometry.h"
#include "geometry/distance/gjk.h"
#include "geometry/distance/mesh_distance.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct CollisionShape {  // one shape, of a link or an obstacle
  ConvexShape convex;
  double radius = 0.0;  // of the sphere around it [m]
  Capsule capsule;      // around it, in its frame
  GjkShape core;        // the same, or the hull of a mesh
  Ball inside;          // of the hull of a mesh, in its frame
  Eigen::Isometry3d local =
      Eigen::Isometry3d::Identity();  // of the convex shape, in the link frame (obstacle: world)
  Eigen::Isometry3d world = Eigen::Isometry3d::Identity();
  std::int64_t stamp = -1;              // query that world belongs to
  std::shared_ptr<ClusteredMesh> mesh;  // in the frame of the convex shape; null for a hull
};

struct CollisionOwner {  // a link or an obstacle: its shapes and the sphere around them
  int link = -1;         // that moves it; -1: it stands still in the world
  int index = -1;        // the link, or obstacle + link_count
  bool ground = false;   // an obstacle that a base on the plane stands on
  std::vector<CollisionShape> shapes;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // in the link frame (obstacle: world)
  double radius = 0.0;
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
};

// Throws std::runtime_error when a mesh cannot be read.  Meshes of very many triangles become hulls.
CollisionShape collision_shape(const Shape& shape);

// Computes the sphere.
void enclose(CollisionOwner& owner);

}  // namespace twinbus::robot
