// The one door to FCL: the independent oracle of our own collision checks.

#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "robot/mesh_file.h"
#include "robot/model.h"

namespace twinbus {

struct FclShape;

// size: as in Shape; not for a mesh.
std::shared_ptr<FclShape> fcl_primitive(ShapeKind kind, const Eigen::Vector3d& size);
std::shared_ptr<FclShape> fcl_hull(const TriangleMesh& hull);
std::shared_ptr<FclShape> fcl_mesh(const TriangleMesh& mesh);

// By libccd, its other solver.  Allocates.
bool fcl_touches(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
                 const Eigen::Isometry3d& pose_b);

}  // namespace twinbus
