// Preview control of the zero-moment point (ZMP): the centre of mass of a cart on a table that makes the ZMP follow what
// is known of it ahead, with little jerk.
//
//     p = x - x''/omega^2,     x''' = u,     least  sum (p - p_wanted)^2 + r u^2
//
// Kajita et al.: Biped walking pattern generation by using preview control of zero-moment point, ICRA 2003.  The optimum
// is linear: u = -k (x, x', x'') + sum f_i p_wanted(i).  Where dcm_plan.h hits every ZMP and lets the acceleration of the
// centre of mass turn in a corner, this rounds the corner.  One horizontal axis.

#pragma once

#include <Eigen/Core>
#include <vector>

namespace twinbus::inline control {

// One horizontal axis.
struct Cart {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;  // [m], [m/s], [m/s^2]
};

class PreviewControl {
 public:
  // height: of the centre of mass [m]; every: between two ZMPs that are known [s]; count: of them; jerk: r [s^6].
  // Allocates.  Throws std::invalid_argument unless all are positive.
  PreviewControl(double height, double every, int count, double jerk = 1e-6);

  int count() const noexcept { return static_cast<int>(share_.size()); }
  double every() const noexcept { return every_; }  // [s]

  // Jerk [m/s^3] of a cart whose ZMP is to be wanted[i] when i + 1 times `every` have passed; count() of them [m].
  double jerk(const Cart& cart, const double* wanted) const noexcept;
  // dt later; exact while the jerk is held.
  static Cart advance(const Cart& cart, double jerk, double dt) noexcept;
  double zmp(const Cart& cart) const noexcept {
    return cart.position - cart.acceleration / (omega_ * omega_);
  }
  // With that position, DCM and ZMP.
  Cart cart(double position, double dcm, double zmp) const noexcept {
    return {position, omega_ * (dcm - position), omega_ * omega_ * (position - zmp)};
  }
  double dcm(const Cart& cart) const noexcept { return cart.position + cart.velocity / omega_; }

 private:
  double omega_, every_;
  Eigen::RowVector3d gain_;    // k
  std::vector<double> share_;  // f_i
};

}  // namespace twinbus::control
