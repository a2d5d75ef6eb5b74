#include "robot/collision/near_pairs.h"

#include <algorithm>

#include "common/math/index.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/description/robot_yaml.h"

namespace twinbus {

std::vector<NearPair> near_pairs_of(const Model& model) {
  std::vector<NearPair> pairs;
  for (const NearPairEntry& entry : robot_yaml_of(model).near_pairs) {
    const NearPair pair{frame_called(model, entry.links[0], entry.where).link,
                        frame_called(model, entry.links[1], entry.where).link, entry.margin};
    if (pair.link_a != pair.link_b) pairs.push_back(pair);
  }
  return pairs;
}

MarginShares::MarginShares(const Model& model) : links_(model.link_count()) {
  const auto n = at(links_);
  for (const NearPair& pair : near_pairs_of(model)) {
    if (share_.empty()) share_.assign(n * n, 1.0);
    const double share = pair.margin / GuardDefaults::kInController;
    for (double* of : {&share_[at(pair.link_a) * n + at(pair.link_b)], &share_[at(pair.link_b) * n + at(pair.link_a)]})
      *of = std::min(*of, share);
    least_ = std::min(least_, share);
  }
}

}  // namespace twinbus
