// What config/packages.txt asks for on a machine.  The script `twinbus` reads it by itself, before anything is built.

#pragma once

#include <istream>
#include <string>
#include <vector>

namespace twinbus::inline launcher {

struct PackageList {
  std::vector<std::string> needed, spy;  // always; for ./twinbus spy alone
};

// Of a file as /etc/os-release: ID and ID-VERSION_ID, as "debian" and "debian-12".
std::vector<std::string> release_names(std::istream& os_release);
// here: those; a package may be for some releases only ([debian-13 ubuntu]) or for all but some ([!ubuntu-22.04]).
PackageList packages_for(std::istream& list, const std::vector<std::string>& here);

}  // namespace twinbus::launcher
