// `./twinbus tune SCENE --error 1mm` and `./twinbus explain SCENE`: the whole ladder of orders and steps of a scene, and
// what of a scene is modelled at what cost.

#pragma once

#include <string>
#include <vector>

#include "launcher/run/ladder.h"

namespace twinbus {

int tune_command(const std::vector<std::string>& words);
int explain_command(const std::vector<std::string>& words);

// The text of a scene with the step, order and held parts of that rung in place of its own, and a comment above it that
// says why.
std::string tuned_text(const std::string& scene, const Rung& rung, const std::string& why);

}  // namespace twinbus
