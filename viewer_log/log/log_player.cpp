#include "viewer_log/log/log_player.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace twinbus::inline viewer_log {

namespace {
constexpr std::int64_t kTail = 1 << 20;  // whose events tell when the log ends [bytes]
constexpr double kFarthest = 1e9;        // [s]
constexpr double kRounding_us = 1e-3;    // what a sum of seconds is short of a whole microsecond
}  // namespace

LogPlayer::LogPlayer(const std::string& file) : reader_(file) {
  LogEvent event;
  LogReader tail(file);  // begins anywhere: what it takes for damage is none
  tail.go_to(tail.size() - kTail);
  while (tail.next(event)) last_us_ = std::max(last_us_, event.utime);
  if (!reader_.next(next_))
    throw std::runtime_error("log " + file + ": no event in it; is it an LCM log?");
  has_next_ = true;
  first_us_ = position_us_ = next_.utime;
  last_us_ = std::max(last_us_, first_us_);
}

void LogPlayer::set_speed(double speed) {
  if (speed >= 0.01 && speed <= 100.0) speed_ = speed;
}

void LogPlayer::seek(double seconds) {
  const double bounded = seconds >= 0.0 ? std::min(seconds, kFarthest) : 0.0;  // also for NaN
  position_us_ = std::min<std::int64_t>(first_us_ + std::llround(1e6 * bounded), last_us_);
  reader_.seek(position_us_);
  has_next_ = reader_.next(next_);
  at_end_ = false;
  rest_us_ = 0.0;
}

void LogPlayer::advance(double dt, const std::function<void(const LogEvent&)>& visit) {
  if (paused_ || at_end_ || !(dt > 0.0)) return;
  rest_us_ += 1e6 * dt * speed_;
  const double whole = std::floor(rest_us_ + kRounding_us);
  rest_us_ -= whole;
  position_us_ += static_cast<std::int64_t>(whole);
  while (has_next_ && next_.utime <= position_us_) {
    visit(next_);
    has_next_ = reader_.next(next_);
  }
  if (has_next_) return;
  if (!loop_) {
    at_end_ = true;
    position_us_ = last_us_;
    return;
  }
  ++loops_;
  seek(0.0);
}

}  // namespace twinbus::viewer_log
