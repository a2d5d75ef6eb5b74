// The beginning of a way on which a hand takes up what it holds: what stands on an obstacle touches it, and nothing is planned
// from there.  The hand goes straight away from what is touched, turned as it is; the rest is planned from where nothing touches.

#pragma once

#include "planner/timing/path_timing.h"
#include "robot/collision/collision.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

class EdgeCheck;

class Lift {
 public:
  // collision, space: as of the plan; they must outlive this.
  Lift(const Model& model, Collision& collision, EdgeCheck& space);

  // Does at the start nothing touch but what that hand holds and what stands in the world, and can it be taken off?  way: from the
  // start to where it is.
  bool find(const Hand& hand, const JointPoint& start, JointPath& way);

  // That way as a motion; none unless, looked at closely, what touched at the start comes no nearer on it and nothing else is near.
  TimedPath timed(const JointPath& way, const TimingLimits& limits, double knot_spacing);

 private:
  bool rests(const PairDistance& pair) const;  // a held thing on a standing one

  const Model& model_;
  Collision& collision_;
  EdgeCheck& space_;
  int holder_ = -1;      // the link of the hand
  double nearest_ = 0.0;  // of what rests, at the start [m]
};

}  // namespace twinbus::planner
