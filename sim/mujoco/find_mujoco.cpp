#include "sim/mujoco/find_mujoco.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace twinbus::inline sim {

namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::vector<fs::path> entries(const fs::path& folder, const std::string& begin) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
    if (each->path().filename().string().rfind(begin, 0) == 0) found.push_back(each->path());
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

void add_folder(const fs::path& folder, std::vector<std::string>& files) {
  for (const fs::path& file : entries(folder, "libmujoco.so")) files.push_back(file.string());
}

// PREFIX/lib/python3.N/site-packages/mujoco, and what Debian calls it.
void add_python(const fs::path& prefix, std::vector<std::string>& files) {
  for (const fs::path& python : entries(prefix / "lib", "python3")) {
    for (const char* packages : {"site-packages", "dist-packages"}) add_folder(python / packages / "mujoco", files);
  }
}

}  // namespace

std::vector<std::string> mujoco_files() {
  std::vector<std::string> files;
  if (const std::string named = environment("TWINBUS_MUJOCO"); !named.empty()) {
    if (fs::is_directory(named)) {
      add_folder(named, files);
    } else if (fs::exists(named)) {
      files.push_back(named);
    }
    if (files.empty())
      throw std::runtime_error("TWINBUS_MUJOCO=" + named + ": is no libmujoco.so and no folder that holds one; name the file, or "
                               "unset it and `pip install mujoco`");
    return files;
  }
  files.emplace_back("libmujoco.so");  // of the loader's own path
  for (const char* folder : {"/usr/local/lib", "/usr/lib"}) {
    add_folder(folder, files);
    for (const fs::path& each : entries(folder, "")) {
      if (each.filename().string().find("-linux-gnu") != std::string::npos) add_folder(each, files);
    }
  }
  for (const char* name : {"VIRTUAL_ENV", "CONDA_PREFIX"}) {
    if (const std::string prefix = environment(name); !prefix.empty()) add_python(prefix, files);
  }
  std::istringstream path(environment("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    std::error_code error;
    const fs::path python = fs::path(folder) / "python3";
    if (!folder.empty() && fs::exists(python, error)) add_python(fs::path(folder).parent_path(), files);
  }
  if (const std::string home = environment("HOME"); !home.empty()) add_python(fs::path(home) / ".local", files);
  return files;
}

}  // namespace twinbus::sim
