// The robot of most tests of control/, loaded once.

#pragma once

#include <string>

#include "robot/description/load.h"
#include "robot/description/model.h"

namespace twinbus::test {

inline const Model& hrp1s() {
  static const Model model = load_robot("hrp1s");
  return model;
}

// As if the map `walking` of its robot.yaml said so too.
inline Model say_walking(Model model, const std::string& words) {
  const std::size_t walking = model.yaml_text.find("walking:");
  if (walking == std::string::npos) {
    model.yaml_text += "\nwalking: {" + words + "}\n";
  } else {
    model.yaml_text.insert(model.yaml_text.find('{', walking) + 1, words + ", ");
  }
  return model;
}

}  // namespace twinbus::test
