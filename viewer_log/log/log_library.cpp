#include "viewer_log/log/log_library.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline viewer_log {

namespace {

namespace fs = std::filesystem;

constexpr char kLogOfRun[] = "run.log";
constexpr std::size_t kMostShelved = 60;

// Nothing for what is no file or is empty.
std::optional<ShelvedLog> shelved(const fs::path& file, std::string name) {
  struct stat about {};
  if (stat(file.c_str(), &about) != 0 || !S_ISREG(about.st_mode) || about.st_size == 0) return {};
  std::int64_t bytes = about.st_size, changed = about.st_mtime;
  const std::vector<std::string> parts = log_parts(file.string());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (stat(parts[i].c_str(), &about) != 0) continue;
    bytes += about.st_size;
    changed = std::max<std::int64_t>(changed, about.st_mtime);
  }
  return ShelvedLog{std::move(name), file.string(), bytes, changed};
}

}  // namespace

void LogShelf::look() {
  std::vector<ShelvedLog> found;
  std::error_code error;
  for (fs::directory_iterator at(runs_, error), end; !error && at != end; at.increment(error)) {
    if (auto log = shelved(at->path() / kLogOfRun, at->path().filename().string()))
      found.push_back(std::move(*log));
  }
  std::sort(found.begin(), found.end(), [](const ShelvedLog& a, const ShelvedLog& b) {
    return a.changed_s != b.changed_s ? a.changed_s > b.changed_s : a.name > b.name;
  });
  logs_ = given_;
  for (ShelvedLog& log : found) {
    if (logs_.size() >= kMostShelved) break;
    if (find(log.name) == nullptr) logs_.push_back(std::move(log));
  }
}

std::string LogShelf::add(const std::string& asked) {
  if (asked.empty()) {
    if (logs_.empty())
      throw std::runtime_error("no run is recorded in '" + runs_ +
                               "' yet: name a log, or run ./twinbus up first");
    return logs_.front().name;
  }
  if (find(asked) != nullptr) return asked;
  std::error_code error;
  const fs::path path = fs::absolute(asked, error).lexically_normal();
  const bool folder = fs::is_directory(path, error);
  fs::path file = folder ? path / kLogOfRun : path;
  fs::path named = folder || path.filename() != kLogOfRun ? path : path.parent_path();
  std::string name = named.filename().empty() ? named.parent_path().filename().string()
                                              : named.filename().string();
  while (find(name) != nullptr && find(name)->file != file) name += "'";
  auto log = shelved(file, name);
  if (!log) throw std::runtime_error("log " + asked + ": no such file or run, or it is empty");
  if (find(name) != nullptr) return name;
  given_.push_back(std::move(*log));
  look();
  return name;
}

const ShelvedLog* LogShelf::find(const std::string& name) const {
  const auto found = std::find_if(logs_.begin(), logs_.end(),
                                  [&](const ShelvedLog& log) { return log.name == name; });
  return found == logs_.end() ? nullptr : &*found;
}

}  // namespace twinbus::viewer_log
