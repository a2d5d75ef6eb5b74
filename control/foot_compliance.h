// Millimetres of leg length are hundreds of newtons: what makes the soles carry what was shared.
//
//     c'   = w_a (M* - M) - c / T_a                     moment added to what is fed forward, per sole
//     d'   = w_f / k_f ((f_L - f_R) - (f_L - f_R)*) - d / T_f   force difference: lengthens one leg
//     sink = f* / k_v,  bend = -M* / k_b                compression of the sole alone, fed forward
//
// w are bandwidths [1/s], k_f the stiffness of sole and leg servos in series: numbers that carry
// over to other robots.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus {

struct FootComplianceGains {
  double ankle = 10.0;           // w_a [1/s]
  double ankle_leak = 2.0;       // T_a [s]
  double difference = 20.0;      // w_f [1/s]
  double difference_leak = 4.0;  // T_f [s]: long, or a sole height error is never made up for
  double filter = 0.008;         // of the measured wrenches [s]
  double lag = 0.016;            // of the measured behind the wanted, filter included [s]
  double most_lever = 0.03;      // of c, as a shift of the centre of pressure [m]
  double most_height = 0.03;     // of d [m]
};

struct FootLoad {
  double force = 0.0;                                // vertical [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // about the sole frame, roll and pitch [N m]
};

struct FootStiffness {
  double vertical = 0.0;                              // [N/m]
  Eigen::Vector2d turning = Eigen::Vector2d::Zero();  // roll, pitch [N m/rad]
};

class FootCompliance {
 public:
  // sole: of one sole alone; vertical: with the leg servos.  All positive.
  FootCompliance(const FootComplianceGains& gains, const FootStiffness& sole,
                 double vertical) noexcept
      : gains_(gains), sole_(sole), vertical_(vertical) {}

  void start() noexcept;
  // measured_valid false: the loops rest and leak.
  void update(const std::array<FootLoad, 2>& wanted, const std::array<FootLoad, 2>& measured,
              bool measured_valid, double dt) noexcept;

  // Roll and pitch to be added to the sole's attitude [rad].
  const Eigen::Vector2d& angle(int foot) const noexcept {
    return bend_[static_cast<std::size_t>(foot)];
  }
  double height(int foot) const noexcept;  // to be added to the sole's height [m]
  // To be added to the moment that is fed forward [N m].
  const Eigen::Vector2d& moment(int foot) const noexcept {
    return moment_[static_cast<std::size_t>(foot)];
  }

 private:
  FootComplianceGains gains_;
  FootStiffness sole_;
  double vertical_;
  bool fresh_ = true;
  std::array<FootLoad, 2> measured_, late_;
  std::array<Eigen::Vector2d, 2> moment_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  std::array<Eigen::Vector2d, 2> bend_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double difference_ = 0.0;
  std::array<double, 2> sink_{};
};

}  // namespace twinbus
