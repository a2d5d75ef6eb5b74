#include "robot/kinematics/arm_span.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

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

Eigen::Matrix3d pointing(const Kinematics& k, const Hand& hand) noexcept {
  const std::size_t before = hand.joints.size() > 1 ? hand.joints.size() - 2 : 0;
  const Eigen::Isometry3d here = k.link_in_world(hand.link) * hand.frame;
  const Eigen::Vector3d away = here.translation() - k.link_in_world(hand.joints[before] + 1).translation();
  Eigen::Vector3d axis = here.linear().transpose() * k.axis_in_world(hand.joints.back());
  if (away.dot(k.axis_in_world(hand.joints.back())) < 0.0) axis = -axis;
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

bool turns_in_place(const Kinematics& k, const Hand& hand) noexcept {
  constexpr double kUpright = 0.999;  // cosine
  return std::abs(k.axis_in_world(hand.joints.front()).z()) > kUpright;
}

}  // namespace twinbus
