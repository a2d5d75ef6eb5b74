// `./twinbus tune SCENE --error 1mm` and `./twinbus explain SCENE`: the whole ladder of orders and steps of a scene, and
// what of a scene is modelled at what cost.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int tune_command(const std::vector<std::string>& words);
int explain_command(const std::vector<std::string>& words);

// The text of a scene with that step and order in place of its own, and a comment above it that says why.
std::string tuned_text(const std::string& scene, int order, double step, const std::string& why);

}  // namespace twinbus
