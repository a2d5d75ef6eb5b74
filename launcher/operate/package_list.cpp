#include "launcher/operate/package_list.h"

#include <algorithm>
#include <sstream>

namespace twinbus::inline launcher {

namespace {

// The places behind a package, between its brackets.
bool is_for(const std::string& places, const std::vector<std::string>& here) {
  const bool but = places.starts_with('!');
  std::istringstream names(places.substr(but ? 1 : 0));
  bool any = false;
  for (std::string name; names >> name;) any = any || std::find(here.begin(), here.end(), name) != here.end();
  return any != but;
}

}  // namespace

std::vector<std::string> release_names(std::istream& os_release) {
  std::string id, version;
  for (std::string line; std::getline(os_release, line);) {
    std::erase(line, '"');
    if (line.starts_with("ID=")) id = line.substr(3);
    if (line.starts_with("VERSION_ID=")) version = line.substr(11);
  }
  return {id, id + "-" + version};
}

PackageList packages_for(std::istream& list, const std::vector<std::string>& here) {
  PackageList wanted;
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line);
    std::string package, rest;
    if (!(words >> package) || package[0] == '#') continue;
    const bool spy = package == "spy:" && words >> package;
    if (package.ends_with(':')) continue;
    std::getline(words >> std::ws, rest);
    const std::size_t end = rest.starts_with('[') ? rest.find(']') : std::string::npos;
    if (end != std::string::npos && !is_for(rest.substr(1, end - 1), here)) continue;
    (spy ? wanted.spy : wanted.needed).push_back(package);
  }
  return wanted;
}

}  // namespace twinbus::launcher
