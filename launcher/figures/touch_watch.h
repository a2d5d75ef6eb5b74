// Whether a robot that stands on several points has the same force at each, in every tick.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

class TouchWatch {
 public:
  // Does nothing for a scene that does not ask.
  explicit TouchWatch(const Scene& scene) : asked_(scene.criteria.touch) {}

  // Each tick; time: of the scene [s].
  void add(double time, const World& world) {
    if (!on() || !(time >= asked_.from)) return;
    begun_ = true;
    int points = 0;
    for (const ContactPoint& contact : world.contacts()) {
      if (contact.tie) continue;
      ++points;
      const double off = std::abs(contact.force.z() / asked_.force - 1.0);
      if (!std::isnan(off_) && !(off <= off_)) off_ = off;
    }
    wrong_count_ = std::max(wrong_count_, std::abs(points - asked_.points));
  }

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

}  // namespace twinbus::launcher
