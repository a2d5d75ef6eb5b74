// Millimetres of leg length are hundreds of newtons: where the soles are really sent so that they
// carry what was shared.
//
//     delta' = w_a / k_a (M - M*) - delta / T_a        ankle admittance: turns a sole until its
//     moment is the one wanted d'     = w_f / k_f ((f_L - f_R) - (f_L - f_R)*) - d / T_f      force
//     difference: lengthens one leg, shortens the other sink   = f* / k_v,  bend = -M* / k_b
//     compression of the sole alone, fed forward
//
// w are bandwidths [1/s], k_a and k_f the stiffness of sole and leg servos in series: numbers that
// carry over to other robots.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus {

struct FootComplianceGains {
  double ankle = 10.0;           // w_a [1/s]
  double ankle_leak = 2.0;       // T_a [s]
  double difference = 30.0;      // w_f [1/s]
  double difference_leak = 4.0;  // T_f [s]: long, or a sole height error is never made up for
  double filter = 0.008;         // of the measured wrenches [s]
  double most_angle = 0.06;      // [rad]
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
  // sole: of one sole alone; series: with the leg servos.  All positive.
  FootCompliance(const FootComplianceGains& gains, const FootStiffness& sole,
                 const FootStiffness& series) noexcept
      : gains_(gains), sole_(sole), series_(series) {}

  void start() noexcept;
  // measured_valid false: the loops rest and leak.
  void update(const std::array<FootLoad, 2>& wanted, const std::array<FootLoad, 2>& measured,
              bool measured_valid, double dt) noexcept;

  Eigen::Vector2d angle(int foot) const noexcept {  // roll, pitch to be added [rad]
    return angle_[static_cast<std::size_t>(foot)] + bend_[static_cast<std::size_t>(foot)];
  }
  double height(int foot) const noexcept;  // to be added to the sole's height [m]

 private:
  FootComplianceGains gains_;
  FootStiffness sole_, series_;
  bool fresh_ = true;
  std::array<FootLoad, 2> measured_;
  std::array<Eigen::Vector2d, 2> angle_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  std::array<Eigen::Vector2d, 2> bend_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double difference_ = 0.0;
  std::array<double, 2> sink_{};
};

}  // namespace twinbus
