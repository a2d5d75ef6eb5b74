// The distance of two placed shapes, from what was found at the last look to the triangles.
//
// A separating direction that is remembered, or another that is at hand, then the search of convex
// shapes (gjk.h), then triangle by triangle where hulls are nearly together.

#pragma once

#include <Eigen/Core>

#include "robot/collision/collision.h"
#include "robot/collision/collision_body.h"
#include "geometry/distance/mesh_distance.h"

namespace twinbus::inline robot {

// Of two shapes at the last look; it says where to look first, never what is there.
struct ShapeMemory {
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();  // a separating direction, in the first's frame
  MeshMemory nearest;
};

class ShapeGap {
 public:
  MeshDistance meshes;       // with room for every mesh that is asked about
  bool depths = true;        // of what touches
  double close = kGjkClose;  // how near a distance of convex shapes is to be [m]
  double parted = 0.0;       // so far at least are the two apart that were looked at last [m]

  // Of shapes whose `world` is set.  result.distance, when lower than before, is the signed distance,
  // at most `near` [m]; true when it was improved.  towards: where b may be seen from a.
  bool nearer(CollisionShape& a, CollisionShape& b, ShapeMemory& remembered,
              const Eigen::Vector3d& towards, double near, PairDistance& result) noexcept;

 private:
  bool own_distance(const CollisionShape& a, const CollisionShape& b,
                    const Eigen::Vector3d& towards_b, double near, PairDistance& result) noexcept;
  bool mesh_distance(const CollisionShape& a, const CollisionShape& b, double near, double at_least,
                     MeshMemory& memory, PairDistance& result) noexcept;
};

}  // namespace twinbus::robot
