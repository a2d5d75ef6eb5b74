// The robot of most tests of control/, loaded once.

#pragma once

#include "robot/load.h"
#include "robot/model.h"

namespace twinbus::test {

inline const Model& hrp1s() {
  static const Model model = load_robot("hrp1s");
  return model;
}

}  // namespace twinbus::test
