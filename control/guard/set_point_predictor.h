// What every joint's set-point is and how it would come to rest, as the guard sees it.
//
// A set-point follows its command, at most at the joint's rate.  While a mask holds it, it is braked
// to rest; let go, it fades back to the command as the gate lets it (bridge/blend).  A mask is
// in force some ticks after the look that asked for it.  From a look to rest a joint goes on as it
// does until a brake reaches it, then it loses speed evenly:
//
//     course(t) = first t / delay                                   t <= delay
//                 first + v s - sign(v) brake s^2 / 2               s = min(t - delay, |v| / brake)

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "robot/description/model.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline control {

constexpr std::int64_t kMostLeftOut = 10'000;  // commands or looks in a row [ticks]

// Of one joint, from where it is measured.
struct Course {
  double first = 0.0;  // moved when the brake comes [rad or m]
  double speed = 0.0;  // then [rad/s or m/s]
  double brake = 1.0;  // deceleration [rad/s^2 or m/s^2]

  // share: of the delay that has passed; braked: since the brake came [s].
  double at(double share, double braked) const noexcept {
    const double s = std::min(braked, std::abs(speed) / brake);
    return first * share + speed * s - std::copysign(0.5 * brake * s * s, speed);
  }
  double rest() const noexcept { return first + 0.5 * speed * std::abs(speed) / brake; }
  static constexpr double kLeastWay = 1e-4;  // [rad or m]
  // Ends at a stop that it would pass, braked so much harder; one that is beyond already is none.  low, high: to the stops [rad or m].
  void keep_between(double low, double high) noexcept {
    if (low < 0.0 && first <= low) {
      first = low;
      speed = std::max(speed, 0.0);
    } else if (high > 0.0 && first >= high) {
      first = high;
      speed = std::min(speed, 0.0);
    }
    const double end = rest();
    if (low < 0.0 && end < low) brake = 0.5 * speed * speed / std::max(first - low, kLeastWay);
    if (high > 0.0 && end > high) brake = 0.5 * speed * speed / std::max(high - first, kLeastWay);
  }
};

class SetPointTrack {
 public:
  static constexpr int kMostDelay = 7;  // [ticks]

  // delay_ticks: from a look to the brake that answers it; lag: by which a joint runs on behind its
  // set-point [s].
  SetPointTrack(const Model& model, int delay_ticks, double lag);

  void reset() noexcept;
  // The next command is the first for another source, which took over with the set-points that there were: where that robot stands
  // a little otherwise, set-points that follow the measured joints jump with it, and a jump is no speed.
  void change_source() noexcept { changed_ = true; }
  // One tick: the set-points move on towards command.  mask: bit per joint that the last look held.
  void follow(const RobotState& state, const JointCommand& command, std::int64_t mask) noexcept;

  // Joints that a mask holds or will hold once it arrives, bit per joint of the bus.
  std::int64_t on_hold() const noexcept;
  // From a look until a brake of the next look comes, and the joint with it [s].
  double delay() const noexcept { return delay_; }
  // Joint k of the bus obeys its command until a brake comes.  Those that are held now are let go
  // together and may run after their commands at full rate, but not past where these would stop.
  const Course& if_obeyed(std::size_t k) const noexcept { return obeyed_[k]; }
  // It is held from this look on.
  const Course& if_held(std::size_t k) const noexcept { return held_[k]; }
  // It goes on as it is measured, whatever its set-point is.
  Course if_braked(std::size_t k, double speed) const noexcept {
    return {speed * delay_, speed, brake_[k]};
  }

 private:
  // What is left of the way back to the command, since the fade began.
  struct Fade {
    double q = 0.0, v = 0.0;  // that it began with
    double time = 0.0;        // since then [s]
  };
  void start(const RobotState& state, const JointCommand& command) noexcept;
  void hear(const JointCommand& command, double since) noexcept;
  void hear_first(const RobotState& state, const JointCommand& command) noexcept;
  void move_free(const RobotState& state, double since) noexcept;
  void hold(const RobotState& state, std::int64_t joints) noexcept;
  void move_bound(std::size_t k, double measured) noexcept;
  void look(std::size_t k, double measured) noexcept;
  void go_together(const RobotState& state) noexcept;
  double farthest(std::size_t k) const noexcept;  // that a set-point looks ahead [rad or m]
  Course run_after(std::size_t k, double way) const noexcept;
  // Of what fades, after t more seconds: what is left of the difference, and its rate.
  void faded(std::size_t k, double t, double& q, double& v) const noexcept;

  double period_;  // [s]
  double lag_;     // [s]
  double delay_;   // [s]
  double fade_s_;  // [s]
  std::size_t count_;
  int delay_ticks_;
  bool started_ = false, changed_ = false;
  std::int64_t heard_tick_ = 0, looked_tick_ = 0;  // of the last command and state
  std::array<std::int64_t, kMostDelay> masks_{};  // on their way, the newest first
  PerJoint<double> limit_{};                      // fastest set-point [rad/s or m/s]
  PerJoint<double> brake_{};
  PerJoint<double> way_{};      // left to where the command stops [rad or m]
  PerJoint<double> q_{}, v_{};  // as written [rad or m], [rad/s or m/s]
  PerJoint<double> asked_{}, asked_v_{}, acceleration_{};  // the last command and how it moves
  PerJoint<double> asked_qd_{};             // what it says about that itself: a brake begins there
  std::int64_t held_now_ = 0, fading_ = 0;  // bit per joint
  PerJoint<Fade> fade_{};
  struct {  // where joints are that nothing holds, and their courses
    PerJoint<double> q{}, obeyed{}, obeyed_v{}, held{}, held_v{};
  } free_;
  PerJoint<Course> obeyed_{}, held_{};
};

}  // namespace twinbus::control
