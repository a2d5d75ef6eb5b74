#include "robot/kinematics/leg_chain.h"

#include <algorithm>

#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {

LegChain up_to_base(const Model& model, int foot) noexcept {
  LegChain chain;
  int link = model.soles[at(foot)].link;
  if (link < 0) return chain;
  while (link > 0) {
    if (at(chain.count) == chain.joint.size()) return {};
    const int joint = link - 1;
    if (model.joints[at(joint)].mimic >= 0) return {};
    chain.joint[at(chain.count++)] = joint;
    link = model.joints[at(joint)].parent;
  }
  std::reverse(chain.joint.begin(), chain.joint.begin() + chain.count);
  return chain;
}

}  // namespace

LegChain leg_chain(const Model& model, int foot) noexcept {
  const LegChain chain = up_to_base(model, foot), other = up_to_base(model, 1 - foot);
  return chain.count > 0 && other.count > 0 && chain.joint[0] == other.joint[0] ? LegChain{} : chain;
}

}  // namespace twinbus::robot
