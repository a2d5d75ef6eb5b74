#include "test/oracles/lipm.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus {

Lipm::Lipm(double height) : omega_(std::sqrt(kGravity / height)) {
  if (!(std::isfinite(height) && height > 0.0)) {
    throw std::invalid_argument("Lipm: height must be positive, got " + std::to_string(height));
  }
}

LipmState Lipm::advance(const LipmState& state, double zmp, double dt) const noexcept {
  const double c = std::cosh(omega_ * dt);
  const double s = std::sinh(omega_ * dt);
  const double x = state.position - zmp;
  return {.position = zmp + x * c + state.velocity / omega_ * s,
          .velocity = x * omega_ * s + state.velocity * c};
}

double Lipm::capture_point(const LipmState& state) const noexcept {
  return state.position + state.velocity / omega_;
}

// The capture point leaves the ZMP exponentially: (target - zmp) = (now - zmp) e^(omega dt).
double Lipm::zmp_to_reach(double target, const LipmState& state, double dt) const noexcept {
  const double growth = std::exp(omega_ * dt);
  return (target - growth * capture_point(state)) / (1.0 - growth);
}

}  // namespace twinbus
