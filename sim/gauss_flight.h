// Implicit integration of order 8 while a robot touches nothing: Gauss's collocation at four points
// of the step (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.7).
//
// The four accelerations of a step are looked for together, by iteration from where those of the
// step before lead: evaluated side by side (sim/four_postures.h), as a whole until the postures are
// nearly known; then so are their inertias, and only forces are evaluated anew.
//
// How the robot moves in the axes of link 0 depends neither on how these stand nor on how fast they
// go: attitude and position follow when the iteration is done.  Symplectic and symmetric: the energy
// of a chain does not drift however long it swings.  The attitude is four plain numbers, of which
// these methods keep the norm.
//
// The same promises as sim/flight.h's.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/kinematics.h"
#include "sim/articulated_body.h"
#include "sim/four_postures.h"
#include "sim/joint_law.h"

namespace twinbus {

class GaussFlight {
 public:
  // A model that ArticulatedBody takes.
  GaussFlight(const Model& model, bool fixed_base, double mass_scale);

  // Something else moved the robot, or its servos were told otherwise.
  void interrupt() noexcept { known_ = false; }

  // One step h, in smaller ones while the motion is too wild for it; the joint laws must be smooth.
  // False: a servo is too stiff for it or a stop in reach; the configuration is as it was.
  bool step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
            Configuration& configuration) noexcept;

 private:
  using Points = FourPostures::Accelerations;  // a row for each point of the step
  using Turns = Eigen::Array<double, FourPostures::kCount, 4>;

  enum class Outcome { kTaken, kWild, kNotForThis };

  Outcome advance(const std::vector<JointLaw>& joints, double h, int halvings,
                  Configuration& configuration) noexcept;
  void begin(const std::vector<JointLaw>& joints, const Configuration& configuration) noexcept;
  // The postures, and the torques there, to which the accelerations lead.
  void aim(const std::vector<JointLaw>& joints, double h) noexcept;
  Outcome settle(const std::vector<JointLaw>& joints, double h) noexcept;
  bool finish(const std::vector<JointLaw>& joints, double h, Configuration& configuration) noexcept;
  void finish_base(double h, Configuration& configuration) noexcept;

  bool floating_;
  Eigen::Index joints_;
  FourPostures four_;
  bool known_ = false;   // acceleration_ is that of the step before
  bool driven_ = false;  // there are torques
  Points acceleration_, next_;
  // Columns of four_.
  Eigen::ArrayXd start_q_, start_qd_;
  Eigen::Array3d start_spin_ =
      Eigen::Array3d::Zero();  // angular velocity of link 0 in its own axes
  Eigen::Array4d start_turn_ = Eigen::Array4d::Zero();  // x y z w
  Configuration before_;
};

}  // namespace twinbus
