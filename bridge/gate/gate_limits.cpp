#include "bridge/gate/gate_limits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/math/index.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline bridge {

namespace {

std::int64_t bits_of(const Model& model, const std::vector<int>& joints) {
  std::int64_t mask = 0;
  for (int k = 0; k < model.bus_count(); ++k) {
    if (std::find(joints.begin(), joints.end(), model.bus_joints[at(k)]) != joints.end())
      mask |= bit(k);
  }
  return mask;
}

}  // namespace

GateLimits::GateLimits(const Model& model) : robot(&model), pairs(model) {
  joint_count = model.bus_count();
  model_hash = model.hash;
  legs = bits_of(model, model.leg_joints);
  for (const Hand* hand : hands_of(model)) arms |= bits_of(model, hand->joints) | bits_of(model, hand->carriers);
  all = joint_count >= 63 ? ~std::int64_t{0} : bit(joint_count) - 1;
  period = model.period();
  period_ns = model.period_ns;
  command_timeout_ns = std::llround(1e9 * model.command_timeout);
  guard_timeout_ns = std::llround(1e9 * model.guard_timeout);
  blend_s = model.blend_s;
  damp_when_off = model.off_action == OffAction::kDamp;
  for (int k = 0; k < joint_count; ++k) {
    const Joint& joint = model.joints[at(model.bus_joints[at(k)])];
    const std::size_t i = at(k);
    lower[i] = joint.lower;
    upper[i] = joint.upper;
    velocity[i] = joint.velocity;
    effort[i] = joint.effort;
    step[i] = set_point_rate(joint) * period;
    brake[i] = brake_deceleration(joint);
    kp[i] = static_cast<float>(joint.kp);
    kd[i] = static_cast<float>(joint.kd);
    kp_max[i] = static_cast<float>(most_kp(joint));
    kd_max[i] = static_cast<float>(most_kd(joint));
    stop_kp[i] = static_cast<float>(hold_kp(joint));
    stop_kd[i] = static_cast<float>(hold_kd(joint));
  }
}

}  // namespace twinbus::bridge
