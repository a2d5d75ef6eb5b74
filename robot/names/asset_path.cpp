#include "robot/names/asset_path.h"

#include <filesystem>
#include <stdexcept>

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

bool is_inside(const fs::path& file, const fs::path& root) {
  const fs::path inside = file.lexically_relative(root);
  return !inside.empty() && *inside.begin() != "..";
}

// The file of package://NAME/REST; empty when no such package is known.
fs::path package_file(const std::string& path, const fs::path& own, const AssetRoots& roots,
                      std::string& package) {
  const std::size_t slash = path.find('/');
  package = path.substr(0, slash);
  const std::string rest = slash == std::string::npos ? "" : path.substr(slash + 1);
  fs::path root;
  if (package == own.filename()) root = own;
  for (const auto& [known, folder] : roots.packages) {
    if (known == package) root = fs::weakly_canonical(own / folder);
  }
  return root.empty() ? root : fs::weakly_canonical(root / fs::path(rest).relative_path());
}

}  // namespace

std::string resolve_asset(const std::string& name, const AssetRoots& roots,
                          const std::string& where) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(where + ": " + name.substr(0, 200) + " " + what);
  };
  const auto rest_after = [&](const std::string& scheme) {
    const std::size_t start = name.find_first_not_of('/', scheme.size());
    return start == std::string::npos ? std::string() : name.substr(start);
  };
  const fs::path own = fs::weakly_canonical(roots.folder);
  fs::path file;
  try {
    if (name.rfind("package://", 0) == 0) {
      std::string package;
      file = package_file(rest_after("package://"), own, roots, package);
      if (file.empty()) {
        fail("is in package " + package +
             ", which is not known; name its folder in robot.yaml, packages, or lay a folder of that name beside or above the file");
      }
    } else if (name.rfind("file://", 0) == 0) {
      file = fs::weakly_canonical(fs::path("/") / rest_after("file://"));
    } else if (name.find("://") != std::string::npos) {
      fail("cannot be read: only package://, file:// and paths relative to the robot's folder are");
    } else {
      file = fs::weakly_canonical(own / name);
    }
  } catch (const fs::filesystem_error&) {
    fail("is not the name of a file; correct it");
  }
  bool allowed = is_inside(file, own);
  for (const auto& [known, folder] : roots.packages) {
    allowed = allowed || is_inside(file, fs::weakly_canonical(own / folder));
  }
  if (!allowed) {
    fail(
        "leaves the robot's folder; copy the file there, or name its folder in robot.yaml, "
        "packages");
  }
  return file.string();
}

}  // namespace twinbus::robot
