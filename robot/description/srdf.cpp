#include "robot/description/srdf.h"

#include <algorithm>
#include <cmath>

#include "common/text/xml.h"
#include "robot/names/known_names.h"

namespace twinbus::inline robot {

namespace {

const std::string& need(const XmlElement& element, const char* key, const std::string& file) {
  const std::string* value = element.attribute(key);
  if (value == nullptr || value->empty()) {
    fail_at(file, element.line, "<" + element.name + "> needs " + key + "=\"...\"");
  }
  return *value;
}

void read_pose(const XmlElement& element, const std::string& file, Srdf& srdf) {
  const std::string& name = need(element, "name", file);
  SrdfPose* pose = nullptr;
  for (SrdfPose& known : srdf.poses) {
    if (known.name == name) pose = &known;
  }
  if (pose == nullptr) {
    srdf.poses.push_back({.name = name, .line = element.line, .joints = {}});
    pose = &srdf.poses.back();
  }
  for (const XmlElement& joint : element.children) {
    if (joint.name != "joint") continue;
    double value = 0.0;
    double several[7];
    const std::string& text = need(joint, "value", file);
    // The free base itself, with its position and attitude: the scene says where the robot is.
    if (parse_numbers(text, several, 7) || parse_numbers(text, several, 6)) continue;
    if (!parse_numbers(text, &value, 1)) {
      fail_at(file, joint.line,
              "pose " + name + ": value of joint " + need(joint, "name", file) +
                  " is not one finite number");
    }
    pose->joints.emplace_back(need(joint, "name", file), value);
  }
}

void read_rotors(const XmlElement& element, const std::string& file, Srdf& srdf) {
  for (const XmlElement& joint : element.children) {
    if (joint.name != "joint") continue;
    double inertia = 0.0;
    double ratio = 1.0;
    if (!parse_numbers(need(joint, "mass", file), &inertia, 1) || !(inertia >= 0.0) ||
        !parse_numbers(need(joint, "gear_ratio", file), &ratio, 1)) {
      fail_at(file, joint.line,
              "rotor of joint " + need(joint, "name", file) +
                  ": mass (its inertia) and gear_ratio must be numbers, the first not negative");
    }
    srdf.rotors.push_back({.joint = need(joint, "name", file),
                           .line = joint.line,
                           .reflected_inertia = ratio * ratio * inertia});
  }
}

// A size that cannot be a foot's is not taken.
void read_feet(const XmlElement& element, Srdf& srdf) {
  const XmlElement* feet = element.child("feet");
  for (std::size_t side = 0; feet != nullptr && side < 2; ++side) {
    const XmlElement* foot = feet->child(side == 0 ? "left" : "right");
    const XmlElement* size = foot == nullptr ? nullptr : foot->child("size");
    const XmlElement* ankle = foot == nullptr ? nullptr : foot->child("anklePosition");
    if (size == nullptr || ankle == nullptr) continue;
    double across[2] = {0.0, 0.0};
    double place[3] = {0.0, 0.0, 0.0};
    const auto take = [](const XmlElement& from, const char* key, double& into) {
      const std::string* text = from.attribute(key);
      return text != nullptr && parse_numbers(*text, &into, 1);
    };
    if (!take(*size, "height", across[0]) || !take(*size, "width", across[1]) ||
        !take(*ankle, "x", place[0]) || !take(*ankle, "y", place[1]) ||
        !take(*ankle, "z", place[2]))
      continue;
    const double length = std::max(across[0], across[1]);
    const double width = std::min(across[0], across[1]);
    if (!(width > 0.01 && length < 1.0 && std::abs(place[0]) < 0.5 * length &&
          std::abs(place[1]) < 0.5 * width && place[2] >= 0.0 && place[2] < 0.5))
      continue;
    srdf.feet[side] = {true, length, width, place[0], place[1], place[2]};
  }
}

}  // namespace

Srdf parse_srdf(const std::string& text, const std::string& file) {
  const XmlElement robot = parse_xml(text, file);
  if (robot.name != "robot")
    fail_at(file, robot.line, "the root element is <" + robot.name + ">, not <robot>");
  Srdf srdf;
  check_names(robot, known_srdf(), file, srdf.notes);
  for (const XmlElement& element : robot.children) {
    if (element.name == "group_state") {
      read_pose(element, file, srdf);
    } else if (element.name == "rotor_params") {
      read_rotors(element, file, srdf);
    } else if (element.name == "specificities") {
      read_feet(element, srdf);
    } else if (element.name == "disable_collisions") {
      srdf.disabled.push_back({.link_a = need(element, "link1", file),
                               .link_b = need(element, "link2", file),
                               .line = element.line});
    }
  }
  return srdf;
}

}  // namespace twinbus::robot
