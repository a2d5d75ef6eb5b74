#include "launcher/run/touch_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace twinbus {

void TouchWatch::add(double time, const World& world) {
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

}  // namespace twinbus
