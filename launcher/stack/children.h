// Processes that the launcher started: one process group each, watched through pidfds, ended with SIGTERM, then SIGKILL.
//
// A child's output goes to a file, so a launcher that is slow or gone never blocks it.

#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace twinbus::inline launcher {

struct ChildSpec {
  std::string name;
  std::vector<std::string> command;  // program (a path) and its arguments
  std::string log_file;              // stdout and stderr are appended here
  bool dies_with_launcher =
      true;            // SIGKILL when the launcher ends; not for a bridge to real motors
  double grace = 2.0;  // from SIGTERM to SIGKILL [s]
};

class Child {
 public:
  // Starts the program.  Throws std::runtime_error if it cannot be started, naming it.
  explicit Child(const ChildSpec& spec);
  // Ends it, whatever it takes.
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;

  const std::string& name() const { return spec_.name; }
  const ChildSpec& spec() const { return spec_; }
  pid_t pid() const { return pid_; }
  int pidfd() const {
    return pidfd_;
  }  // readable once the child has ended; -1 after that was noticed
  bool running() const { return pidfd_ >= 0; }

  // Notices an end without waiting.  True once, when the child has ended since the last call.
  bool take_end();
  // It has ended and nobody has taken note yet.
  bool wait_is_over() const;
  // How it ended, as words: "exit status 1", "signal 9 (Killed)".
  const std::string& how_it_ended() const { return how_; }
  bool ended_well() const { return well_; }

  void ask_to_stop() const;           // SIGTERM to its group
  bool wait_for_end(double seconds);  // true if it ended
  void kill_group();                  // SIGKILL to its group, then waits
  // The last lines it printed, at most count.
  std::vector<std::string> last_lines(int count) const;

 private:
  void reap();

  ChildSpec spec_;
  pid_t pid_ = -1;
  int pidfd_ = -1;
  bool well_ = false;
  std::string how_;
};

// Last lines of a text file, at most count; empty if it cannot be read.
std::vector<std::string> tail_of(const std::string& file, int count);

}  // namespace twinbus::launcher
