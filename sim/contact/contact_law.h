// Force of one contact point as a function of its velocity at the END of the step: compliant
// normal, isotropic Coulomb friction with a bristle.
//
//     vn = n.v     end depth  d+ = d - h vn
//     normal       fn = d+ (k - c vn / ramp)   if d+ < ramp     never pulls
//                  fn = k d+ - c vn            beyond it
//                  fn = k d+ (1 - a vn)        of Hunt and Crossley 1975: the same with a ramp that
//                                              no depth reaches, and c = a k ramp
//     friction     f* = -kt s - (ct + h kt) vt                  s: stretch of the bristle
//                  sticks with ft = f* if |f*| <= mu fn, else slips with ft = mu fn f*/|f*|
//
// The return to the cone is backward Euler of a spring and damper in series with a Coulomb slider
// (radial return of plasticity; for friction: Lacoursiere and Wriggers 2006, chapter 5).  The
// damping ramp lets a landing begin without a jump of force.  An impact at v on Hunt and Crossley's
// ground leaves at v_out, where a (v + v_out) = ln((1 + a v) / (1 - a v_out)), whatever k is.

#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace twinbus {

inline constexpr double kDampingRamp = 1e-4;  // depth at which linear damping is complete [m]
inline constexpr double kEndlessRamp = 1.0;   // deeper than anything sinks in [m]

struct ContactParams {
  double stiffness = 0.0;          // k [N/m]
  double damping = 0.0;            // c [N s/m]
  double tangent_stiffness = 0.0;  // kt [N/m]
  double tangent_damping = 0.0;    // ct [N s/m]
  double friction = 0.0;           // mu
  double ramp = kDampingRamp;      // depth at which the damping is complete [m]
};

// With Hunt and Crossley's damping instead of its own.  dissipation: a [s/m].
inline ContactParams hunt_crossley(ContactParams params, double dissipation) noexcept {
  params.ramp = kEndlessRamp;
  params.damping = dissipation * params.stiffness * kEndlessRamp;
  return params;
}

// Of a point so deep [N s/m].
inline double damping_at(const ContactParams& params, double depth) noexcept {
  return params.damping * std::clamp(depth / params.ramp, 0.0, 1.0);
}

enum class ContactMode { kOpen, kStick, kSlip };

struct ContactForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    // on the robot [N]
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  // -d force / d v [N s/m], may be unsymmetric
  ContactMode mode = ContactMode::kOpen;
};

// depth and stretch: at the start of the step; v: at its end; h: the step.  smooth > 0 rounds the
// corners of the law off over so much force [N]; that is a help for solvers, not a law to apply.
void contact_force(const ContactParams& params, double depth, const Eigen::Vector3d& normal,
                   const Eigen::Vector3d& stretch, const Eigen::Vector3d& v, double h,
                   bool with_tangent, double smooth, ContactForce& out) noexcept;

// Of a tie: -k stretch - (c + h k) v; of it only what acts along, if that is not null.
void tie_force(const ContactParams& params, const Eigen::Vector3d* along,
               const Eigen::Vector3d& stretch, const Eigen::Vector3d& v, double h,
               bool with_tangent, ContactForce& out) noexcept;

}  // namespace twinbus
