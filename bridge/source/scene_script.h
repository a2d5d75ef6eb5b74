// The requests that belong to a scene: each is said a little before its tick and again, in case one
// is lost, by whatever runs the scene's source.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus::inline bridge {

// A mode takes effect at tick at / period; a velocity or a pad is said again and again while it lasts, as a user's program
// or a pad does: silence ends it.
template <class T>
struct Scripted {
  double at = 0.0, duration = 0.0;  // [s] of scene time: since the source became active
  T request;
};

struct SceneRequests {
  std::vector<Scripted<ModeRequest>> modes;
  std::vector<Scripted<ArmGoal>> goals;
  std::vector<Scripted<WalkCommand>> walks;
  std::vector<Scripted<Gamepad>> pads;
  std::vector<Scripted<StepList>> steps;
  std::vector<Scripted<MotionPiece>> motions;
};

class SceneScript {
 public:
  // period [s]; run_id: of the source the requests are for.
  SceneScript(const SceneRequests& requests, double period, std::int64_t run_id)
      : requests_(requests), period_(period) {
    // Whoever listens takes a lower sequence for an old message.
    std::stable_sort(requests_.modes.begin(), requests_.modes.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    std::int32_t sequence = 0;
    const auto address = [&](auto& list) {
      for (auto& scripted : list) {
        scripted.request.sender_id = scripted.request.run_id = run_id;
        scripted.request.sequence = ++sequence;
      }
    };
    address(requests_.modes);
    address(requests_.goals);
    for (Scripted<ArmGoal>& scripted : requests_.goals) scripted.request.goal_id = scripted.request.sequence;
    address(requests_.steps);
    address(requests_.motions);
    for (Scripted<MotionPiece>& scripted : requests_.motions) scripted.request.motion_id += run_id % kMostRuns * kMostMotions;
    address(requests_.walks);  // numbered when they are said
    address(requests_.pads);
  }

  // After the state of `tick` was answered: calls say() with each request that is due.  first_tick:
  // of the source's activity.
  template <class Say>
  void after(std::int64_t tick, std::int64_t first_tick, Say&& say) {
    if (tick % kEvery != 0) return;
    for (Scripted<ModeRequest>& scripted : requests_.modes) {
      const std::int64_t at = tick_of(scripted.at, first_tick);
      if (tick < at - kAhead || tick >= std::max(at, first_tick + kAhead)) continue;
      scripted.request.at_tick = at;
      say(scripted.request);
    }
    say_once(requests_.goals, tick, first_tick, say);
    say_once(requests_.steps, tick, first_tick, say);
    say_once(requests_.motions, tick, first_tick, say);
    if (tick % kRepeat != 0) return;
    say_on(requests_.walks, tick, first_tick, say);
    say_on(requests_.pads, tick, first_tick, say);
  }

 private:
  std::int64_t tick_of(double at, std::int64_t first_tick) const {
    return first_tick - 1 + std::llround(at / period_);
  }

  template <class Scripted, class Say>
  void say_once(std::vector<Scripted>& list, std::int64_t tick, std::int64_t first_tick, Say&& say) {
    for (Scripted& scripted : list) {
      const std::int64_t at = tick_of(scripted.at, first_tick);
      if (tick >= at && tick < at + kAhead) say(scripted.request);
    }
  }

  template <class Scripted, class Say>
  void say_on(std::vector<Scripted>& list, std::int64_t tick, std::int64_t first_tick, Say&& say) {
    const double time = static_cast<double>(tick - first_tick) * period_;
    for (Scripted& scripted : list) {
      if (!(time >= scripted.at && time < scripted.at + scripted.duration)) continue;
      scripted.request.sequence = ++sequence_;
      say(scripted.request);
    }
  }

  // A motion is played once: each has a number of its own in each run.
  static constexpr std::int64_t kMostMotions = 1000, kMostRuns = std::int64_t{1} << 42;
  static constexpr std::int64_t kAhead = 25;  // [ticks]
  static constexpr std::int64_t kEvery = 5;
  static constexpr std::int64_t kRepeat = 10;  // of velocities and pads [ticks]

  SceneRequests requests_;
  std::int32_t sequence_ = 0;
  double period_;
};

}  // namespace twinbus::bridge
