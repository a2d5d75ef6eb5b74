#include "robot/srdf.h"

#include "robot/xml.h"

namespace twinbus {

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
    if (!parse_numbers(need(joint, "value", file), &value, 1)) {
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

}  // namespace

Srdf parse_srdf(const std::string& text, const std::string& file) {
  const XmlElement robot = parse_xml(text, file);
  if (robot.name != "robot")
    fail_at(file, robot.line, "the root element is <" + robot.name + ">, not <robot>");
  Srdf srdf;
  for (const XmlElement& element : robot.children) {
    if (element.name == "group_state") {
      read_pose(element, file, srdf);
    } else if (element.name == "rotor_params") {
      read_rotors(element, file, srdf);
    } else if (element.name == "disable_collisions") {
      srdf.disabled.push_back({.link_a = need(element, "link1", file),
                               .link_b = need(element, "link2", file),
                               .line = element.line});
    }
  }
  return srdf;
}

}  // namespace twinbus
