// Integration of true order while a robot touches nothing: explicit, here, or implicit by Gauss's
// method (sim/articulated/gauss_legendre.h).
//
// State y = (p, Q, q; w, v, qd), w and v of the root in its own axes, so that their derivative is
// the spatial acceleration itself.  Q is treated as four plain numbers in all stages and normalised
// once a step: that keeps the order of every method on a turning base, where averaging angular
// velocities would lose it.  Methods: classical Runge-Kutta and Adams-Bashforth of order 4 (which
// begins with it), the 13 stages of Fehlberg 1968 with the weights of order 8.
//
// The body must be placed at the configuration given, and is placed at the result.

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "sim/articulated/aba.h"
#include "sim/articulated/gauss_legendre.h"
#include "sim/articulated/joint_law.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class FlightMotion {
 public:
  // Of config: the method, the base and the mass scale.
  FlightMotion(const Model& model, const WorldConfig& config);

  // Something else moved the robot, or its servos were told otherwise.
  void interrupt() noexcept {
    known_ = 0;
    if (gauss_) gauss_->interrupt();
  }

  // One step h.  False: a servo is too stiff for it or a joint law is not smooth (friction, play,
  // a stop in reach); the configuration is as it was, the body is placed at it.
  bool step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
            Configuration& configuration) noexcept;

 private:
  static constexpr int kStages = 13;

  void read(const Configuration& configuration) noexcept;
  void write(const Eigen::VectorXd& y, Configuration& configuration) const noexcept;
  // dy at the configuration at which the body is placed; false: singular.
  bool evaluate(ArticulatedBody& body, const std::vector<JointLaw>& joints,
                const Configuration& configuration, Eigen::VectorXd& dy) noexcept;
  bool stage(ArticulatedBody& body, const std::vector<JointLaw>& joints, int index) noexcept;
  bool runge_kutta(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h) noexcept;
  bool fehlberg(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h) noexcept;

  Flight method_;
  bool fixed_base_;
  Eigen::Index joints_, first_q_, first_qd_;
  Eigen::VectorXd y_, sum_, trial_;
  std::array<Eigen::VectorXd, kStages> k_;
  std::array<Eigen::VectorXd, 4> history_;  // of Adams-Bashforth, a ring
  int known_ = 0;                           // of them
  int newest_ = 0;
  Configuration scratch_;
  std::vector<JointRow> rows_;
  std::optional<GaussFlight> gauss_;  // for kGauss8
};

}  // namespace twinbus::sim
