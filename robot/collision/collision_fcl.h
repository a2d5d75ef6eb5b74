// The one door to FCL: the independent oracle of our own collision checks.

#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "geometry/mesh/mesh_file.h"
#include "robot/description/model.h"

namespace twinbus {

struct FclShape;

// size: as in Shape; not for a mesh.
std::shared_ptr<FclShape> fcl_primitive(ShapeKind kind, const Eigen::Vector3d& size);
std::shared_ptr<FclShape> fcl_hull(const TriangleMesh& hull);
std::shared_ptr<FclShape> fcl_mesh(const TriangleMesh& mesh);

// Distance [m] and nearest points, in world; zero and no points when they touch.
struct FclGap {
  double distance = 0.0;
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero(), point_b = Eigen::Vector3d::Zero();
};
// False when FCL gives up.  Allocates.
bool fcl_gap(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
             const Eigen::Isometry3d& pose_b, FclGap& gap) noexcept;

// By libccd, its other solver.  Allocates.
bool fcl_touches(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
                 const Eigen::Isometry3d& pose_b);

}  // namespace twinbus
