// Brings the joints of a guard's mask to rest, as the guard foretells it (robot/kinematics/brake.h).
//
// A set-point that its joint follows is braked as it is.  One that is far away, or pulls softly, says little about where its
// joint goes: there the brake begins at the measured joint, without feed-forward.  The gains are those of a hold at least.

#pragma once

#include <cstdint>

#include "bridge/gate/gate_limits.h"
#include "bridge/gate/soft_servos.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

class MaskedBrake {
 public:
  // The mask of a tick, bit per joint.  effective: what was written last; of joints that begin to be braked it becomes what the
  // brake begins with.
  struct Released {  // bit per joint
    std::int64_t faded = 0;    // back to the client
    std::int64_t at_once = 0;  // to a soft servo, which throws nothing; a stiff one that grows soft carries the joint along
  };
  Released hold(std::int64_t mask, const GateLimits& limits, const JointCommand& client, const MeasuredJoints& measured,
                JointCommand& effective) noexcept;
  // Writes the joints of the mask, one tick on from `effective`.
  void apply(const GateLimits& limits, const JointCommand& effective, JointCommand& command) const noexcept;

  std::int64_t joints() const noexcept { return joints_; }  // held now, bit per joint

 private:
  std::int64_t joints_ = 0;
};

}  // namespace twinbus::bridge
