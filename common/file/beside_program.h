// What lies beside the program that runs: in the source tree around its build folder, or in the installation around it.

#pragma once

#include <string>

namespace twinbus::inline common {

// The path of `what` ("config/robots", "viewer_log/web/dist"): looked for in the program's folder and the three above it, in
// each also below share/twinbus.  `otherwise` if it is nowhere there.
std::string beside_program(const std::string& what, const std::string& otherwise = "");

// The program is an installed one (PREFIX/lib/twinbus/bin), not one of a build folder.
bool program_is_installed();

}  // namespace twinbus::common
