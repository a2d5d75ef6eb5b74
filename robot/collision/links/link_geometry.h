// The shapes of a robot as collision checks want them, built and verified when the robot is loaded.
//
// Per link that bears collision shapes: one welded triangle mesh, and what lies around it: sphere,
// capsule, convex hull, clusters of triangles, and a few spheres whose union holds every triangle
// (proved triangle by triangle: sphere_cover.h).  All in the link frame, [m].
//
// Boxes and mesh files become exactly their triangles.  Round shapes become triangles that lie
// outside of them, by at most `outside`: what is said to be clear of the triangles is clear of the
// true shape.  Links that consist of primitives alone are also kept as such (`parts`), for checks
// that need no triangles.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesh/mesh_file.h"
#include "robot/description/model.h"

namespace twinbus {

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

// Up to 16 triangles that lie together, a lane each; the lanes behind the last repeat it.  Bounds
// are enlarged by more than single precision can lose.
struct alignas(64) TriangleCluster {
  static constexpr int kLanes = 16;
  float corner[3][3][kLanes];  // corner, coordinate, triangle
  float normal[3][kLanes];     // unit; zero for a triangle without area
  float offset[kLanes];        // normal . x of the plane
  float center[3];             // of the sphere around all
  float radius;
  float low[3], high[3];  // box around all
  int count;              // triangles that are real
};

struct LinkGeometry {
  int link = 0;
  TriangleMesh mesh;  // welded at 1 um, no triangle without area
  double outside = 0.0;
  TriangleMesh hull;  // convex; corners are points of the mesh, triangles face outwards
  Ball sphere;
  Capsule capsule;
  Eigen::Vector3d low, high;  // box along the link's axes
  std::vector<TriangleCluster> clusters;
  std::vector<Ball> balls;   // every triangle is inside their union
  std::vector<Shape> parts;  // the link's shapes when none of them is a mesh, else empty
  // A point of the surface of every shape: inside tests start there.
  std::vector<Eigen::Vector3d> witnesses;
};

struct GeometryOptions {
  bool balls = true;
  double ball_excess = 0.012;  // wanted: how far balls stick out of the hull [m]
  int most_balls = 24;         // per link
};

struct RobotGeometry {
  std::vector<LinkGeometry> links;  // those that bear collision shapes, by link index
  std::vector<int> of_link;         // [link_count]: index in links, -1 without shapes
};

// Throws std::runtime_error when a mesh cannot be read or a bound cannot be verified.
RobotGeometry build_geometry(const Model& model, const GeometryOptions& options = {});

// One link from its shapes; link_geometry of nothing has no triangles.
LinkGeometry link_geometry(const std::vector<Shape>& shapes, const GeometryOptions& options = {});

// Throws std::runtime_error naming the first bound that does not hold all triangles.
void verify(const LinkGeometry& geometry);

}  // namespace twinbus
