// Mass matrix and centroidal momentum by composite rigid bodies (Featherstone 2008, section 6.2).
//
//     kinetic energy = v' H v / 2,     momentum = A v,     v = (base linear, base angular, qd)
//
// v as in the columns of Kinematics::point_jacobian: velocity of link 0's origin and angular
// velocity of link 0, both in world.  Mimic joints are joints of their own.  A fixed base is the
// block of the joints.

#pragma once

#include <vector>

#include "robot/kinematics.h"
#include "robot/model.h"
#include "robot/spatial_force.h"

namespace twinbus {

class MassMatrix {
 public:
  explicit MassMatrix(const Model& model);

  // kinematics: updated; velocities do not matter.  Rotor inertia is included.
  void update(const Kinematics& kinematics) noexcept;

  // [(6 + joint_count) x (6 + joint_count)], symmetric, both halves filled.
  const Eigen::MatrixXd& matrix() const noexcept { return h_; }

  // map [6 x (6 + joint_count)], sized by the caller: rows linear momentum, then angular momentum
  // about the centre of mass, both in world.  Rotors carry none.
  void centroidal_map(Eigen::MatrixXd& map) const noexcept;

 private:
  const Model* model_;
  Eigen::MatrixXd h_;
  std::vector<RigidInertia> composite_;
  std::vector<Spatial> motion_, force_;  // per joint; force: momentum of what hangs on it
  Eigen::Vector3d com_;                  // from link 0's origin
};

}  // namespace twinbus
