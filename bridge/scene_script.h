// The requests that belong to a scene: each is said a little before its tick and again, in case one
// is lost, by whatever runs the scene's source.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robot/requests.h"

namespace twinbus {

struct ScriptedMode {
  double at = 0.0;  // [s] of active time; takes effect at tick at / period
  ModeRequest request;
};
struct ScriptedGoal {
  double at = 0.0;  // [s] of active time
  ArmGoal goal;
};

class SceneScript {
 public:
  // period [s]; run_id: of the source the requests are for.
  SceneScript(const std::vector<ScriptedMode>& modes, const std::vector<ScriptedGoal>& goals,
              double period, std::int64_t run_id)
      : modes_(modes), goals_(goals), period_(period) {
    // Whoever listens takes a lower sequence for an old message.
    std::stable_sort(modes_.begin(), modes_.end(),
                     [](const ScriptedMode& a, const ScriptedMode& b) { return a.at < b.at; });
    std::int32_t sequence = 0;
    for (ScriptedMode& scripted : modes_) {
      scripted.request.sender_id = scripted.request.run_id = run_id;
      scripted.request.sequence = ++sequence;
    }
    for (ScriptedGoal& scripted : goals_) {
      scripted.goal.sender_id = scripted.goal.run_id = run_id;
      scripted.goal.goal_id = scripted.goal.sequence = ++sequence;
    }
  }

  // After the state of `tick` was answered: calls say() with each request that is due.  first_tick:
  // of the source's activity.
  template <class Say>
  void after(std::int64_t tick, std::int64_t first_tick, Say&& say) {
    if (tick % kEvery != 0) return;
    for (ScriptedMode& scripted : modes_) {
      const std::int64_t at = first_tick - 1 + std::llround(scripted.at / period_);
      if (tick < at - kAhead || tick >= std::max(at, first_tick + kAhead)) continue;
      scripted.request.at_tick = at;
      say(scripted.request);
    }
    for (ScriptedGoal& scripted : goals_) {
      const std::int64_t at = first_tick - 1 + std::llround(scripted.at / period_);
      if (tick >= at && tick < at + kAhead) say(scripted.goal);
    }
  }

 private:
  static constexpr std::int64_t kAhead = 25;  // [ticks]
  static constexpr std::int64_t kEvery = 5;

  std::vector<ScriptedMode> modes_;
  std::vector<ScriptedGoal> goals_;
  double period_;
};

}  // namespace twinbus
