#include "sim/world/felt_feet.h"

#include "common/math/index.h"
#include "robot/collision/collision_pairs.h"
#include "robot/estimation/standing_feet.h"

namespace twinbus::inline sim {

namespace {
constexpr double kToeRoot = 0.01;  // so far beyond its edges a sole carries what hangs on its link [m]

std::vector<int> toes_of(const Model& model, const Sole& sole) {
  std::vector<int> links;
  for (int link = 0; link < model.link_count(); ++link) {
    if (is_toe_of(model, sole, link)) links.push_back(link);
  }
  return links;
}
}  // namespace

bool is_toe_of(const Model& model, const Sole& sole, int link) noexcept {
  return sole.link >= 0 && link > sole.link && hangs_on(model, link, sole.link);
}

bool under_sole(const Sole& sole, const Eigen::Vector3d& center, double radius) noexcept {
  return center.z() - radius < kSoleSkin && center.x() < sole.front + kToeRoot && center.x() > -sole.back - kToeRoot &&
         center.y() < sole.left + kToeRoot && center.y() > -sole.right - kToeRoot;
}

FeltFeet felt_feet(const Model& model) {
  FeltFeet feet;
  for (int side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[at(side)];
    FeltFoot& foot = feet.foot[at(side)] = {.link = sole.link, .side = side, .frame = sole.frame, .sensor = sole.sensor};
    foot.toes = toes_of(model, sole);
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

}  // namespace twinbus::sim
