// Distance of two triangle meshes, exactly, without the heap: what lies between hulls and contact.
//
// Clusters of triangles whose bounds are nearer than the nearest so far, then their triangles, eight
// at a time in single precision; the two triangles that win are measured again in double precision.
// A distance is wrong by a micrometre at most.  What was nearest at the last look is measured first:
// that makes the rest short, and changes which of equally near points are named, never the distance.

#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "geometry/distance/gjk.h"
#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline geometry {

class ClusteredMesh {
 public:
  // triangles not empty.
  explicit ClusteredMesh(const TriangleMesh& mesh);
  ~ClusteredMesh();

  int clusters() const noexcept;

 private:
  friend class MeshDistance;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct MeshMemory {
  int cluster_a = -1;
  int cluster_b = -1;
};

struct MeshGap {
  double distance = 0.0;                              // [m]; zero when surfaces cross
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();  // in the frame of the poses
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
};

class MeshDistance {
 public:
  MeshDistance();
  ~MeshDistance();

  // Makes room for this mesh; before it is asked about.
  void reserve(const ClusteredMesh& mesh);

  // False when they are `below` [m] or farther apart.  at_least: a bound that is known already [m];
  // what is that near is not searched further.
  bool between(const ClusteredMesh& a, const Eigen::Isometry3d& pose_a, const ClusteredMesh& b,
               const Eigen::Isometry3d& pose_b, double below, double at_least, MeshMemory& memory,
               MeshGap& gap) noexcept;

  // The same of a mesh and a box, sphere or cylinder.
  bool between(const ClusteredMesh& a, const Eigen::Isometry3d& pose_a, const GjkShape& b,
               const Eigen::Isometry3d& pose_b, double below, MeshMemory& memory,
               MeshGap& gap) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::geometry
