#include "robot/collision/near_pairs.h"

#include <algorithm>

#include "common/math/index.h"
#include "lcmtypes/msg/guard_defaults.h"

namespace twinbus::inline robot {

MarginShares::MarginShares(const Model& model) : links_(model.link_count()) {
  const auto n = at(links_);
  for (const NearPair& pair : model.near_pairs) {
    if (share_.empty()) share_.assign(n * n, 1.0);
    const double share = pair.margin / GuardDefaults::kInController;
    for (double* of : {&share_[at(pair.link_a) * n + at(pair.link_b)], &share_[at(pair.link_b) * n + at(pair.link_a)]})
      *of = std::min(*of, share);
    least_ = std::min(least_, share);
  }
}

}  // namespace twinbus::robot
