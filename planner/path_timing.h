// When an arm is where on its path: as fast as the limits of velocity and acceleration allow, from
// rest to rest.
//
// With x = (ds/dt)^2 and u = d2s/dt2 the joints move with qd = q' sqrt(x) and qdd = q' u + q'' x.
// A pass forwards and a pass backwards find the largest x that keeps both limits; a moving average
// over time rounds the steps of u, so the torque has none; then the whole is stretched or shrunk in
// time so that the interpolated motion just meets the limits.

#pragma once

#include <vector>

#include "planner/rounded_path.h"

namespace twinbus {

struct TimingLimits {
  JointPoint velocity;      // [rad/s]
  JointPoint acceleration;  // [rad/s^2]
  double smoothing = 0.1;   // longest moving average [s]
};

// Between two knots each joint is a cubic (Hermite) with the knots' positions and velocities.
struct Knot {
  double time = 0.0;  // [s] from the start
  JointPoint q;       // [rad]
  JointPoint qd;      // [rad/s]
};
using TimedPath = std::vector<Knot>;

// knot_spacing: about how far knots are apart [s]; most_knots: never more.
TimedPath time_path(const std::vector<RoundedPath>& parts, const TimingLimits& limits,
                    double knot_spacing, int most_knots);

// Position, velocity and acceleration at a time, clamped to the path.
void sample(const TimedPath& path, double time, JointPoint& q, JointPoint& qd, JointPoint& qdd);

// The largest of |qd| / limit and of |qdd| / limit on the whole path.
struct LimitUse {
  double velocity = 0.0;
  double acceleration = 0.0;
};
LimitUse limit_use(const TimedPath& path, const TimingLimits& limits);

}  // namespace twinbus
