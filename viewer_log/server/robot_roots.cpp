#include "viewer_log/server/robot_roots.h"

#include <filesystem>
#include <string>

namespace twinbus::inline viewer_log {

std::vector<WebRoot> robot_roots(const Model& model) {
  namespace fs = std::filesystem;
  const fs::path own = fs::weakly_canonical(model.folder);
  std::vector<WebRoot> roots = {{"/robot/", model.folder}};
  const auto add = [&](const std::string& package, const fs::path& folder) {
    roots.push_back({"/robot/package/" + package + "/", folder.string()});
  };
  for (const auto& [name, folder] : model.packages) add(name, own / folder);
  add(own.filename().string(), own);  // where none of its name is named, which comes first
  return roots;
}

}  // namespace twinbus::viewer_log
