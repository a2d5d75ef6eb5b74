#include "robot/onboarding/passive_toes.h"

#include <algorithm>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline robot {

namespace {

constexpr double kShare = 0.1, kBent = 0.2;  // of the weight on its tip bends a toe so far [rad]
constexpr double kDamping = 0.05;            // of its stiffness [s]
constexpr double kShortestToe = 0.01;           // [m]

// How far the link behind a joint reaches from its axis [m].
double reach_of(const Model& model, int joint) {
  const Eigen::Vector3d& axis = model.joints[at(joint)].axis;
  double reach = kShortestToe;
  for (const Eigen::Vector3d& point : link_points(model.links[at(joint + 1)]))
    reach = std::max(reach, (point - axis * axis.dot(point)).norm());
  return reach;
}

}  // namespace

std::vector<int> passive_toes(const Model& model) {
  std::vector<int> toes;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    const bool on_foot = std::any_of(model.soles.begin(), model.soles.end(),
                                     [&](const Sole& s) { return s.link >= 0 && hangs_on(model, joint.parent, s.link); });
    if (on_foot && joint.mimic < 0 && !(joint.effort > 0.0)) toes.push_back(j);
  }
  return toes;
}

std::string passive_yaml(const Model& model, const std::vector<int>& toes) {
  if (toes.empty()) return "";
  std::string out = "\n# Toes without a motor: springs guessed from the weight [N m/rad, N m s/rad, rad].\npassive_joints:\n";
  for (const int j : toes) {
    const Joint& joint = model.joints[at(j)];
    const double stiffness = kShare * model.total_mass() * kGravity * reach_of(model, j) / kBent;
    const double damping = joint.damping > 0.0 ? joint.damping : kDamping * stiffness;
    out += "  - {joints: [" + joint.name + formatted("], stiffness: %.3g, damping: %.3g, rest: %.17g}\n", stiffness, damping,
                                                      std::clamp(0.0, joint.lower, joint.upper));
  }
  return out;
}

}  // namespace twinbus::robot
