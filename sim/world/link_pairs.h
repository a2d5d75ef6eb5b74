// Pairs of links of one robot that never touch: a link and itself, neighbours, and what the SRDF
// says.

#pragma once

#include <vector>

#include "common/math/index.h"
#include "robot/description/model.h"

namespace twinbus::inline sim {

class LinkPairs {
 public:
  LinkPairs() = default;  // none
  explicit LinkPairs(const Model& model) : links_(model.links.size()), part_(links_ * links_, 0) {
    for (int i = 0; i < model.link_count(); ++i) {
      part(i, i);
      if (model.links[at(i)].parent >= 0) part(i, model.links[at(i)].parent);
    }
    for (const auto& [a, b] : model.disabled_pairs) part(a, b);
  }

  bool never_touch(int a, int b) const noexcept { return part_[at(a) * links_ + at(b)] != 0; }

 private:
  void part(int a, int b) { part_[at(a) * links_ + at(b)] = part_[at(b) * links_ + at(a)] = 1; }

  std::size_t links_ = 0;
  std::vector<char> part_;  // [links x links]
};

}  // namespace twinbus::sim
