// The trunk leans when the soles are exhausted: turning with a push buys time that the feet cannot give.
//
//     L' = I theta'',   theta'' = w^2 (theta* - theta) - 2 zeta w theta'     roll and pitch of the base, by the ground
//     phi'' = w_b^2 (phi* - phi) - 2 w_b phi'                                the waist joints on top of it, by their servos
//
// theta* and phi* follow the lean a that is wanted; in metres a = (I_theta theta + I_phi phi) / (m z), shared by phi = r theta.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline control {

struct TrunkYieldGains {
  double frequency = 8.0;    // w [rad/s]
  double damping = 1.0;      // zeta
  double limit = 0.29;       // of theta* [rad]
  double most = 30.0;        // largest angular acceleration [rad/s^2]
  double filter = 0.015;     // of theta* [s]
  double waist = 1.3;        // r
  double waist_rate = 10.0;  // w_b [rad/s]
};

class TrunkYield {
 public:
  explicit TrunkYield(const TrunkYieldGains& gains) noexcept : gains_(gains) {}

  // base, waist: inertia about the centre of mass that turning them moves, over the mass, roll and pitch [m^2].
  // most_waist: farthest the waist may bend [rad].
  void start(const Eigen::Vector2d& base, const Eigen::Vector2d& waist,
             const Eigen::Vector2d& most_waist) noexcept;
  // wanted: a [m], ground axes; angle, rate: of the base, roll and pitch [rad], [rad/s]; height: z [m].
  void update(const Eigen::Vector2d& wanted, const Eigen::Vector2d& angle,
              const Eigen::Vector2d& rate, double height, double dt) noexcept;

  // a of the base at this angle and the waist as it is [m].
  Eigen::Vector2d lean(const Eigen::Vector2d& angle, double height) const noexcept;
  const Eigen::Vector2d& target() const noexcept { return target_; }              // theta*
  const Eigen::Vector2d& acceleration() const noexcept { return acceleration_; }  // theta''
  Eigen::Vector2d moment_per_mass() const noexcept {  // L' / m [m^2/s^2]
    return base_.cwiseProduct(acceleration_);
  }
  const Eigen::Vector2d& waist() const noexcept { return waist_angle_; }  // phi: roll, pitch [rad]
  const Eigen::Vector2d& waist_rate() const noexcept { return waist_rate_; }
  const Eigen::Vector2d& waist_acceleration() const noexcept { return waist_acceleration_; }

 private:
  TrunkYieldGains gains_;
  Eigen::Vector2d base_ = Eigen::Vector2d::Ones(), waist_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d most_waist_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d target_ = Eigen::Vector2d::Zero(), acceleration_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d waist_angle_ = Eigen::Vector2d::Zero(), waist_rate_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d waist_acceleration_ = Eigen::Vector2d::Zero();
};

}  // namespace twinbus::control
