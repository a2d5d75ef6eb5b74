// Pairs of links that a robot's own shape keeps near each other: the list `near_pairs` of robot.yaml.  A guard keeps a smaller
// margin of them than of all others.
//
//   near_pairs:
//     - {links: [pelvis, left_hip_roll_link], margin: 0.004}   # [m], where 0.010 is kept of others
//
// Guards that keep less of all, as the guard process does, keep less of these by the same share.

#pragma once

#include <cstddef>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// What is kept of a pair, as a share of what is kept of others.
class MarginShares {
 public:
  explicit MarginShares(const Model& model);
  // Links from link_count on are obstacles: all is kept of them.
  double of(int link_a, int link_b) const noexcept {
    if (least_ >= 1.0 || link_a >= links_ || link_b >= links_) return 1.0;
    return share_[static_cast<std::size_t>(link_a) * static_cast<std::size_t>(links_) + static_cast<std::size_t>(link_b)];
  }
  double least() const noexcept { return least_; }

 private:
  int links_;
  double least_ = 1.0;
  std::vector<double> share_;  // [links x links]; empty when all are alike
};

}  // namespace twinbus::robot
