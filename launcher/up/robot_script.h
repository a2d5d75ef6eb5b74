// What a scene asks of the robot, said by the launcher where a robot is the first source: a simulator says it itself.

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "bridge/source/scene_script.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline launcher {

class RobotScript {
 public:
  // The scene begins with the tick first_tick.  period [s].
  void begin(const SceneRequests& requests, double period, std::int64_t first_tick) {
    script_.emplace(requests, period, 0);
    first_tick_ = next_ = first_tick;
    base_ += kMostSequences;
  }

  void end() { script_.reset(); }

  // With every newest STATE: send(request) with each request that has become due.  A launcher hears a state in ten: what
  // was due at a tick between is said now.
  template <class Send>
  void hear(const RobotState& state, Send&& send) {
    if (!script_) return;
    for (next_ = std::max(next_, state.tick - kMostCaughtUp); next_ <= state.tick; ++next_) {
      script_->after(next_, first_tick_, [&](const auto& due) {
        auto request = due;
        request.run_id = state.run_id;  // whoever is the source by now
        request.sequence += base_;      // larger than those of a scene before
        if constexpr (requires { request.motion_id; }) request.motion_id += base_;
        if constexpr (requires { request.goal_id; }) request.goal_id += base_;  // a planner obeys a number once
        send(request);
      });
    }
  }

 private:
  static constexpr std::int64_t kMostCaughtUp = 500;  // [ticks]
  static constexpr std::int32_t kMostSequences = 1'000'000;

  std::optional<SceneScript> script_;
  std::int64_t first_tick_ = 0, next_ = 0;
  std::int32_t base_ = 0;
};

}  // namespace twinbus::launcher
