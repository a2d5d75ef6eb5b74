// Whether a robot can be simulated and stands, by the code of `twinbus run stand` itself.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

struct Trial {
  std::string refusal;         // why `run` would refuse it; empty: it does not
  std::string cannot_balance;  // why it is no robot that balances; empty: it is one
  bool stood = false;          // by balance, or by its servos when it cannot balance
  bool free = false;           // its base is
  bool arm = false;            // its base does not float, and it has a hand
  bool planar = false;         // its base moves on the plane
  double simulated_s = 0.0, wall_s = 0.0;
  std::string figures;                // one line
  std::vector<std::string> failures;  // of the criteria of scene `stand`
  std::vector<std::string> weak;      // joints whose effort limit does not hold half_sitting
};

// Both engines make a world of it, then it stands for two seconds, or as far as ten seconds of the
// machine's time reach.
Trial try_to_stand(const Model& model);

}  // namespace twinbus::launcher
