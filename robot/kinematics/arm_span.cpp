#include "robot/kinematics/arm_span.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace twinbus::inline robot {

namespace {
constexpr double kRolls = 0.3;  // cosine: nearer to upright on what points away, the last joint's axis bends the wrist
}

ArmSpan arm_span(const Kinematics& k, const Hand& hand) noexcept {
  const auto slides = [&](int joint) { return k.model().joints[static_cast<std::size_t>(joint)].kind == JointKind::kPrismatic; };
  auto shoulder = std::find_if_not(hand.joints.begin(), hand.joints.end(), slides);
  if (shoulder == hand.joints.end()) shoulder = hand.joints.begin();
  ArmSpan arm{k.link_in_world(*shoulder + 1).translation()};
  Eigen::Vector3d last = k.link_in_world(hand.link) * hand.frame.translation();
  for (auto joint = hand.joints.end(); joint != shoulder;) {
    const Eigen::Vector3d here = k.link_in_world(*--joint + 1).translation();
    arm.length += (last - here).norm();
    last = here;
  }
  return arm;
}

Eigen::Matrix3d pointing(const Kinematics& k, const Hand& hand) noexcept {
  const std::size_t before = hand.joints.size() > 1 ? hand.joints.size() - 2 : 0;
  const Eigen::Isometry3d here = k.link_in_world(hand.link) * hand.frame;
  const Eigen::Vector3d away = here.translation() - k.link_in_world(hand.joints[before] + 1).translation();
  const double along = away.dot(k.axis_in_world(hand.joints.back()));
  Eigen::Vector3d axis = std::copysign(1.0, along) * k.axis_in_world(hand.joints.back());
  if (std::abs(along) < kRolls * away.norm()) {  // the last joint bends the wrist
    const Eigen::Vector3d last = here.translation() - k.link_in_world(hand.joints.back() + 1).translation();
    axis = last.norm() > 0.0 ? last : away;
  }
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), here.linear().transpose() * axis).toRotationMatrix();
}

bool turns_in_place(const Kinematics& k, const Hand& hand) noexcept {
  constexpr double kUpright = 0.999;  // cosine
  return std::abs(k.axis_in_world(hand.joints.front()).z()) > kUpright;
}

}  // namespace twinbus::robot
