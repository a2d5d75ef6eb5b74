#include "sim/world/felt_feet.h"

#include "common/math/index.h"
#include "robot/estimation/standing_feet.h"

namespace twinbus {

FeltFeet felt_feet(const Model& model) {
  FeltFeet feet;
  for (int side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[at(side)];
    feet.foot[at(side)] = {.link = sole.link, .side = side, .frame = sole.frame, .sensor = sole.sensor};
    if (sole.link >= 0) feet.count = 2;
  }
  if (!model.floating_base) return feet;
  const StandingFeet found(model);
  for (int k = 0; k < found.count() && feet.count < kMaxFeet; ++k) {
    const int link = found.link(k);
    if (link == model.soles[0].link || link == model.soles[1].link) continue;
    FeltFoot& foot = feet.foot[at(feet.count++)] = {.link = link, .radius = found.radius(k)};
    foot.frame.translation() = found.centre(k);
    foot.sensor = foot.frame;
  }
  return feet;
}

}  // namespace twinbus
