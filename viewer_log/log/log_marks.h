// The moments of a log that somebody looks for: who held STATE, stops, falls, what the guard did, missed ticks, what was said.
//
// Fed with every message in order; gives a list, bounded, for the timeline of the page.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline viewer_log {

enum class MarkKind : std::int8_t { kSwitch, kStop, kFall, kGuard, kMissed, kMessage };
const char* label(MarkKind kind) noexcept;

struct LogMark {
  double seconds = 0.0;  // from the first event of the log
  MarkKind kind = MarkKind::kMessage;
  std::string text;
};

inline constexpr std::size_t kMostMarks = 3000;

class MarkFinder {
 public:
  explicit MarkFinder(std::int64_t first_utime) : first_utime_(first_utime) {}

  void on_state(const RobotState& state, std::int64_t utime);
  void on_estimate(const Estimate& estimate, std::int64_t utime);
  void on_guard(const GuardReport& report, std::int64_t utime);
  void on_source_status(const SourceStatus& status, std::int64_t utime);
  void on_event(const Event& event, std::int64_t utime);

  const std::vector<LogMark>& marks() const { return marks_; }
  std::int64_t left_out() const { return left_out_; }  // more than kMostMarks

 private:
  void add(std::int64_t utime, MarkKind kind, std::string text);

  std::int64_t first_utime_;
  std::vector<LogMark> marks_;
  std::int64_t left_out_ = 0;
  RobotState last_;
  std::int64_t last_state_utime_ = 0, quiet_since_ = 0;
  std::int64_t paused_run_ = 0;  // has said so since the last state
  bool holding_ = false, upright_ = true;
  std::map<std::int64_t, std::int64_t> missed_;              // per run
  std::vector<std::pair<std::int64_t, std::int32_t>> told_;  // newest per sender
};

}  // namespace twinbus::viewer_log
