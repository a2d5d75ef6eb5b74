// The requests that belong to a scene: each is said a little before its tick and again, in case one
// is lost, by whatever runs the scene's source.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus {

struct ScriptedMode {
  double at = 0.0;  // [s] of active time; takes effect at tick at / period
  ModeRequest request;
};
struct ScriptedGoal {
  double at = 0.0;  // [s] of active time
  ArmGoal goal;
};

// Said again and again while it lasts, as a user's program or a pad does: silence ends it.
struct ScriptedWalk {
  double at = 0.0, duration = 0.0;  // [s] of active time
  WalkCommand request;
};
struct ScriptedPad {
  double at = 0.0, duration = 0.0;  // [s] of active time
  Gamepad request;
};

struct ScriptedSteps {
  double at = 0.0;  // [s] of active time
  StepList request;
};

class SceneScript {
 public:
  // period [s]; run_id: of the source the requests are for.
  SceneScript(const std::vector<ScriptedMode>& modes, const std::vector<ScriptedGoal>& goals,
              double period, std::int64_t run_id, const std::vector<ScriptedWalk>& walks = {},
              const std::vector<ScriptedPad>& pads = {},
              const std::vector<ScriptedSteps>& steps = {})
      : modes_(modes), goals_(goals), walks_(walks), pads_(pads), steps_(steps), period_(period) {
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
    for (ScriptedSteps& scripted : steps_) {
      scripted.request.sender_id = scripted.request.run_id = run_id;
      scripted.request.sequence = ++sequence;
    }
    for (ScriptedWalk& scripted : walks_)
      scripted.request.sender_id = scripted.request.run_id = run_id;
    for (ScriptedPad& scripted : pads_)
      scripted.request.sender_id = scripted.request.run_id = run_id;
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
    for (ScriptedSteps& scripted : steps_) {
      const std::int64_t at = first_tick - 1 + std::llround(scripted.at / period_);
      if (tick >= at && tick < at + kAhead) say(scripted.request);
    }
    if (tick % kRepeat != 0) return;
    say_on(walks_, tick, first_tick, say);
    say_on(pads_, tick, first_tick, say);
  }

 private:
  template <class Scripted, class Say>
  void say_on(std::vector<Scripted>& list, std::int64_t tick, std::int64_t first_tick, Say&& say) {
    const double time = static_cast<double>(tick - first_tick) * period_;
    for (Scripted& scripted : list) {
      if (!(time >= scripted.at && time < scripted.at + scripted.duration)) continue;
      scripted.request.sequence = ++sequence_;
      say(scripted.request);
    }
  }

  static constexpr std::int64_t kAhead = 25;  // [ticks]
  static constexpr std::int64_t kEvery = 5;
  static constexpr std::int64_t kRepeat = 10;  // of velocities and pads [ticks]

  std::vector<ScriptedMode> modes_;
  std::vector<ScriptedGoal> goals_;
  std::vector<ScriptedWalk> walks_;
  std::vector<ScriptedPad> pads_;
  std::vector<ScriptedSteps> steps_;
  std::int32_t sequence_ = 0;
  double period_;
};

}  // namespace twinbus
