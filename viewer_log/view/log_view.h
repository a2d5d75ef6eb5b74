// One log as something to look at: what the viewer would have shown at any moment of it.
//
// Knows no messages: a LogFeed decodes them.  After a jump the view is built anew from the seconds before, so that
// rates, ages and what is repeated once a second are there again; the robot stands where its controller believed it was,
// so that two jumps to the same moment show the same.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "robot/description/model.h"
#include "viewer_log/log/log_player.h"
#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

class LogFeed {
 public:
  enum class Kind {
    kOther,
    kState,
    kCommand,
    kGuard,
    kEachTick
  };  // kEachTick: more that comes at every tick
  virtual ~LogFeed() = default;
  // Gives the message in the event to the view; now_ns is the time of the event.
  virtual Kind feed(const LogEvent& event, StackView& view, std::int64_t now_ns) = 0;
  // By its channel only.
  virtual Kind kind_of(const LogEvent& event) const = 0;
};

class LogView {
 public:
  // Throws std::runtime_error naming a log that cannot be read or has no STATE of this robot.  Stands at the first STATE.
  LogView(const Model& model, std::string file, LogFeed& feed);

  void advance(double dt);  // plays on, dt seconds of the log
  // Reads the two seconds before again, however long the log is.
  void seek(double seconds);
  // To the next state or the one before, by = 1 or -1.
  void step(int by);

  const StackView& view() const { return *view_; }
  // From the world of the view, which begins where the log was jumped into, to that of the controller in the log.
  const Eigen::Isometry3d& place() const { return place_; }
  std::int64_t now_ns() const;  // in the time of the log
  double position() const { return player_.position(); }
  double duration() const { return player_.duration(); }
  double first_state() const { return first_state_; }  // [s] from the first event
  bool at_end() const { return player_.at_end(); }
  std::int64_t jumps() const { return jumps_; }  // how often the view was built anew
  std::int64_t first_utime() const { return first_utime_; }
  const std::string& file() const { return file_; }
  const LogDamage& damage() const { return player_.damage(); }

 private:
  void play(double dt);
  void find_first_state();
  void take(const LogEvent& event);
  void find_place();

  const Model* model_;
  std::string file_;
  LogFeed* feed_;
  LogPlayer player_;
  std::optional<StackView> view_;
  Eigen::Isometry3d place_ = Eigen::Isometry3d::Identity();
  std::int64_t first_utime_ = 0, told_ns_ = 0, jumps_ = 0;
  bool counting_ = false;  // of what comes at every tick only the number is of interest yet
  std::int64_t states_ = 0, commands_ = 0, guards_ = 0;
  double first_state_ = 0.0;
};

}  // namespace twinbus::viewer_log
