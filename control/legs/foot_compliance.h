// What makes the soles carry what was shared: the moment that a sole's sensor misses is added to the torque of its ankle.
//
//     c' = w_a (M* - M) - c / T_a          M* as late as the servo and the filter make M
//
// Friction, backlash and what servo gains hold back take up newton metres that the model knows nothing of; a newton metre
// is a millimetre of the zero-moment point.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus::inline control {

struct FootComplianceGains {
  double ankle = 10.0;       // w_a [1/s]
  double ankle_leak = 2.0;   // T_a [s]
  double filter = 0.008;     // of the measured wrenches [s]
  double lag = 0.016;        // of the measured behind the wanted, filter included [s]
  double most_lever = 0.03;  // of c, as a shift of the centre of pressure [m]
};

struct FootLoad {
  double force = 0.0;                                // vertical [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // about the sole frame, roll and pitch [N m]
};

class FootCompliance {
 public:
  explicit FootCompliance(const FootComplianceGains& gains) noexcept : gains_(gains) {}

  void start() noexcept;
  // measured_valid false: the loops rest and leak.
  void update(const std::array<FootLoad, 2>& wanted, const std::array<FootLoad, 2>& measured,
              bool measured_valid, double dt) noexcept;

  // c, to be added to the moment that is fed forward [N m].
  const Eigen::Vector2d& moment(int foot) const noexcept {
    return moment_[static_cast<std::size_t>(foot)];
  }

 private:
  FootComplianceGains gains_;
  bool fresh_ = true;
  std::array<FootLoad, 2> measured_, late_;
  std::array<Eigen::Vector2d, 2> moment_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
};

}  // namespace twinbus::control
