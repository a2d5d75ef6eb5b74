// What our own log files say about themselves once a second, as events on LOG_INDEX: checksums of the events since the
// last one, and how many there have been on each channel.
//
// So `log info` reads the end of a log instead of all of it, and a bit that flipped on a disk is found.  To stock LCM
// tools it is a channel like any other.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer_log/log/log_event.h"

namespace twinbus::inline viewer_log {

inline constexpr char kLogIndex[] = "LOG_INDEX";
inline constexpr std::size_t kMostSums = 8192;  // of one index

struct ChannelCount {
  std::int64_t events = 0;
  std::int64_t bytes = 0;  // of data
};
using ChannelCounts = std::map<std::string, ChannelCount, std::less<>>;

struct LogIndex {
  std::int64_t offset = 0;        // where in its file it was written: elsewhere it says nothing
  std::int64_t first_utime = 0;   // of the file
  std::int64_t first_number = 0;  // of the event that the first sum is of
  std::vector<std::uint32_t> sums;
  ChannelCounts channels;  // since the file began, without LOG_INDEX itself
};

std::uint32_t event_sum(std::span<const std::uint8_t> event);
std::vector<std::uint8_t> encode_index(const LogIndex& index);
// Nothing when the bytes are no index.
std::optional<LogIndex> decode_index(std::span<const std::uint8_t> data);

// Compares events with the sums that follow them.  Feed it every event of a log, in order.
class LogCheck {
 public:
  void add(const LogEvent& event);
  std::int64_t checked() const { return checked_; }
  std::int64_t wrong() const { return wrong_; }      // events that are not what was written
  std::int64_t missing() const { return missing_; }  // events that were written and are gone
  // Offsets of the first few wrong ones.
  const std::vector<std::int64_t>& places() const { return places_; }

 private:
  struct Waiting {
    std::int64_t number, offset;
    std::uint32_t sum;
  };
  void compare(const LogIndex& index);

  std::vector<Waiting> waiting_;
  std::vector<std::int64_t> places_;
  std::int64_t checked_ = 0, wrong_ = 0, missing_ = 0;
};

}  // namespace twinbus::viewer_log
