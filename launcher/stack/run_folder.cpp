#include "launcher/stack/run_folder.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "common/file/beside_program.h"
#include "common/time/time_name.h"
#include "robot/description/load.h"

namespace twinbus {

namespace fs = std::filesystem;

std::string program_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? "." : program.parent_path().string();
}

std::string install_folder() { return fs::path(config_folder()).parent_path().string(); }

std::string runs_folder() {
  const char* wanted = std::getenv("TWINBUS_RUNS");
  if (wanted != nullptr && *wanted != '\0') return wanted;
  if (!program_is_installed()) return install_folder() + "/runs";
  // An installation belongs to everybody: each user's runs are at home.
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != '\0') return std::string(data) + "/twinbus/runs";
  const char* home = std::getenv("HOME");
  return (home != nullptr && *home != '\0' ? std::string(home) + "/.local/share" : "/var/tmp") + "/twinbus/runs";
}

std::string make_run_folder() {
  const fs::path runs = runs_folder();
  const std::string date = time_name();
  std::error_code error;
  fs::create_directories(runs, error);
  for (int attempt = 1; attempt < 100 && !error; ++attempt) {
    const fs::path folder = runs / (attempt == 1 ? date : date + "-" + std::to_string(attempt));
    if (fs::create_directory(folder, error)) return folder.string();
  }
  throw std::runtime_error("cannot make a folder for this run in " + runs.string() + ": " +
                           error.message() + "; set TWINBUS_RUNS to a folder that can be written");
}

void write_file(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

std::string commit_of_program() {
  // .git is read directly: git may not be installed where the program runs.
  const fs::path git = fs::path(install_folder()) / ".git";
  std::ifstream head(git / "HEAD");
  std::string line;
  if (!std::getline(head, line)) return "unknown";
  if (line.starts_with("ref: ")) {
    std::ifstream reference(git / line.substr(5));
    if (!std::getline(reference, line)) return "unknown";
  }
  return line;
}

}  // namespace twinbus
