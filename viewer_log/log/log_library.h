// The logs that may be opened by name: those of the command line, and those in the folder of runs, the newest first.
//
// A page names a log, never a file.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twinbus::inline viewer_log {

struct ShelvedLog {
  std::string name;  // of its run folder, or of its file
  std::string file;
  std::int64_t bytes = 0;
  std::int64_t changed_s = 0;  // [s] since 1970
};

class LogShelf {
 public:
  // runs may be empty or missing.
  explicit LogShelf(std::string runs) : runs_(std::move(runs)) { look(); }

  // Looks into the folder again.
  void look();
  // A file, a run folder, the name of a run, or empty for the newest; puts it on the shelf and gives its name.
  // Throws std::runtime_error saying what there is instead.
  std::string add(const std::string& asked);
  const std::vector<ShelvedLog>& logs() const { return logs_; }
  const ShelvedLog* find(const std::string& name) const;

 private:
  std::string runs_;
  std::vector<ShelvedLog> given_, logs_;
};

}  // namespace twinbus::viewer_log
