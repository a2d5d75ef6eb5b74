// How near the convex hulls of a robot's links are to each other, and along which direction: for controllers that
// steer by smooth gradients.  Moving link b along the normal changes the distance by as much.
//
// Hulls are those of the meshes themselves (Collision, which asks about contact, has coarser ones that hold them, or
// the triangles).  Capsules around all shapes first (broad_phase.h), then all pairs that are left four at a time
// (gjk.h).  No memory, and no query allocates.

#pragma once

#include <memory>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus {

class HullDistances {
 public:
  // Pairs as Collision checks them.  Throws std::runtime_error if a mesh cannot be read.
  explicit HullDistances(const Model& model);
  ~HullDistances();

  const std::vector<CollisionPair>& pairs() const noexcept;

  // The pairs not farther apart than `near` [m], nearest first, at most capacity; returns how many.  Distances are right
  // to kGjkClose; where hulls overlap distance, points and normal are zero.
  int near(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
