// Whether a robot that stands on several points has the same force at each, in every tick.

#pragma once

#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace twinbus {

class TouchWatch {
 public:
  // Does nothing for a scene that does not ask.
  explicit TouchWatch(const Scene& scene) : asked_(scene.criteria.touch) {}

  // Each tick; time: of the scene [s].
  void add(double time, const World& world);

  bool on() const { return asked_.points > 0; }
  bool begun() const { return begun_; }
  // The most that was seen: relative, how far a point's force was off what was asked, and how many
  // points were missing or too many.
  double off() const { return off_; }
  int wrong_count() const { return wrong_count_; }

 private:
  TouchAsked asked_;
  bool begun_ = false;
  double off_ = 0.0;
  int wrong_count_ = 0;
};

}  // namespace twinbus
