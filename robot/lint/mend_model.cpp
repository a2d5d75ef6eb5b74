// What is wrong in a URDF and shows only in the robot that it makes: sides, ranges of legs, inertias far from the geometry.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "common/text/xml.h"
#include "robot/description/link_points.h"
#include "robot/lint/mend.h"
#include "robot/lint/mirrored_ranges.h"
#include "robot/lint/urdf_edit.h"
#include "robot/onboarding/anatomy.h"
#include "robot/onboarding/base_turn.h"

namespace twinbus::inline robot {

namespace {

constexpr double kForward = 1.15;       // toes before the ankle against the heel behind it
constexpr double kFarShell = 3.0;       // of what its geometry allows: nine times the largest moment

void rename(XmlElement& element, const std::map<std::string, std::string>& names) {
  for (auto& [key, value] : element.attributes) {
    if (const auto found = names.find(value); found != names.end()) value = found->second;
  }
  if (const auto found = names.find(element.text); found != names.end()) element.text = found->second;
  for (XmlElement& child : element.children) rename(child, names);
}

// The link and those that are fixed to it.
std::vector<std::string> fixed_to(const XmlElement& robot, const std::string& link) {
  std::vector<std::string> parts{link};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const XmlElement& joint : robot.children) {
      const std::string* type = joint.name == "joint" ? joint.attribute("type") : nullptr;
      if (type != nullptr && *type == "fixed" && attribute_of(joint, "parent", "link") == parts[i])
        parts.push_back(attribute_of(joint, "child", "link"));
    }
  }
  return parts;
}

}  // namespace

double shell_radius(double moment, double mass) noexcept { return mass > 0.0 ? std::sqrt(1.5 * moment / mass) : 0.0; }

double shell_radius(const Link& link) {
  return shell_radius(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia).eigenvalues()[2], link.mass);
}

std::vector<std::string> names_on_other_side(const std::string& name) {
  std::vector<std::string> found;
  static constexpr std::pair<const char*, const char*> kWords[] = {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}};
  const auto with = [&](std::size_t at, std::size_t length, const std::string& word) {
    std::string other = name;
    found.push_back(other.replace(at, length, word));
  };
  for (const auto& [left, right] : kWords) {
    const std::string l = left, r = right;
    if (const std::size_t at = name.find(l); at != std::string::npos) {
      with(at, l.size(), r);
      return found;
    }
    if (const std::size_t at = name.find(r); at != std::string::npos) {
      with(at, r.size(), l);
      return found;
    }
  }
  // A single letter: l_knee, arm_l, LKnee, LLEG_KNEE.
  static constexpr std::pair<char, char> kLetters[] = {{'l', 'r'}, {'r', 'l'}, {'L', 'R'}, {'R', 'L'}};
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && name[i - 1] != '_') continue;
    for (const auto& [one, other] : kLetters) {
      if (name[i] == one) with(i, 1, std::string(1, other));
    }
  }
  return found;
}

std::string mend_sides(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes) {
  const Anatomy found = find_anatomy(model, {});
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = found.soles[side];
    if (sole.link < 0 || side_of_name(model.links[static_cast<std::size_t>(sole.link)].name) != (side == 0 ? -1 : 1)) return text;
    const double ahead = sole.frame.translation().x() + sole.front, behind = sole.back - sole.frame.translation().x();
    if (!(ahead > kForward * behind)) return text;  // it may as well look back
  }
  XmlElement robot = parse_xml(text, file);
  std::map<std::string, std::string> names;
  std::vector<std::string> all;
  for (const XmlElement& element : robot.children) {
    if (element.name == "link" || element.name == "joint") all.push_back(element_name(element));
  }
  for (const std::string& name : all) {
    for (const std::string& other : names_on_other_side(name)) {
      if (std::find(all.begin(), all.end(), other) != all.end()) names[name] = other;
    }
  }
  // Only pairs: two names may not become one.
  std::erase_if(names, [&](const auto& pair) {
    const auto back = names.find(pair.second);
    return back == names.end() || back->second != pair.first;
  });
  if (names.empty()) return text;
  rename(robot, names);
  changes.push_back("robot: what is called left is on the right, and the feet point forward: left and right are exchanged in " +
                    std::to_string(names.size()) + " names of links and joints");
  return mended_text(robot);
}

std::string mend_images(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  for (const UnmirroredRange& fault : unmirrored_ranges(model, find_anatomy(model, {}).leg_joints)) {
    const Joint& other = model.joints[static_cast<std::size_t>(fault.other)];
    for (XmlElement& joint : robot.children) {
      XmlElement* limit = joint.name == "joint" && element_name(joint) == other.name ? child_to_change(joint, "limit") : nullptr;
      if (!fault.of_leg || limit == nullptr) continue;
      write_attribute(*limit, "lower", short_number(fault.lower));
      write_attribute(*limit, "upper", short_number(fault.upper));
      changes.push_back("joint " + other.name + ": its range of " + short_number(other.lower) + " to " + short_number(other.upper) +
                        " is not the mirror image of that of " + model.joints[static_cast<std::size_t>(fault.kept)].name +
                        ", which legs need more: " + short_number(fault.lower) + " to " + short_number(fault.upper));
    }
  }
  return changes.size() == before ? text : mended_text(robot);
}

std::string mend_far_inertias(const std::string& text, const std::string& file, const Model& model,
                              std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  for (const Link& link : model.links) {
    double reach = 0.0;
    for (const Eigen::Vector3d& point : link_points(link)) reach = std::max(reach, (point - link.com).norm());
    const double shell = shell_radius(link);
    if (!(reach > 0.0) || !(shell > kFarShell * reach)) continue;
    const std::vector<std::string> parts = fixed_to(robot, link.name);
    for (XmlElement& element : robot.children) {
      if (element.name != "link" || std::find(parts.begin(), parts.end(), element_name(element)) == parts.end()) continue;
      XmlElement* inertial = child_to_change(element, "inertial");
      XmlElement* inertia = inertial == nullptr ? nullptr : child_to_change(*inertial, "inertia");
      const XmlElement* mass = inertial == nullptr ? nullptr : inertial->child("mass");
      double most = 0.0, moment = 0.0, weighs = 0.0;
      for (const char* key : {"ixx", "iyy", "izz"}) {
        if (inertia != nullptr && read_number(*inertia, key, moment)) most = std::max(most, moment);
      }
      if (mass == nullptr || !read_number(*mass, "value", weighs) || !(shell_radius(most, weighs) > kFarShell * reach)) continue;
      for (const char* key : kInertiaKeys) write_attribute(*inertia, key, "0");
      changes.push_back("link " + element_name(element) + ": its inertia is that of a shell of radius " +
                        short_number(shell_radius(most, weighs)) + " m, and its geometry ends at " + short_number(reach) +
                        " m: that of a box around its geometry is taken, or, where it is fixed to another, of a point of its mass");
    }
  }
  return changes.size() == before ? text : mended_text(robot);
}

}  // namespace twinbus::robot
