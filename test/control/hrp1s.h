// The robot of most tests of control/, loaded once.

#pragma once

#include "robot/description/load.h"
#include "robot/description/model.h"

namespace twinbus::test {

inline const Model& hrp1s() {
  static const Model model = load_robot("hrp1s");
  return model;
}

// With `pattern: preview` or `pattern: closed_form` in the map `walking` of its robot.yaml.
inline Model with_pattern(Model model, bool preview) {
  model.walking.preview = preview;
  return model;
}

}  // namespace twinbus::test
