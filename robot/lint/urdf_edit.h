// Reading and changing elements of a URDF's text.

#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "common/text/formatted.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

inline constexpr std::array<const char*, 6> kInertiaKeys{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};

inline std::string short_number(double value) {
  return formatted("%.6g", value);
}

inline XmlElement* child_to_change(XmlElement& element, const char* name) {
  const auto found = std::find_if(element.children.begin(), element.children.end(),
                                  [&](const XmlElement& c) { return c.name == name; });
  return found == element.children.end() ? nullptr : &*found;
}

inline bool read_number(const XmlElement& element, const std::string& key, double& value) {
  const std::string* text = element.attribute(key);
  return text != nullptr && parse_numbers(*text, &value, 1);
}

inline void write_attribute(XmlElement& element, const std::string& key, const std::string& value) {
  for (auto& [name, text] : element.attributes) {
    if (name == key) {
      text = value;
      return;
    }
  }
  element.attributes.emplace_back(key, value);
}

inline std::string element_name(const XmlElement& element) {
  const std::string* name = element.attribute("name");
  return name == nullptr ? "?" : *name;
}

inline std::string mended_text(const XmlElement& robot) {
  std::string text = "<?xml version=\"1.0\"?>\n<!-- Mended by `twinbus check`. -->\n";
  append_xml(robot, text);
  return text;
}

}  // namespace twinbus::robot
