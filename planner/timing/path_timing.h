// When an arm is where on its path: as fast as the limits of velocity, acceleration and jerk allow,
// from rest to rest.
//
// With x = (ds/dt)^2 and u = d2s/dt2 the joints move with qd = q' sqrt(x) and qdd = q' u + q'' x. A
// pass backwards finds the largest x from which the path can still be followed, a pass forwards
// takes the largest u (Pham and Pham 2018): the fastest motion without a limit of jerk. The motion
// itself is a cubic spline whose control points are that motion, averaged over time: every velocity
// and acceleration of it is an average of those, so it keeps what they keep; its jerk is a
// difference of accelerations over the length of the average, which need be no longer than the time
// to full push because the motion coasts that long between speeding up and slowing down; and it
// lasts longer by just that length.  Where more jerk is left, control points are drawn to their
// neighbours; what that does not mend is stretched.  Corners of the path are cut by what the arm
// moves meanwhile: whoever needs the path to be free must look at the result.

#pragma once

#include <array>
#include <vector>

#include "planner/timing/rounded_path.h"

namespace twinbus::inline planner {

struct TimingLimits {
  JointPoint velocity;      // [rad/s]
  JointPoint acceleration;  // [rad/s^2]
  JointPoint jerk;          // [rad/s^3]
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

// How long the fastest motion without a limit of jerk takes [s].
double fastest_time(const std::vector<RoundedPath>& parts, const TimingLimits& limits,
                    double stride = 0.02);

// The same way, `factor` times as long.
void slow_down(TimedPath& path, double factor);

// Position, velocity and acceleration at a time, clamped to the path.
void sample(const TimedPath& path, double time, JointPoint& q, JointPoint& qd, JointPoint& qdd);

// The Bezier points of the cubic between two knots.
std::array<JointPoint, 4> bezier_between(const Knot& a, const Knot& b);

// The largest of |qd| / limit, |qdd| / limit and |qddd| / limit on the whole path.
struct LimitUse {
  double velocity = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};
LimitUse limit_use(const TimedPath& path, const TimingLimits& limits);

}  // namespace twinbus::planner
