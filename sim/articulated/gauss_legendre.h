// Implicit integration of order 8 while a robot touches nothing: Gauss's collocation at four points
// of the step (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.7).
//
// The four accelerations of a step are looked for together, by iteration from where those of the
// step before lead, evaluated side by side (sim/articulated/aba4.h): the robots are weighed until their
// postures are nearly known, and only forces are evaluated anew after that.
//
// Where an error is named, a step is taken in parts that are as long as it allows: their accelerations
// are polynomials over time, and how small the last two of the four are tells how wrong they are.
//
// How the robot moves in the axes of link 0 depends neither on how these stand nor on how fast they
// go: attitude and position follow when the iteration is done.  Symplectic and symmetric: the energy
// of a chain does not drift however long it swings.  The attitude is four plain numbers, of which
// these methods keep the norm.
//
// The same promises as sim/articulated/free_flight.h's.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "sim/articulated/aba.h"
#include "sim/articulated/aba4.h"
#include "sim/articulated/joint_law.h"

namespace twinbus::inline sim {

class GaussFlight {
 public:
  // A model that ArticulatedBody takes.  most_error: of the speeds after a part of a step [rad/s],
  // [m/s]; 0: a step is one part.
  GaussFlight(const Model& model, bool fixed_base, double mass_scale, double most_error);

  // Something else moved the robot, or its servos were told otherwise.
  void interrupt() noexcept { last_step_ = 0.0; }

  // One step h, in parts where the motion is too wild for it; the joint laws must be smooth.
  // False: a servo is too stiff for it or a stop in reach; the configuration is as it was.
  bool step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
            Configuration& configuration) noexcept;

 private:
  using Points = FourPostures::Accelerations;  // a row for each point of the step
  using Turns = Eigen::Array<double, FourPostures::kCount, 4>;

  enum class Outcome { kTaken, kWild, kNotForThis };

  void begin(const std::vector<JointLaw>& joints, const Configuration& configuration) noexcept;
  void guess(double h) noexcept;
  // The postures, and the torques there, to which the accelerations lead.
  void aim(const std::vector<JointLaw>& joints, double h) noexcept;
  Outcome settle(const std::vector<JointLaw>& joints, double h) noexcept;
  double error(double h) const noexcept;
  double longer(double error) const noexcept;
  // False: at a stop.
  bool finish(const std::vector<JointLaw>& joints, double h) noexcept;
  void finish_base(double h) noexcept;
  void end(Configuration& configuration) const noexcept;

  // Where a part of a step begins.
  struct Start {
    Eigen::ArrayXd q, qd;
    Eigen::Array3d spin = Eigen::Array3d::Zero();  // angular velocity of link 0 in its own axes
    Eigen::Array4d turn = Eigen::Array4d::Zero();  // x y z w
    Eigen::Vector3d place = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  };

  bool floating_;
  Eigen::Index joints_;
  double most_error_;
  FourPostures four_;
  bool driven_ = false;                // there are torques
  double last_step_ = 0.0;             // 0: not known
  double error_ = 0.0;                 // of the part that settled, where it matters
  double reach_ = 0.0;                 // how long a part may be
  Points acceleration_, next_, last_;  // last: of the part before
  Start start_;
};

}  // namespace twinbus::sim
