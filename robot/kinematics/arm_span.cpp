#include "robot/kinematics/arm_span.h"

#include <cmath>

namespace twinbus {

ArmSpan arm_span(const Kinematics& k, const Hand& hand) noexcept {
  ArmSpan arm{k.link_in_world(hand.joints.front() + 1).translation()};
  Eigen::Vector3d last = k.link_in_world(hand.link) * hand.frame.translation();
  for (auto joint = hand.joints.rbegin(); joint != hand.joints.rend(); ++joint) {
    const Eigen::Vector3d here = k.link_in_world(*joint + 1).translation();
    arm.length += (last - here).norm();
    last = here;
  }
  return arm;
}

bool turns_in_place(const Kinematics& k, const Hand& hand) noexcept {
  constexpr double kUpright = 0.999;  // cosine
  return std::abs(k.axis_in_world(hand.joints.front()).z()) > kUpright;
}

}  // namespace twinbus
