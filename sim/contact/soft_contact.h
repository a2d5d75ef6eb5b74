// MuJoCo's contact between the robot and what stands fixed: soft, as hard as the link that it moves is heavy, with friction that
// creeps.  For controllers that were made in it.
//
// A point that is in by the depth d and moves with v against the surface is asked for the acceleration a of a critically damped
// spring, and its force f falls short of it by R f (MuJoCo's documentation, "Computation", with its default solref and solimp):
//
//     R f = a - (v+ - v) / h,   a_normal = b (-v_n) + i k d,  a_tangent = -b v_t,   |f_t| <= mu f_n, f_n >= 0
//     b = 2 / (0.95 T),  k = 1 / (0.95 T)^2,  T = 0.02 s or two steps,  i = 0.9 ... 0.95 over the first millimetre
//     R_tangent = (1 - i) / i w (1 + mu^2),  R_normal = mu^2 / 2 R_tangent     (of its pyramid, as it is for a point that sticks)
//
// so a foot that is held by f creeps at R_tangent f / b.  w is the inverse mass of the link at its centre of mass: all joints at
// zero, rotors and what the joints' dampers add in a step.  The cone is round here.  Not of it: bodies that move against one another.

#pragma once

#include <vector>

#include "sim/articulated/joint_law.h"
#include "sim/contact/contact_solve.h"

namespace twinbus::inline sim {

class SoftContact {
 public:
  // Throws std::runtime_error as ArticulatedBody does.
  SoftContact(const Model& model, const WorldConfig& config);

  // Before a step: w, anew where a joint's damping has changed by a quarter.
  void weigh(const std::vector<JointLaw>& joints) noexcept;
  // Goes on as another of the same robot.
  void resume(const SoftContact& other) noexcept;
  // Those of the robot with what is fixed get this law; not yet touching ones are taken out.
  void give(double h, std::vector<Contact>& contacts) const noexcept;

  // Of one point of a link that carries that force at rest [N/m]; [N s/m].
  double stiffness(int link, double friction, double force) const noexcept;
  double damping(int link, double friction, double force) const noexcept;

 private:
  void weigh_links() noexcept;
  struct Law {
    double reference, rate;  // i k d [m/s^2], b [1/s]
    double normal, tangent;  // R [1/kg]
  };
  Law law(int link, double friction, double depth) const noexcept;
  double depth_under(int link, double friction, double force) const noexcept;

  ArticulatedBody body_;
  std::vector<Eigen::Vector3d> coms_;  // of links, about the body's common point [m]
  std::vector<double> rotors_;         // of joints [kg m^2]
  std::vector<JointRow> rows_;
  std::vector<double> weighed_;         // gains of joints that w is of
  std::vector<double> inverse_masses_;  // w by link [1/kg]
  double step_, time_constant_;         // [s]
};

}  // namespace twinbus::sim
