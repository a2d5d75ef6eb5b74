#include "robot/kinematics/leg_chain.h"

namespace twinbus {

LegChain leg_chain(const Model& model, int foot) noexcept {
  LegChain chain;
  int link = model.soles[static_cast<std::size_t>(foot)].link;
  if (link < 0) return chain;
  std::array<int, 6> back{};
  while (link > 0) {
    if (chain.count == 6) return {};
    const int joint = link - 1;
    if (model.joints[static_cast<std::size_t>(joint)].mimic >= 0) return {};
    back[static_cast<std::size_t>(chain.count++)] = joint;
    link = model.joints[static_cast<std::size_t>(joint)].parent;
  }
  for (int k = 0; k < chain.count; ++k) {
    chain.joint[static_cast<std::size_t>(k)] = back[static_cast<std::size_t>(chain.count - 1 - k)];
  }
  return chain;
}

}  // namespace twinbus
