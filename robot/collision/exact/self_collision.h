// Which pairs of links touch, exactly: every triangle of one against every triangle of the other,
// in microseconds and without the heap.
//
// Kinematics, then spheres around links, then capsules, then clusters of triangles, then triangles
// by the separating axis test; each stage leaves out what cannot touch.  Touching means that
// surfaces cross, or that one link is inside the other.  Single precision relative to link 0: a
// verdict can be wrong where surfaces are within a micrometre of touching, nowhere else.  All
// instruction sets give the same verdicts, bit for bit: nothing is fused or reordered.

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/collision/links/link_geometry.h"
#include "common/simd/instruction_set.h"
#include "robot/collision/exact/posture_cells.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

class SelfCollision {
 public:
  // pairs: links that bear geometry; by default pairs_to_check(model).  The model and the geometry
  // may go away.  Throws std::invalid_argument when a pair has a link without geometry.
  SelfCollision(const Model& model, const RobotGeometry& geometry);
  SelfCollision(const Model& model, const RobotGeometry& geometry,
                const std::vector<CollisionPair>& pairs);
  ~SelfCollision();

  const std::vector<CollisionPair>& pairs() const noexcept;

  // Takes a posture in: q [joint_count], mimic joints included, finite.
  void place(const Eigen::VectorXd& q) noexcept;

  // All that touch at the posture; `hit` holds their indices in pairs() until the next call.
  int touching() noexcept;
  const int* hit() const noexcept;
  // Does any?  Which one is found first is not said.
  bool any_touching() noexcept;
  bool touches(int pair) noexcept;
  bool surfaces_cross(int pair) noexcept;  // without asking whether one is inside the other

  // Lower bound of the distance of a pair from the capsules around its links [m]; below zero when
  // they overlap.
  double lower_bound(int pair) noexcept;
  // The same of all pairs, into bounds [pairs().size()].
  void lower_bounds(float* bounds) noexcept;

  // A pair can be left out and taken in again at run time.
  void enable(int pair, bool on) noexcept;

  // What pairs with few joints between them can touch with (find_joint_cells of pairs()): touching and
  // any_touching say the same as without, sooner.
  void use(std::vector<JointCells> cells);

  // Tests compare them; a set that the machine lacks counts as the best it has.
  void use(InstructionSet set) noexcept;

  struct Work {  // since construction
    long spheres = 0, capsules = 0, clusters = 0, rows = 0;
  };
  const Work& work() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::robot
