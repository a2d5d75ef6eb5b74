#include "robot/names/transmission.h"

#include <cmath>

namespace twinbus::inline robot {

namespace {

// The number in an element's text or in its attribute `value`; what stands there must be one.
void read(const XmlElement& parent, const char* name, double low, const std::string& owner,
          const std::string& file, double& into) {
  const XmlElement* element = parent.child(name);
  if (element == nullptr) return;
  const std::string* value = element->attribute("value");
  const std::string& text = value != nullptr ? *value : element->text;
  double number = 0.0;
  if (!parse_numbers(text, &number, 1) || !(std::abs(number) >= low && std::abs(number) <= 1e6)) {
    fail_at(file, element->line,
            owner + ": " + name + " \"" + text.substr(0, 60) + "\" must be a number of size " +
                (low > 0.0 ? "above 0" : "0") + " to 1e6");
  }
  into = number;
}

}  // namespace

std::vector<Transmission> read_transmissions(const XmlElement& robot, const std::string& file) {
  std::vector<Transmission> all;
  for (const XmlElement& element : robot.children) {
    if (element.name != "transmission") continue;
    const std::string* name = element.attribute("name");
    const std::string owner = "transmission " + (name == nullptr ? "without a name" : *name);
    Transmission common{.joint = "", .line = element.line};
    read(element, "mechanicalReduction", 1e-6, owner, file, common.gear_ratio);
    for (const XmlElement& actuator : element.children) {
      if (actuator.name != "actuator" && actuator.name != "joint") continue;
      read(actuator, "mechanicalReduction", 1e-6, owner, file, common.gear_ratio);
      read(actuator, "drake:gear_ratio", 1e-6, owner, file, common.gear_ratio);
      read(actuator, "drake:rotor_inertia", 0.0, owner, file, common.rotor_inertia);
    }
    if (!(common.rotor_inertia >= 0.0)) {
      fail_at(file, element.line, owner + ": drake:rotor_inertia must not be negative");
    }
    for (const XmlElement& joint : element.children) {
      const std::string* joint_name = joint.attribute("name");
      if (joint.name != "joint" || joint_name == nullptr) continue;
      common.joint = *joint_name;
      for (const Transmission& other : all) {
        if (other.joint == common.joint && other.reflected() != common.reflected()) {
          fail_at(file, joint.line,
                  owner + ": joint " + common.joint +
                      " has another transmission with other numbers on line " +
                      std::to_string(other.line) + "; keep one");
        }
      }
      all.push_back(common);
    }
  }
  return all;
}

}  // namespace twinbus::robot
