// Mass matrix and centroidal momentum by composite rigid bodies (Featherstone 2008, section 6.2).
//
//     kinetic energy = v' H v / 2,     momentum = A v,     v = (base linear, base angular, qd)
//
// v as in the columns of Kinematics::point_jacobian: velocity of link 0's origin and angular
// velocity of link 0, both in world.  Mimic joints are joints of their own.  A fixed base is the
// block of the joints.

#pragma once

#include <vector>

#include "robot/dynamics/spatial_force.h"

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
  struct alignas(64) Composite {  // a link and everything behind it
    PaddedVector inertia[3];      // about O, columns
    PaddedVector moment;
    StoredSpatial motion;  // of the joint that moves it
    StoredSpatial force;   // momentum of the composite at unit speed of that joint
    double mass = 0.0, rotor = 0.0;
    int parent = -1;
    bool slides = false;
  };

  Eigen::MatrixXd h_;
  std::vector<Composite> parts_;
};

}  // namespace twinbus
