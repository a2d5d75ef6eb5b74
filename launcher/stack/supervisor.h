// Keeps the processes of a stack: starts each when those it waits for are ready, notices deaths, restarts what may be
// restarted, and stops everything in reverse order.
//
// Knows nothing of the bus: whoever owns it says when a message made a process ready.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "launcher/stack/children.h"
#include "launcher/stack/stack.h"

namespace twinbus::inline launcher {

struct Supervised {
  StackProcess process;
  ChildSpec spec;
  std::vector<Child> child;  // none or one
  bool ready = false;
  bool died = false;  // and was not started again
  int restarts = 0;
  bool asked_anew = false;  // by hand: started again when it has ended
  std::int64_t asked_ns = 0;
  std::int64_t started_ns = 0;
  std::uintmax_t log_begin = 0;  // where in its log file the output of this start begins [bytes]
};

class Supervisor {
 public:
  using Say = std::function<void(const std::string& line)>;

  // folder: where each process's output goes.  say gets one line per thing that happens.
  Supervisor(const Stack& stack, const Placeholders& placeholders, const std::string& folder,
             Say say);
  ~Supervisor();

  // Starts what may be started now.  Throws std::runtime_error if a process takes longer than its ready_timeout, or ends
  // before it was ready, with its last lines.
  void start_more(std::int64_t now_ns);
  bool all_ready() const;

  // A word on the bus of the process of that name makes it ready.
  void heard_from_name(const std::string& name);

  // Reports each death once, restarts what may be.
  void watch(std::int64_t now_ns);
  // Ends a process and starts it again, or starts one that had died.  Of several that are asked for, one that waits for another
  // of them starts when that has started; one that waits for a line of output, when that has come.  A sentence when it cannot be.
  std::string restart(const std::string& name, std::int64_t now_ns);
  // What processes are given when they are started from now on.  Throws as fill_in.
  void fit(const Placeholders& placeholders);
  // Of the one that runs; 0 if none does.
  std::int32_t pid_of(const std::string& name) const;
  // A required process is gone for good.
  bool broken() const { return broken_; }
  // Nothing publishes STATE, nor stands by to.
  bool every_source_ended() const;

  // In reverse order: SIGTERM, waits, SIGKILL.  True if every process ended by itself with exit status 0.
  bool stop_all();

  const std::vector<Supervised>& processes() const { return processes_; }

 private:
  void start(Supervised& one, std::int64_t now_ns);
  bool waits(const Supervised& one) const;
  void report_end(const Supervised& one, const Child& child) const;

  std::vector<Supervised> processes_;
  Say say_;
  bool broken_ = false;
};

}  // namespace twinbus::launcher
