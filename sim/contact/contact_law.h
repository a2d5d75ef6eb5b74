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
// Against rolling and spinning, if asked for, with w the angular velocity at the END of the step and s how far that bristle is
// turned:
//
//     rolling      m* = -kr s - (cr + h kr) w     of s and w what lies in the surface
//                  holds with m = m* if |m*| <= rolling fn, else yields with m = rolling fn m*/|m*|
//     torsion      the same about the normal, with torsional fn
//     kr = kt l^2, cr = ct l^2                    as of bristles so far (kTurningLever) from the point
//
// The return to the cone is backward Euler of a spring and damper in series with a Coulomb slider
// (radial return of plasticity; for friction: Lacoursiere and Wriggers 2006, chapter 5).  The
// damping ramp lets a landing begin without a jump of force.  An impact at v on Hunt and Crossley's
// ground leaves at v_out, where a (v + v_out) = ln((1 + a v) / (1 - a v_out)), whatever k is.

#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace twinbus::inline sim {

inline constexpr double kDampingRamp = 1e-4;  // depth at which linear damping is complete [m]
inline constexpr double kEndlessRamp = 1.0;   // deeper than anything sinks in [m]

struct ContactParams {
  double stiffness = 0.0;          // k [N/m]
  double damping = 0.0;            // c [N s/m]
  double tangent_stiffness = 0.0;  // kt [N/m]
  double tangent_damping = 0.0;    // ct [N s/m]
  double friction = 0.0;           // mu
  double ramp = kDampingRamp;      // depth at which the damping is complete [m]
  double rolling = 0.0;            // moment against rolling, of the normal force [m]
  double torsional = 0.0;          // moment against spinning, of the normal force [m]
};

inline constexpr double kTurningLever = 0.05;  // l [m]

inline bool turns(const ContactParams& params) noexcept { return params.rolling > 0.0 || params.torsional > 0.0; }
inline double turning_stiffness(const ContactParams& params) noexcept {  // kr [N m]
  return kTurningLever * kTurningLever * params.tangent_stiffness;
}
inline double turning_damping(const ContactParams& params) noexcept {  // cr [N m s]
  return kTurningLever * kTurningLever * params.tangent_damping;
}

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

struct TurningMoment {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();     // on the robot [N m]
  Eigen::Matrix3d by_turning = Eigen::Matrix3d::Zero();  // -d moment / d w [N m s]
  Eigen::Matrix3d by_moving = Eigen::Matrix3d::Zero();   // -d moment / d v, of the point [N s]
};

// turned: at the start of the step, w: at its end; press: the contact's force at its end, steep: -d press / d v along the
// normal [N s/m].
TurningMoment turning_moment(const ContactParams& params, const Eigen::Vector3d& normal, const Eigen::Vector3d& turned,
                             const Eigen::Vector3d& w, double press, double steep, double h) noexcept;
// How far its bristle is turned after a step in which it gave that moment.
Eigen::Vector3d turned_after(const ContactParams& params, const Eigen::Vector3d& turned, const Eigen::Vector3d& moment,
                             double h) noexcept;

// Of a tie: -k stretch - (c + h k) v; of it only what acts along, if that is not null.
void tie_force(const ContactParams& params, const Eigen::Vector3d* along,
               const Eigen::Vector3d& stretch, const Eigen::Vector3d& v, double h,
               bool with_tangent, ContactForce& out) noexcept;

}  // namespace twinbus::sim
