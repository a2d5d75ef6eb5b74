// The robot's face (twinbus_face), a program that is there only where CycloneDDS was found when twinbus was built.

#pragma once

#include <string>
#include <vector>

#include "launcher/stack/stack.h"

namespace twinbus::inline launcher {

// Its path.  Throws std::runtime_error naming the packages when it was not built.
std::string face_program();

// Puts it into the stack: kind is unitree_hg or unitree_go, options those of twinbus_face.  Throws as face_program(), and for a stack
// that has a controller of its own, which would be obeyed instead.
void add_face(Stack& stack, const std::string& kind, const std::vector<std::string>& options);

}  // namespace twinbus::launcher
