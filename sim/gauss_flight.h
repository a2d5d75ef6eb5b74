// Implicit integration of order 8 while a robot touches nothing: Gauss's collocation at four points
// of the step (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.7).
//
// The four accelerations of a step are looked for together, by fixed-point iteration from where
// those of the step before lead: evaluations side by side (sim/four_postures.h) cost little more
// than one.  Symplectic and symmetric: the energy of a chain does not drift however long it swings.
// The attitude is four plain numbers, of which these methods keep the norm.
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
  // A row for each point of the step.
  using Points = Eigen::Array<double, FourPostures::kCount, Eigen::Dynamic>;
  using Turns = Eigen::Array<double, FourPostures::kCount, 4>;

  enum class Outcome { kTaken, kWild, kNotForThis };

  Outcome advance(const std::vector<JointLaw>& joints, double h, int halvings,
                  Configuration& configuration) noexcept;
  void begin(const Configuration& configuration) noexcept;
  // Rates and places from the accelerations.
  void follow(double h, const Configuration& start) noexcept;
  void turn(double h, int sweeps) noexcept;
  // next_ at those; false: singular.
  bool evaluate(const std::vector<JointLaw>& joints) noexcept;
  Outcome settle(const std::vector<JointLaw>& joints, double h,
                 const Configuration& start) noexcept;
  bool finish(const std::vector<JointLaw>& joints, double h, Configuration& configuration) noexcept;

  bool floating_;
  Eigen::Index joints_;
  FourPostures four_;
  bool known_ = false;  // acceleration_ is that of the step before
  // Columns: root's angular and linear velocity in its own axes, then of the joints.
  Points acceleration_, next_, rates_;
  Eigen::ArrayXd start_rates_;
  Eigen::Array4d start_turn_ = Eigen::Array4d::Zero();  // x y z w
  Turns turns_ = Turns::Zero();
  Configuration before_;
};

}  // namespace twinbus
