// A robot's links in their own axes, where what they weigh never changes: for sim/articulated/inverse_lanes.h.
//
// Mass on a hinge's axis moves as if it were the parent's.  So a hinge about x, y or z hands on all
// that can be moved to its axis without changing how the link resists turning (Khalil and Dombre
// 2002, section 9.4): the link's own mass, its moment and its spread along the axis are 0.

#pragma once

#include <cstddef>
#include <vector>

#include "sim/articulated/articulated_lanes.h"

namespace twinbus::inline sim {

// The same in all lanes.
struct RigidLink {
  double mass;
  Three<double> moment;        // mass times com
  Symmetric3<double> inertia;  // about its origin
  Symmetric3<double> spread;   // sum of mass times r r', r from its origin
  Three<double> offset;        // of its origin at 0, in the parent's axes
  double rotor;
  int axis;    // of its hinge: 0 to 2 x, y or z, the axes parallel to the parent's at 0; 3: any
  bool apart;  // its origin is not its parent's
  std::size_t parent;  // before it
  bool leaf, first;    // nothing hangs on it; the first of its parent's children, from the last on
  // Of a joint of axis 3.
  Columns3<double> placed;  // axes of the link at 0, in its parent's
  Three<double> direction;  // in its own
  bool slides;
};

// How a link moves and what that needs.
template <class L>
struct LinkMotion {
  Three<L> w, turning;  // angular velocity and its change
  Three<L> felt;        // acceleration of the origin, minus gravity
  Six<L> needed;        // torque about the origin, and force
  L missing;            // of the joint's torque
  Six<L> change;        // of the acceleration
  // Of the articulated inertia.
  Six<L> inertia_axis;
  L inverse_d;
};

template <class L>
struct RigidBody {
  std::vector<RigidLink> rigid;
  std::vector<Aligned<LinkMotion<L>>> links;
  std::vector<Aligned<Inertia<L>>> folded;  // what hangs on a link weighs
  RootFactors<L> root;
  Three<L> held;  // acceleration that a fixed link 0 feels
  // Of the joints, by link.
  std::vector<double> angle, rate, sine, cosine, force;
  std::vector<double> known_angle, known_sine, known_cosine;  // as weighed
};

}  // namespace twinbus::sim
