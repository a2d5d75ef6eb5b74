#include "viewer_log/view/log_button.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <utility>

#include "common/time/time_name.h"
#include "viewer_log/view/frame_number.h"

namespace twinbus::inline viewer_log {

namespace {

namespace fs = std::filesystem;

// The programs of a build lie beside each other.
std::string recorder_program() {
  std::error_code error;
  return (fs::read_symlink("/proc/self/exe", error).parent_path() / "twinbus_recorder").string();
}

}  // namespace

LogButton::LogButton(std::string folder, std::vector<std::string> words)
    : folder_(std::move(folder)), words_(std::move(words)) {}

LogButton::~LogButton() {
  ask_to_end();
  if (on()) waitpid(child_, nullptr, 0);
}

void LogButton::turn(bool on) {
  look();
  if (on && !this->on()) {
    text_ = start();
    ++version_;
  } else if (!on) {
    ask_to_end();
  }
}

std::string LogButton::start() {
  const fs::path folder = fs::path(folder_) / (time_name() + "_page");
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string program = recorder_program();
  if (error || access(program.c_str(), X_OK) != 0)
    return "Cannot record: " + (error ? folder.string() + ": " + error.message() : "no " + program);
  file_ = (folder / "run.log").string();
  std::vector<std::string> words{program, file_};
  words.insert(words.end(), words_.begin(), words_.end());
  std::vector<char*>
      arguments;  // before the fork: the child of a process with threads allocates nothing
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  child_ = fork();
  if (child_ == 0) {
    setpgid(0, 0);                    // Ctrl-C is ours to pass on
    prctl(PR_SET_PDEATHSIG, SIGINT);  // and it never outlives the viewer
    close_range(3, ~0U, 0);           // nor keeps its sockets
    execv(program.c_str(), arguments.data());
    _exit(127);
  }
  if (child_ < 0) {
    child_ = 0;
    return "Cannot record: no process can be started.";
  }
  return "Recording: " + file_;
}

void LogButton::look() {
  if (child_ <= 0 || waitpid(child_, nullptr, WNOHANG) != child_) return;
  child_ = 0;
  text_ = (asked_ ? "Recorded: ./twinbus view " : "The recorder has ended by itself: ") + file_;
  asked_ = false;
  ++version_;
}

// It still writes its index: look() sees when it is gone.  Nobody waits, for a stop comes the same way.
void LogButton::ask_to_end() {
  if (!on() || asked_) return;
  kill(child_, SIGINT);
  asked_ = true;
}

std::string LogButton::frame() const {
  return dump({{"type", "recording"}, {"on", on()}, {"text", text_}});
}

}  // namespace twinbus::viewer_log
