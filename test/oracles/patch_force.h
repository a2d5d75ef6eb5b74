// The force between two bodies from the manifold of their contact: section 3.3.2 of the paper,
// step by step.
//
//     1. depth by least squares:  d(p) = d0 + t.(p - middle)  through points under one constraint
//     2. spring                   k d
//     3. velocity                 d' = -n.(v + w x p), of the constraint at each point
//     4. damper                   a k d d'            (Hunt and Crossley 1975)
//     5. their sum                k d (1 + a d'), never pulling
//
// v and w: of A against B.  The fit leaves the sum of the depths and their moment as they are: it
// takes out what the points say beyond a depth and a tilt.  An impact at v loses so much that
// a (v + v_out) = ln((1 + a v) / (1 - a v_out)), whatever k is.

#pragma once

#include <array>

#include "geometry/mesh_contact/manifold.h"

namespace twinbus {

struct PatchLaw {
  double stiffness = 0.0;    // k, of one point [N/m]
  double dissipation = 0.0;  // a [s/m]
};

struct PatchForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // on A [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // about the frame's origin [N m]
  std::array<double, Manifold::kMost> depth{};       // of each point, as fitted [m]
  std::array<double, Manifold::kMost> normal{};      // force at each point [N]
};

// All in the manifold's frame; velocity is that of A's point at the origin of the frame against B.
PatchForce patch_force(const PatchLaw& law, const Manifold& manifold,
                       const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) noexcept;

}  // namespace twinbus
