// What `./twinbus tune SCENE --write` writes.

#pragma once

#include <string>

#include "launcher/run/ladder.h"

namespace twinbus::inline launcher {

// The text of a scene with the step, order and held parts of that rung in place of its own, and a comment above it that
// says why.
std::string tuned_text(const std::string& scene, const Rung& rung, const std::string& why);

}  // namespace twinbus::launcher
