// Keeps the centre of mass over the feet: feedback of the divergent component of motion (DCM), turned into a zero-moment
// point p and a lean of the trunk.
//
// With angular momentum L about the centre of mass (x, v), s = (L_y, -L_x) / (m z) and a its integral, which is the lean
// of the trunk times its inertia over m z [m],
//
//     x'' = omega^2 (x - p) - s'                              exactly, at constant height
//     Xi  = x + v / omega + s / omega + a                     the DCM with momentum and lean
//     Xi' = omega (Xi - (p + a))                              p and a act alike, and however a moves
//
// so u = p + a is what is fed back, and what the soles cannot give of it the trunk gives by leaning:
//
//     u = p_plan + (1 + k/omega) (Xi - xi_plan) + k_i integral,    a_wanted = u - clip(u),    p = clip(u - a)

#pragma once

#include <Eigen/Core>
#include <array>

#include "control/legs/wrench_share.h"

namespace twinbus::inline control {

struct StabilizerGains {
  double dcm = 4.0;          // k [1/s]: the rate at which a DCM error decays
  double integral = 0.5;     // k_i [1/s]
  double leak = 3.0;         // of the integral [s]
  double margin = 0.014;     // kept from the sole edges by the commanded centres of pressure [m]
  double least_load = 0.05;  // smallest load share of a foot
  double cop_filter =
      0.015;  // of the centres of pressure: a foot on a soft sole rocks when they jump [s]
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

  void start() noexcept;
  // Another source speaks from now on: the next step of the measured DCM is let in slowly.
  void rebase() noexcept { rebase_ = true; }
  // capture: Xi; lean: a, as they are; ground frame.
  void update(const ComPlan& plan, const Eigen::Vector2d& capture, const Eigen::Vector2d& lean,
              const std::array<SoleOnGround, 2>& soles, double omega, double dt) noexcept;

  const Eigen::Vector2d& zmp_wanted() const noexcept { return wanted_; }  // u
  const Eigen::Vector2d& lean_wanted() const noexcept { return lean_; }   // a_wanted
  const ZmpShare& share() const noexcept { return share_; }               // p and who carries it

 private:
  StabilizerGains gains_;
  bool rebase_ = false, fresh_ = true;
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero(), bias_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d error_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d wanted_ = Eigen::Vector2d::Zero(), lean_ = Eigen::Vector2d::Zero();
  ZmpShare share_;
};

}  // namespace twinbus::control
