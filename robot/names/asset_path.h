// Where a file named inside a robot description is: package://, file://, absolute or relative, and
// always inside the robot's folder or a root that robot.yaml names.

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twinbus::inline robot {

// What may be read: the robot's own folder, also as the package of its own name, and the folders
// that robot.yaml names.
struct AssetRoots {
  std::string folder;
  std::vector<std::pair<std::string, std::string>> packages;  // name, folder
};

// The full name of the file; it need not exist.  Links of the file system are followed before the
// roots are compared.  Throws std::runtime_error, beginning with where, with the remedy.
std::string resolve_asset(const std::string& name, const AssetRoots& roots,
                          const std::string& where);

}  // namespace twinbus::robot
