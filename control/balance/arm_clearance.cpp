#include "control/balance/arm_clearance.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline control {

// Of a hand's own joints, the one nearest to the trunk that turns about x.
ArmClearance::ArmClearance(const Model& model, const ArmClearanceGains& gains) : gains_(gains) {
  for (std::size_t a = 0; a < 2; ++a) {
    for (const int j : model.hands[a].joints) {
      const Joint& joint = model.joints[at(j)];
      const double along = joint.axis.x();
      if (joint.kind == JointKind::kPrismatic || joint.mimic >= 0 || !(std::abs(along) > 0.99))
        continue;
      arm_[a].joint = j;
      arm_[a].sign = (a == 0 ? 1.0 : -1.0) * (along > 0.0 ? 1.0 : -1.0);
      break;
    }
  }
}

void ArmClearance::start() noexcept {
  for (Arm& arm : arm_) arm.angle = arm.rate = arm.acceleration = 0.0;
}

void ArmClearance::update(double lean, double dt) noexcept {
  const ArmClearanceGains& g = gains_;
  for (std::size_t a = 0; a < 2; ++a) {
    Arm& arm = arm_[a];
    if (arm.joint < 0) continue;
    const double to_side = a == 0 ? lean : -lean;
    const double out = std::clamp(g.share * (to_side - g.free), 0.0, g.limit);
    arm.acceleration = g.rate * g.rate * (out - arm.angle) - 2.0 * g.rate * arm.rate;
    arm.rate += dt * arm.acceleration;
    arm.angle += dt * arm.rate;
  }
}

}  // namespace twinbus::control
