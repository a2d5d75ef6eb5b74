// Four worlds of robots alike side by side: each number of a robot is a vector, and each world a lane of it.  Where links, joints and the
// corners of soles are and what they remember, for the steps of sim/lanes/lane_step.h.

#pragma once

#include <array>
#include <vector>

#include "sim/articulated/articulated_lanes.h"

namespace twinbus::inline sim {

inline constexpr int kWorldLanes = 4;

// A joint's law (sim/articulated/joint_law.h).
struct alignas(64) JointLanes {
  Vec4 lower, upper, limit, damping, friction, backlash, stick, stick_gain;
  Vec4 q, qd, tau, kp, kd;                  // what the servo is to do
  Vec4 play, torque;                        // remembered
  Vec4 force, gain, low_bound, high_bound;  // of this step
  Vec4 servo, slides, stop;                 // the pieces that are assumed: -1, 0, 1
};

// A corner of a sole over level ground, z is its normal.
struct alignas(64) CornerLanes {
  std::size_t rank = 0;  // of its link
  int link = 0, sole = 0, corner = 0;
  Three<Vec4> local;  // in the link's axes
  Vec4 k, c, kt, ct, mu, ramp;
  Vec4 height;              // of the ground below it
  Vec4 anchor_x, anchor_y;  // of its bristle
  Vec4 known;               // 1: there is one
  // Of this step.
  Three<Vec4> r, v0, v, f0, force;
  Vec4 depth, stretch_x, stretch_y, xx, xy, yy, zz, open, slip;  // xx to zz: of the tangent that is folded in
};

// A shape that is no sole: where it comes near the ground its world leaves the lanes.
struct alignas(64) ShellLanes {
  std::size_t rank = 0;  // of its link
  Three<Vec4> center;
  Vec4 radius, extent;
  struct Probe {
    Three<Vec4> center;
    Vec4 radius;
  };
  std::vector<Probe> probes;
};

struct LaneBlock {
  BodyLanes<Vec4> body;  // one link a rank
  alignas(64) RootFactors<Vec4> root;
  Columns3<Vec4> rotation;             // of link 0, in world
  Three<Vec4> origin, velocity, spin;  // of its origin, in world
  Three<Vec4> before;                  // its origin before the last step
  std::vector<JointLanes> joints;  // by the rank of what they move, less one
  std::vector<CornerLanes> corners;
  std::vector<ShellLanes> shells;
  std::array<Vec4, 2> deep;  // of the soles, after the last step
  Vec4 fresh;                // 1: since the last step somebody has placed it
  Vec4 reach;                // no shape is further from link 0's origin
  std::vector<Vec4> extents;  // by rank: no shape of one is further from its origin; none where nothing is loose
  Three<Vec4> low, high;      // bound_lanes(): no robot leaves that box in a step
  double h = 0.0;            // the step [s]
  Vec4 doubt_depth;          // of the last step: a sole was first seen deeper than its speed explains, so deep; 0: it was not
};

// Of all worlds as they are.
void place_lanes(LaneBlock& block) noexcept;

// Where the robots may be in the next step.
void bound_lanes(LaneBlock& block) noexcept;

// A step of the worlds whose bits are set, placed before.  Returns those that took it; of the others nothing has changed but what
// place_lanes() restores.
int step_lanes(LaneBlock& block, int asked) noexcept;

}  // namespace twinbus::sim
