// Computes controllers and guards of a log again, from the messages and the journal in it, and compares bit for bit.
//
// What a process consumed is found by its hash in the journal; so a message that a disk has changed is recognised, by one
// bit even mended, and named.

#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "control/loop/control_loop.h"
#include "control/guard/guard_watch.h"
#include "launcher/log/log_store.h"
#include "lcmtypes/msg/journal.h"
#include "robot/description/model.h"
#include "robot/collision/obstacle_collector.h"

namespace twinbus::inline launcher {

struct RerunFigures {
  ProcessKind kind = ProcessKind::kNone;
  std::int64_t id = 0;
  std::int64_t steps = 0;      // computed again
  std::int64_t answers = 0;    // commands, or guard reports
  std::int64_t different = 0;  // steps whose answer or estimate is not the same
  std::int64_t inputs = 0;     // messages consumed
  std::int64_t missing = 0;    // inputs or answers that the log does not have
  std::int64_t damaged = 0;    // messages in the log that are not what was sent
  bool whole = true;           // from the first step to the last one in the log
};

// Everything was computed again, and nothing is missing.
bool is_same(const std::vector<RerunFigures>& figures);
// What they come to, a line: an answer that differs is told apart from one that the log does not allow to compare.
std::string rerun_verdict(const std::vector<RerunFigures>& figures);

class Rerun {
 public:
  // The model must outlive this.
  explicit Rerun(const Model& model) : model_(model) {}

  // Every event of the log, in order, with the prefix taken off the channel.
  void add(std::string_view channel, std::int64_t utime, std::span<const std::uint8_t> bytes);
  // At the end of the log.
  void finish();

  std::vector<RerunFigures> figures() const;
  // Sentences, the first difference first; at most a few dozen.
  const std::vector<std::string>& findings() const { return findings_; }

 private:
  struct Process {
    RerunFigures figures;
    std::int64_t next_page = 0;
    std::unique_ptr<ControlLoop> loop;
    std::unique_ptr<GuardWatch> watch;
    ObstacleCollector obstacles;
  };
  struct Waiting {
    std::int64_t utime;
    JournalPage page;
  };

  void turn(const JournalPage& page);
  void start(Process& process, const JournalPage& page);
  void consume(Process& process, const JournalPage& page, std::size_t i);
  void step(Process& process, const JournalPage& page);
  std::vector<std::uint8_t> input(Process& process, const std::string& channel, std::int64_t hash,
                                  const JournalPage& page);
  void compare(Process& process, const JournalPage& page, const std::string& channel,
               std::int64_t hash_then, const std::vector<std::uint8_t>& now);
  void say(const Process& process, const JournalPage& page, const std::string& sentence);

  const Model& model_;
  LogStore store_;
  std::deque<Waiting> waiting_;
  std::map<std::int64_t, Process> processes_;
  std::vector<std::string> findings_;
  int mends_ = 0;
};

}  // namespace twinbus::launcher
