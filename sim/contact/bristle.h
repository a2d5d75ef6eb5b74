// The bristle of friction of a contact from one step to the next, and how far ahead contacts are
// looked for.

#pragma once

#include <algorithm>

#include "sim/contact/contact_solve.h"

namespace twinbus::inline sim {

// A point may come so much nearer in a step beyond what its speed says.
inline constexpr double kMostAcceleration = 40.0;  // [m/s^2]
inline constexpr double kMargin = 1e-4;            // [m]

// What is within this of a surface may touch it in the next h [s]; h zero: what touches.
inline double reach_of(double speed, double h) noexcept {
  return h > 0.0 ? h * (2.0 * speed + kMostAcceleration * h) + kMargin : 0.0;
}

// The stretch of a new contact: the bristle is planted where the point will come down.
inline Eigen::Vector3d planted(const Contact& c, double h) noexcept {
  const double vn = c.normal.dot(c.v0);
  if (!(c.depth < 0.0 && vn < 0.0)) return Eigen::Vector3d::Zero();
  return -std::min(h, c.depth / vn) * (c.v0 - vn * c.normal);
}

struct Bristle {
  Eigen::Vector3d anchor;   // where a point of B must be for no stretch, as if B stood still
  Eigen::Vector3d stretch;  // of a point that rolls
};

// At the end of a step h, of a contact that is not open.
inline Bristle bristle_after(const Contact& c, double h) noexcept {
  const Eigen::Vector3d moved = h * (c.v - c.normal * c.normal.dot(c.v));
  // A sticking anchor stays where it is to the last bit: no creep.
  if (c.now.mode == ContactMode::kStick) return {c.point - c.stretch, c.stretch + moved};
  // The bristle ends the step with the stretch that carries the friction.
  const Eigen::Vector3d ft = c.now.force - c.normal.dot(c.now.force) * c.normal;
  const double beta = c.params.tangent_damping + h * c.params.tangent_stiffness;
  const Eigen::Vector3d stretch =
      c.stretch - h / beta * (ft + c.params.tangent_stiffness * c.stretch);
  return {c.point + moved - stretch, stretch};
}

// What its springs hold after a step h [J].
inline double stored_energy(const Contact& c, double h) noexcept {
  if (c.tie != TieKind::kNone) return 0.5 * c.params.stiffness * (c.stretch + h * c.v).squaredNorm();
  const double end = c.depth - h * c.normal.dot(c.v);
  if (c.now.mode == ContactMode::kOpen || !(end > 0.0)) return 0.0;
  if (c.soft) return 0.5 * c.normal.dot(c.now.force) * c.depth;
  return c.stored + 0.5 * (c.params.stiffness * end * end +
                           c.params.tangent_stiffness * bristle_after(c, h).stretch.squaredNorm()) +
         (turns(c) ? 0.5 * turning_stiffness(c.params) * turned_after(c.params, c.turned, c.moment, h).squaredNorm() : 0.0);
}

}  // namespace twinbus::sim
