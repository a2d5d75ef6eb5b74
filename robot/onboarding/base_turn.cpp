#include "robot/onboarding/base_turn.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/kinematics/arm_span.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

namespace {

constexpr std::size_t kJointsOfLegs = 10;  // of both
constexpr double kBelow = 0.03;      // its base that the flange of a trunk may reach [m]
constexpr double kInGround = 0.001;   // that an arm may begin in the ground [m]
constexpr double kArmsAbove = 0.05;  // the ground, of a robot on a stand [m]

}  // namespace

int side_of_name(const std::string& name) {
  std::string lower = "_" + name + "_";
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  // Whole words first: the R of LLEG_ANKLE_R is for roll.
  for (const auto& [left, right] :
       std::initializer_list<std::pair<const char*, const char*>>{{"left", "right"},
                                                                  {"_lleg", "_rleg"},
                                                                  {"_lfoot", "_rfoot"},
                                                                  {"_lankle", "_rankle"},
                                                                  {"_l_", "_r_"}}) {
    const std::size_t l = lower.find(left);
    const std::size_t r = lower.find(right);
    if (l != r) return l < r ? 1 : -1;
  }
  return 0;
}

Eigen::Matrix3d find_base_turn(const Model& model) {
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  const auto legs_named = [&](const Eigen::Matrix3d& turn) {  // 1: as they lie, -1: crosswise
    const Anatomy found = find_anatomy(model, {}, turn);
    if (found.soles[0].link < 0 || found.leg_joints.size() < kJointsOfLegs) return -2;
    const int left = side_of_name(model.links[at(found.soles[0].link)].name);
    const int right = side_of_name(model.links[at(found.soles[1].link)].name);
    return left == -right ? left : 0;
  };
  const int as_it_is = legs_named(none);
  if (as_it_is >= 0 || model.joint_count() < static_cast<int>(kJointsOfLegs)) return none;
  const Eigen::Matrix3d y_up = rotation_about(Eigen::Vector3d::UnitX(), 0.5 * std::numbers::pi);
  for (const Eigen::Matrix3d& up : {none, y_up}) {
    for (const double heading :
         {0.0, std::numbers::pi, 0.5 * std::numbers::pi, -0.5 * std::numbers::pi}) {
      const Eigen::Matrix3d turn = rotation_z(heading) * up;
      if (legs_named(turn) == 1) return turn;
    }
  }
  return none;
}

double height_of_stand(const Model& model) {
  const Anatomy found = find_anatomy(model);
  Configuration c(model);
  c.q = neutral_posture(model);
  if (found.hands[0].link < 0) lift_arms(model, found, c.q);
  Kinematics k(model);
  k.update(c);
  double trunk = 0.0, arms = 0.0;
  for (int link = 0; link < model.link_count(); ++link) {
    const bool of_arm = std::any_of(found.hands.begin(), found.hands.end(), [&](const Hand& hand) {
      if (hand.joints.empty() || !hangs_on(model, link, hand.joints.front() + 1)) return false;
      return link != hand.joints.front() + 1 || !turns_in_place(k, hand);
    });
    double& low = of_arm ? arms : trunk;
    for (const Eigen::Vector3d& point : link_points(model.links[at(link)]))
      low = std::min(low, (k.link_in_world(link) * point).z());
  }
  double fingers = 0.0;  // so high that none of a hand without an arm reaches the ground
  for (const Hand& finger : found.more_hands) {
    const int root = finger.joints.front() + 1;
    const Eigen::Vector3d joint = k.link_in_world(root).translation();
    for (int link = root; link < model.link_count(); ++link) {
      if (!hangs_on(model, link, root)) continue;
      for (const Eigen::Vector3d& point : link_points(model.links[at(link)]))
        fingers = std::max(fingers, kArmsAbove + (k.link_in_world(link) * point - joint).norm() - joint.z());
    }
  }
  const double needed = std::max(fingers, std::max(trunk < -kBelow ? -trunk : 0.0, arms < -kInGround ? kArmsAbove - arms : 0.0));
  return 1e-3 * std::ceil(1e3 * needed);
}

std::string free_root_name(const std::string& urdf_text, const std::string& file, const std::string& wanted) {
  const XmlElement robot = parse_xml(urdf_text, file);
  const auto taken = [&](const std::string& name) {
    return std::any_of(robot.children.begin(), robot.children.end(), [&](const XmlElement& part) {
      const std::string* its = part.attribute("name");
      return its != nullptr && (*its == name || *its == name + "_joint");
    });
  };
  std::string name = wanted;
  for (int i = 2; taken(name); ++i) name = wanted + "_" + std::to_string(i);
  return name;
}

std::string with_root_above(const std::string& urdf_text, const std::string& root_link, const std::string& new_root,
                            const Eigen::Isometry3d& pose, const std::string& why) {
  const std::size_t end = urdf_text.rfind("</robot>");
  if (end == std::string::npos) return urdf_text;
  const Eigen::Vector3d xyz = pose.translation(), rpy = rpy_from_rotation(pose.linear());
  const std::string origin = formatted("xyz=\"%.9g %.9g %.9g\" rpy=\"%.9f %.9f %.9f\"", xyz.x(), xyz.y(), xyz.z(), rpy.x(),
                                       rpy.y(), rpy.z());
  std::string text = urdf_text.substr(0, end);
  text += "  <!-- Added by `twinbus check`: " + why + ". -->\n";
  text += "  <link name=\"" + new_root + "\"/>\n";
  text += "  <joint name=\"" + new_root + "_joint\" type=\"fixed\">\n";
  text += std::string("    <origin ") + origin + "/>\n";
  text += "    <parent link=\"" + new_root + "\"/>\n    <child link=\"" + root_link + "\"/>\n";
  text += "  </joint>\n";
  return text + urdf_text.substr(end);
}

std::string without_floating_root(const std::string& urdf_text, const std::string& file, std::string& left_out) {
  XmlElement robot = parse_xml(urdf_text, file);
  const auto is_joint = [](const XmlElement& part) { return part.name == "joint" && part.attribute("name") != nullptr; };
  const auto floats = [&](const XmlElement& part) {
    const std::string* type = is_joint(part) ? part.attribute("type") : nullptr;
    return type != nullptr && *type == "floating";
  };
  const auto joint = std::find_if(robot.children.begin(), robot.children.end(), floats);
  if (joint == robot.children.end()) return urdf_text;
  const std::string name = *joint->attribute("name"), root = attribute_of(*joint, "parent", "link");
  const bool alone = std::none_of(robot.children.begin(), robot.children.end(), [&](const XmlElement& part) {
    if (is_joint(part)) return attribute_of(part, "child", "link") == root || (&part != &*joint && attribute_of(part, "parent", "link") == root);
    const std::string* its = part.name == "link" ? part.attribute("name") : nullptr;
    return its != nullptr && *its == root && (part.child("inertial") != nullptr || part.child("collision") != nullptr);
  });
  if (root.empty() || !alone) return urdf_text;
  std::erase_if(robot.children, [&](const XmlElement& part) {
    const std::string* its = part.attribute("name");
    return its != nullptr && ((part.name == "joint" && *its == name) || (part.name == "link" && *its == root));
  });
  left_out = "joint " + name + " and link " + root;
  std::string text = "<?xml version=\"1.0\"?>\n<!-- Without its floating joint, by `twinbus check`. -->\n";
  append_xml(robot, text);
  return text;
}

}  // namespace twinbus::robot
