// Goes through a whole log in a thread of its own and collects its marks; the page shows what is found so far.
//
// Knows no messages: `take` decodes an event into a MarkFinder.

#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "viewer_log/log/log_event.h"
#include "viewer_log/log/log_marks.h"

namespace twinbus::inline viewer_log {

class MarkScan {
 public:
  MarkScan(std::string file, std::function<void(const LogEvent&, MarkFinder&)> take);
  ~MarkScan();  // ends the scan
  MarkScan(const MarkScan&) = delete;
  MarkScan& operator=(const MarkScan&) = delete;

  double progress() const { return progress_; }  // 0 .. 1
  // True and a copy when there is more than at the last call, or when it is done.
  bool take_news(std::vector<LogMark>& marks, std::int64_t& left_out);

 private:
  void scan();
  void tell(const MarkFinder& finder, double progress);

  std::string file_;
  std::function<void(const LogEvent&, MarkFinder&)> take_;
  std::atomic<bool> ends_{false};
  std::atomic<double> progress_{0.0};
  std::mutex mutex_;  // guards what follows
  std::vector<LogMark> marks_;
  std::int64_t left_out_ = 0;
  bool news_ = false;
  std::thread thread_;
};

}  // namespace twinbus::viewer_log
