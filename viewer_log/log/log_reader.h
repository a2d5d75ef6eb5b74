// Reads log files, also damaged ones: what cannot be an event is stepped over and counted.
//
// Every intact event is given back, whatever happened around it: an event is judged by itself, not by its
// successor.  Its lengths are believed only if no other event begins inside it.  Memory is bounded: a window of
// the file, whatever the file says.

#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viewer_log/log/log_event.h"

namespace twinbus::inline viewer_log {

struct LogDamage {
  std::int64_t places = 0;  // runs of bytes that are no events
  std::int64_t bytes = 0;   // in them
  bool cut = false;         // the last event is not complete
};

// run.log, 3 -> run-0003.log.
std::string log_part_name(const std::string& file, int part);
// The files of the log that this one is the first part of, in order, itself first; of any other file itself alone.
std::vector<std::string> log_parts(const std::string& file);
// run-0003.log -> run.log, when that is there and has this part; else empty.
std::string log_of_part(const std::string& file);

class LogReader {
 public:
  // The log and the parts that follow it.  Throws std::runtime_error naming a file that cannot be read.
  explicit LogReader(const std::string& file);
  // The bytes of a log; they must outlive the reader.
  explicit LogReader(std::span<const std::uint8_t> bytes);
  ~LogReader();
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  // The next intact event, valid until the next call of anything.  False at the end.
  bool next(LogEvent& event);
  // Goes to the first event at or after that time, as far as times in the log do not go back.  Needs no index: about
  // twenty reads, however long the log is.
  void seek(std::int64_t utime);
  // Goes to the first event at or behind this place.  Damage that was counted stays counted.
  void go_to(std::int64_t offset);

  std::int64_t offset() const { return offset_; }
  std::int64_t size() const { return size_; }  // [bytes] of all parts
  const LogDamage& damage() const { return damage_; }
  int parts() const { return static_cast<int>(std::max<std::size_t>(parts_.size(), 1)); }
  // Where a part begins and ends.
  std::int64_t part_begin(int part) const;
  std::int64_t part_end(int part) const;

 private:
  struct Head {
    std::int64_t number = 0;
    std::size_t name = 0, data = 0;  // lengths
    std::int64_t total() const { return static_cast<std::int64_t>(kEventHead + name + data); }
  };
  const std::uint8_t* view(std::int64_t offset, std::size_t count);
  bool head_at(std::int64_t offset, Head& head);
  bool begins_well(std::int64_t offset, std::int64_t number);
  std::int64_t other_event_inside(std::int64_t offset, const Head& head);
  std::int64_t next_mark(std::int64_t from, std::int64_t to);
  bool event_at(std::int64_t& offset, LogEvent& event, LogDamage& damage);

  struct Part {
    std::string file;
    int fd = -1;
    std::int64_t begin = 0, size = 0;
  };
  void add_part(const std::string& file);
  bool is_part_begin(std::int64_t offset) const;
  const Part* part_at(std::int64_t offset) const;
  bool read(std::int64_t offset, std::size_t count);

  std::vector<Part> parts_;  // none: memory_
  std::span<const std::uint8_t> memory_;
  std::int64_t size_ = 0, offset_ = 0;
  LogDamage damage_;
  std::vector<std::uint8_t> window_;
  std::int64_t window_offset_ = 0;
  std::size_t window_count_ = 0;
};

}  // namespace twinbus::viewer_log
