#include "control/balance/straight_way.h"

#include <algorithm>

#include "common/math/index.h"

namespace twinbus::inline control {

void place_on_way(const Model& model, const PerJoint<double>& from, const PerJoint<double>& to, std::int64_t mask, double share,
                  Configuration& place) noexcept {
  RobotState there;
  for (int k = 0; k < model.bus_count(); ++k) {
    const Joint& joint = model.joints[at(model.bus_joints[at(k)])];
    double& q = there.q[at(k)] = from[at(k)];
    if (((mask >> k) & 1) != 0) q += share * (to[at(k)] - q);
    if (joint.kind != JointKind::kContinuous) q = std::clamp(q, joint.lower, joint.upper);
  }
  set_joints(model, there, place);
}

}  // namespace twinbus::control
