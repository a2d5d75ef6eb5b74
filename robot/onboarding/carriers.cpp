#include "robot/onboarding/carriers.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/messages.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/description/urdf.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

namespace {

constexpr double kUpright = 0.9;      // cosine
constexpr double kAboveGround = 0.002;  // of wheels that do not roll [m]

}  // namespace

std::string carried_by_yaml(const Model& model, const Anatomy& anatomy, const Hand& hand) {
  for (const Hand& each : anatomy.hands) {
    if (each.link < 0 || each.joints.empty()) return "";
  }
  const Kinematics k = at_rest(model);
  std::size_t moved = hand.joints.size();
  for (int link = model.joints[at(hand.joints.front())].parent; link > 0; link = model.links[at(link)].parent) {
    const Joint& joint = model.joints[at(link - 1)];
    moved += joint.mimic < 0 ? 1 : 0;
    const bool both = std::all_of(anatomy.hands.begin(), anatomy.hands.end(),
                                  [&](const Hand& each) { return hangs_on(model, each.link, link); });
    if (!both || joint.kind != JointKind::kPrismatic || joint.mimic >= 0) continue;
    if (std::abs(k.axis_in_world(link - 1).z()) < kUpright) continue;
    if (moved > at(kArmJoints)) return "";
    return "    carried_by: [" + joint.name + "]  # moves for a goal that the arm does not reach without\n";
  }
  return "";
}

std::string planar_yaml(const Model& model, const Anatomy& anatomy) {
  const Kinematics k = at_rest(model);
  double low = 1e9;
  for (int link = 0; link < model.link_count(); ++link) {
    const bool of_arm = std::any_of(anatomy.hands.begin(), anatomy.hands.end(), [&](const Hand& hand) {
      return !hand.joints.empty() && hangs_on(model, link, hand.joints.front() + 1);
    });
    if (of_arm) continue;
    for (const Eigen::Vector3d& point : link_points(model.links[at(link)]))
      low = std::min(low, (k.link_in_world(link) * point).z());
  }
  const PlaneBase base;
  return formatted("# It holds its place and goes straight in any direction, as on omnidirectional wheels, so far from where it begins\n"
                   "# [m, m/s, rad/s]; height: of its frame, so that nothing rubs on the ground [m].\n"
                   "planar: {area: %g, speed: %g, turn_speed: %g, height: %.4f}\n",
                   base.area, base.speed, base.turn_speed, std::max(0.0, kAboveGround - low));
}

}  // namespace twinbus::robot
