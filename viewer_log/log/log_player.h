// A position in a log that moves with time: pause, seek, speed, loop.
//
// Knows no clock: whoever plays says how much time has passed.  Gives the events that were passed, in order.

#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline viewer_log {

class LogPlayer {
 public:
  // Throws std::runtime_error naming a log without events.
  explicit LogPlayer(const std::string& file);

  // Moves on by dt seconds times the speed and gives each event that is passed to visit.  At the end it starts again
  // when it loops, else it stays there.
  void advance(double dt, const std::function<void(const LogEvent&)>& visit);

  void pause(bool paused) { paused_ = paused; }
  bool paused() const { return paused_; }
  void set_speed(double speed);  // 0.01 .. 100
  double speed() const { return speed_; }
  void set_loop(bool loop) { loop_ = loop; }
  // To so many seconds from the beginning; what lies between is not given to anybody.
  void seek(double seconds);

  double position() const { return 1e-6 * static_cast<double>(position_us_ - first_us_); }  // [s]
  double duration() const { return 1e-6 * static_cast<double>(last_us_ - first_us_); }      // [s]
  bool at_end() const { return at_end_; }
  std::int64_t loops() const { return loops_; }
  const LogDamage& damage() const { return reader_.damage(); }

 private:
  LogReader reader_;
  LogEvent next_;
  bool has_next_ = false, paused_ = false, loop_ = false, at_end_ = false;
  double speed_ = 1.0, rest_us_ = 0.0;
  std::int64_t first_us_ = 0, last_us_ = 0, position_us_ = 0, loops_ = 0;
};

}  // namespace twinbus::viewer_log
