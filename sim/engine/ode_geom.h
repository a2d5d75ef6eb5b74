// What ODE collides: simple shapes, and bounds of what it has.

#pragma once

#include <ode/ode.h>

#include "sim/world/solid.h"

namespace twinbus::inline sim {

inline dGeomID geom_of(const Solid& solid) {
  const Eigen::Vector3d& s = solid.size;
  switch (solid.shape) {
    case SolidShape::kBox:
      return dCreateBox(nullptr, s.x(), s.y(), s.z());
    case SolidShape::kCylinder:
      return dCreateCylinder(nullptr, s.x(), s.y());
    case SolidShape::kCapsule:
      return dCreateCapsule(nullptr, s.x(), s.y());
    case SolidShape::kSphere:
      break;
  }
  return dCreateSphere(nullptr, s.x());
}

inline bool bounds_meet(const dReal* a, const dReal* b) {
  return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] &&
         b[4] <= a[5];
}

}  // namespace twinbus::sim
