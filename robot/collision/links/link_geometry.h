// The shapes of a robot as collision checks want them, built and verified when the robot is loaded.
//
// Per link that bears collision shapes: one welded triangle mesh, and what lies around it: sphere,
// capsule, convex hull, clusters of triangles.  All in the link frame, [m].
//
// Boxes and mesh files become exactly their triangles.  Round shapes become triangles that lie
// outside of them, by at most `outside`: what is said to be clear of the triangles is clear of the
// true shape.  Links that consist of primitives alone are also kept as such (`parts`), for checks
// that need no triangles.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/bounds/triangle_clusters.h"
#include "geometry/mesh/mesh_file.h"
#include "geometry/shapes.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct LinkGeometry {
  int link = 0;
  TriangleMesh mesh;  // welded at 1 um, no triangle without area
  double outside = 0.0;
  TriangleMesh hull;  // convex; corners are points of the mesh, triangles face outwards
  Ball sphere;
  Capsule capsule;
  Eigen::Vector3d low, high;  // box along the link's axes
  std::vector<TriangleCluster> clusters;
  std::vector<Shape> parts;  // the link's shapes when none of them is a mesh, else empty
  // A point of the surface of every shape: inside tests start there.
  std::vector<Eigen::Vector3d> witnesses;
};

struct RobotGeometry {
  std::vector<LinkGeometry> links;  // those that bear collision shapes, by link index
  std::vector<int> of_link;         // [link_count]: index in links, -1 without shapes
};

// Throws std::runtime_error when a mesh cannot be read or a bound cannot be verified.
RobotGeometry build_geometry(const Model& model);

// One link from its shapes; link_geometry of nothing has no triangles.
LinkGeometry link_geometry(const std::vector<Shape>& shapes);

// Throws std::runtime_error naming the first bound that does not hold all triangles.
void verify(const LinkGeometry& geometry);

}  // namespace twinbus::robot
