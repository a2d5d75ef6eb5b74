// Reference of the divergent component of motion (DCM) for a zero-moment point (ZMP) that is known ahead, closed form.
//
// xi' = omega (xi - p).  While p moves at a constant rate r from p0 to p1 in T, backwards from its end:
//
//     xi(0) = p0 + r/omega + e^(-omega T) (xi(T) - p1 - r/omega)
//
// so the reference now follows from where the robot is to be caught in the end, one exponential per piece, and any
// foothold or duration may change at any tick.

#pragma once

#include <Eigen/Core>
#include <cmath>

namespace twinbus::inline control {

struct ZmpPiece {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();  // p0, p1 [m]
  double duration = 0.0;                                                         // T > 0 [s]
};

// xi(0) of a piece that ends with xi(T) = after.
inline Eigen::Vector2d dcm_before(const ZmpPiece& piece, const Eigen::Vector2d& after,
                                  double omega) noexcept {
  const Eigen::Vector2d lead = (piece.to - piece.from) / (piece.duration * omega);
  return piece.from + lead + std::exp(-omega * piece.duration) * (after - piece.to - lead);
}

}  // namespace twinbus::control
