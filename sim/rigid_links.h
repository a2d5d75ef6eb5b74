// Links in their own axes, where what they weigh never changes: for sim/inverse_lanes.h.

#pragma once

#include "sim/articulated_lanes.h"

namespace twinbus {

// The same in all lanes.
struct RigidLink {
  double mass;
  Three<double> moment;        // mass times com
  Symmetric3<double> inertia;  // about its origin
  Three<double> offset;        // of its origin, in the parent's axes
  int axis;  // of its hinge: 0 to 2 x, y or z, the axes parallel to the parent's at 0; 3: any
};

// How a link moves and what that needs.
template <class L>
struct LinkMotion {
  Three<L> w, turning;  // angular velocity and its change
  Three<L> felt;        // acceleration of the origin, minus gravity
  Columns3<L> around;   // K: of a point r of the link, K r is its acceleration beside felt
  Three<L> force, torque;
  // Root axes.
  Six<L> bias;
  L missing;  // torque
};

}  // namespace twinbus
