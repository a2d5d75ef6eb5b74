#include "viewer_log/log/mark_scan.h"

#include <exception>
#include <utility>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline viewer_log {

namespace {
constexpr std::int64_t kTellEvery = 64 << 20;  // [bytes]
constexpr std::int64_t kTellFirst = 1 << 20;
}  // namespace

MarkScan::MarkScan(std::string file, std::function<void(const LogEvent&, MarkFinder&)> take)
    : file_(std::move(file)), take_(std::move(take)), thread_([this] { scan(); }) {}

MarkScan::~MarkScan() {
  ends_ = true;
  thread_.join();
}

void MarkScan::tell(const MarkFinder& finder, double progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  news_ = news_ || finder.marks().size() != marks_.size() || progress >= 1.0;
  marks_ = finder.marks();
  left_out_ = finder.left_out();
  progress_ = progress;
}

bool MarkScan::take_news(std::vector<LogMark>& marks, std::int64_t& left_out) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::exchange(news_, false)) return false;
  marks = marks_;
  left_out = left_out_;
  return true;
}

void MarkScan::scan() {
  try {
    LogReader reader(file_);
    LogEvent event;
    if (!reader.next(event)) return;
    MarkFinder finder(event.utime);
    std::int64_t next = kTellFirst;
    do {
      take_(event, finder);
      if (reader.offset() < next) continue;
      next = reader.offset() + kTellEvery;
      tell(finder, static_cast<double>(reader.offset()) / static_cast<double>(reader.size() + 1));
    } while (!ends_ && reader.next(event));
    if (!ends_) tell(finder, 1.0);
  } catch (const std::exception&) {
    progress_ = 1.0;  // the file is gone: what is shown will say so
  }
}

}  // namespace twinbus::viewer_log
