// The page's button that records a log: a recorder of its own for as long as it is on.

#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace twinbus::inline viewer_log {

class LogButton {
 public:
  // folder: in which each log gets a folder of its own, DATE-TIME_page/run.log, so that `./twinbus view` finds it.
  // words: of the recorder's command line besides the file (--url and the like).
  LogButton(std::string folder, std::vector<std::string> words);
  ~LogButton();
  LogButton(const LogButton&) = delete;
  LogButton& operator=(const LogButton&) = delete;

  void turn(bool on);
  // Call now and then: notices that a recorder has ended.
  void look();

  bool on() const { return child_ > 0; }
  // For the page: {"type":"recording","on":...,"text":...}, one sentence on what became of the newest press.
  std::string frame() const;
  std::int64_t version() const { return version_; }  // of the frame

 private:
  std::string start();
  void ask_to_end();

  std::string folder_;
  std::vector<std::string> words_;
  std::string file_, text_;
  std::int64_t version_ = 0;
  pid_t child_ = 0;
  bool asked_ = false;  // to end
};

}  // namespace twinbus::viewer_log
