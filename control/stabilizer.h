// Keeps the centre of mass over the feet: feedback of the divergent component of motion (DCM),
// turned into a ZMP.
//
//     xi  = x + v/omega + (L_y, -L_x) / (m z omega)                      the DCM, with angular
//     momentum L about the com p_r = clip( p_plan + (1 + k_r/omega) (xi_r - xi_plan) ) reference
//     pendulum: never jumps, always possible xi_r' = omega (xi_r - p_r),    x_r' = omega (xi_r -
//     x_r) p_d = p_r + (1 + k/omega) (xi - xi_r) + k_i integral(xi - xi_r)
//
// What the soles cannot do, e = p_d - clip(p_d), the reference gives up: it moves to the measured
// state, so that the legs never hold the body to a place that is lost.
//
//     xi_r += dt lambda e / (1 + k/omega),     x_r += dt lambda min(1, |e|/50 mm) (x - x_r)

#pragma once

#include <Eigen/Core>
#include <array>

#include "control/wrench_share.h"

namespace twinbus {

struct StabilizerGains {
  double dcm = 4.0;          // k [1/s]: the rate at which a DCM error decays
  double integral = 0.5;     // k_i [1/s]
  double leak = 3.0;         // of the integral [s]
  double reference = 3.0;    // k_r [1/s]
  double give_up = 8.0;      // lambda [1/s]
  double margin = 0.018;     // kept from the sole edges by the commanded centres of pressure [m]
  double least_load = 0.06;  // smallest load share of a foot
  double rebase = 0.3;  // time in which a step of the error at a change of source is let in [s]
};

// Horizontal plan of the centre of mass, ground frame.
struct ComPlan {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  Eigen::Vector2d acceleration = Eigen::Vector2d::Zero();
};

class Stabilizer {
 public:
  explicit Stabilizer(const StabilizerGains& gains) noexcept : gains_(gains) {}

  // The reference begins where the robot is and with its velocity.
  void start(const Eigen::Vector2d& com, const Eigen::Vector2d& velocity, double omega) noexcept;
  // Another source speaks from now on: the next step of the measured DCM is let in slowly.
  void rebase() noexcept { rebase_ = true; }
  // feedback false: the bare plan, for comparison.
  void update(const ComPlan& plan, const Eigen::Vector2d& com, const Eigen::Vector2d& dcm,
              const std::array<SoleOnGround, 2>& soles, double omega, double dt,
              bool feedback = true) noexcept;

  const Eigen::Vector2d& com_reference() const noexcept { return com_; }
  const Eigen::Vector2d& com_velocity_reference() const noexcept { return com_velocity_; }
  const Eigen::Vector2d& zmp_reference() const noexcept { return zmp_; }
  const Eigen::Vector2d& zmp_wanted() const noexcept { return zmp_wanted_; }  // before clipping
  const Eigen::Vector2d& excess() const noexcept { return excess_; }          // e
  const ZmpShare& share() const noexcept { return share_; }

 private:
  StabilizerGains gains_;
  bool rebase_ = false;
  Eigen::Vector2d com_ = Eigen::Vector2d::Zero(), com_velocity_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d dcm_ = Eigen::Vector2d::Zero(), zmp_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero(), bias_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d error_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d zmp_wanted_ = Eigen::Vector2d::Zero(), excess_ = Eigen::Vector2d::Zero();
  ZmpShare share_;
};

}  // namespace twinbus
