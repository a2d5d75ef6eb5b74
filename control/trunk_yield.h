// The trunk gives way when the soles are exhausted: bending with a push buys deceleration that the
// feet cannot give.
//
// An excess e of wanted ZMP is paid with a change of angular momentum, L_y' = m g e_x, L_x' = -m g
// e_y, by turning the trunk, which springs back upright when the excess is gone:
//
//     theta'' = L' / I  -  2 zeta w theta'  -  w^2 theta          theta: roll and pitch of the base
//     reference

#pragma once

#include <Eigen/Core>

namespace twinbus {

struct TrunkYieldGains {
  double gyration = 0.30;  // radius of gyration that is turned, of the whole mass [m]
  double share = 0.6;      // of the excess that is paid this way
  double frequency = 3.5;  // w [rad/s]
  double damping = 0.9;    // zeta
  double limit = 0.30;     // [rad]
  double most = 25.0;      // largest angular acceleration [rad/s^2]
};

class TrunkYield {
 public:
  explicit TrunkYield(const TrunkYieldGains& gains) noexcept : gains_(gains) {}

  void start() noexcept;
  // excess in the ground frame [m].
  void update(const Eigen::Vector2d& excess, double dt) noexcept;

  const Eigen::Vector2d& angle() const noexcept { return angle_; }  // roll, pitch [rad]
  const Eigen::Vector2d& rate() const noexcept { return rate_; }
  const Eigen::Vector2d& acceleration() const noexcept { return acceleration_; }

 private:
  TrunkYieldGains gains_;
  Eigen::Vector2d angle_ = Eigen::Vector2d::Zero(), rate_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d acceleration_ = Eigen::Vector2d::Zero();
};

}  // namespace twinbus
