#include "launcher/stack/run_folder.h"

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "common/file/beside_program.h"
#include "common/time/time_name.h"
#include "robot/description/load.h"

namespace twinbus::inline launcher {

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

std::string first_line_of(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

namespace {

// What a branch points at: a file of its own, or a line of packed-refs.
std::string commit_of_branch(const fs::path& git, const std::string& name) {
  if (const std::string loose = first_line_of(git / name); !loose.empty()) return loose;
  std::ifstream packed(git / "packed-refs");
  for (std::string line; std::getline(packed, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos && line.substr(space + 1) == name) return line.substr(0, space);
  }
  return "unknown";
}

}  // namespace

std::string commit_of_tree(const std::string& tree) {
  // .git is read directly: git may not be installed where the program runs.
  fs::path git = fs::path(tree) / ".git";
  std::error_code ignored;
  if (fs::is_regular_file(git, ignored)) {  // of a worktree: "gitdir: PATH"
    const std::string line = first_line_of(git);
    git = line.starts_with("gitdir: ") ? fs::path(tree) / line.substr(8) : fs::path();
  }
  const std::string head = first_line_of(git / "HEAD");
  if (head.empty()) return "unknown";
  if (!head.starts_with("ref: ")) return head;
  const std::string common = first_line_of(git / "commondir");  // where a worktree's branches are
  return commit_of_branch(common.empty() ? git : git / common, head.substr(5));
}

std::string commit_of_program() {
  const std::string installed = first_line_of(install_folder() + "/commit");
  return program_is_installed() && !installed.empty() ? installed : commit_of_tree(install_folder());
}

namespace {

bool is_running(const std::string& folder) {
  const std::string text = first_line_of(folder + "/pid");
  if (text.empty()) return false;
  const long pid = std::strtol(text.c_str(), nullptr, 10);
  return pid > 1 && ::kill(static_cast<pid_t>(pid), 0) == 0;
}

// The run folders whose `up` is running.
std::vector<std::string> running_folders() {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(runs_folder(), ignored)) {
    if (is_running(entry.path().string())) found.push_back(entry.path().string());
  }
  return found;
}

}  // namespace

std::string running_folder() {
  const std::vector<std::string> folders = running_folders();
  if (folders.empty()) throw std::runtime_error("no stack of ./twinbus up is running");
  if (folders.size() > 1)
    throw std::runtime_error("several stacks are running (" + folders[0] + ", " + folders[1] +
                             "); set TWINBUS_RUNS to the folder of one's own");
  return folders.front();
}

}  // namespace twinbus::launcher
