// Puts what is heard into log files, on a thread of its own, so that whoever listens never waits for a disk.
//
// Files end whole: each is readable at any instant up to the last write, a fifth of a second ago.  A disk that is full
// or slow costs messages, which are counted and told; what is written goes on being a log.

#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "viewer_log/log/log_writer.h"

namespace twinbus::inline viewer_log {

struct RecorderConfig {
  std::string
      file;  // the next parts are called file-0002 and so on, before the ending; see log_reader.h
  std::int64_t split_bytes = 0;       // a new part after so much; 0: never
  double split_seconds = 0.0;         // a new part after so long; 0: never
  std::int64_t quota_bytes = 0;       // of all parts: then the oldest is removed; 0: no quota
  double keep_seconds = 0.0;          // the newest so many stay whatever the quota says
  bool goes_on = false;               // after the parts that are there; else they are replaced
  std::int64_t keep_free = 64 << 20;  // left on the disk for others [bytes], at most a tenth of it
};

struct RecorderFigures {
  std::int64_t written = 0;  // messages
  std::int64_t bytes = 0;    // of all parts, also removed ones
  std::int64_t dropped = 0;  // messages, because of the disk
  int parts = 0;
};

class Recorder {
 public:
  // Makes the first file, or the next one.  Throws std::runtime_error naming it.
  explicit Recorder(const RecorderConfig& config);
  // Writes what there is and ends.
  ~Recorder();

  // Takes a copy.  utime must not decrease.  Called by one thread; never waits for the disk.
  void add(std::int64_t utime, std::string_view channel, std::span<const std::uint8_t> data);
  // Written at the head of each part and once a second: what a log needs to explain itself.
  void describe(std::string_view channel, std::vector<std::vector<std::uint8_t>> messages);

  const std::string& first_file() const { return first_file_; }  // that it made
  RecorderFigures figures() const;
  // A sentence when the disk begins to fail, or when it works again; empty when there is nothing new.
  std::string take_news();

 private:
  void go_on();
  void work();
  void write_out(std::vector<std::uint8_t>& events);
  bool room() const;
  void next_part();
  void split_if_full();
  void apply_quota();
  void say(const std::string& sentence);

  const RecorderConfig config_;
  std::string first_file_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  // Shared, under the mutex.
  std::vector<std::uint8_t> pending_;
  std::int64_t pending_count_ = 0;
  std::string description_channel_;
  std::vector<std::vector<std::uint8_t>> description_;
  RecorderFigures figures_;
  std::string news_;
  bool quit_ = false;
  // The thread's own.
  std::unique_ptr<LogWriter> writer_;
  struct Part {
    std::string file;
    std::int64_t bytes;
    std::int64_t utime;  // of its first event
  };
  std::deque<Part>
      parts_;  // closed ones that are still there; the oldest always has the name of the whole
  std::string part_file_;  // of the part that is being written
  int part_ = 0;
  bool failing_ = false, cannot_split_ = false;
  std::int64_t part_utime_ = 0, described_utime_ = 0, newest_utime_ = 0;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace twinbus::viewer_log
