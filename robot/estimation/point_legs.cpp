#include "robot/estimation/point_legs.h"

#include <algorithm>

#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

namespace {
constexpr std::size_t kLeastJoints = 3;
constexpr std::size_t kMostOfTwo = 4;  // of two legs: more joints turn a foot, which then is a sole
}  // namespace

bool stands_on_points(const Model& model) noexcept {
  return model.floating_base && model.soles[0].link < 0 && model.soles[1].link < 0;
}

std::optional<PointLegs> point_legs(const Model& model, const StandingFeet& feet, const char** why) {
  const auto refuse = [&](const char* sentence) {
    if (why != nullptr) *why = sentence;
    return std::nullopt;
  };
  if (!model.floating_base) return refuse("its base is fixed");
  if (feet.count() != 2 && feet.count() != 4) return refuse("it has neither two soles nor two or four point feet");
  PointLegs legs;
  std::vector<bool> used(model.joints.size(), false);
  for (int foot = 0; foot < feet.count(); ++foot) {
    PointLeg leg{foot, feet.link(foot), {}};
    for (const int joint : feet.chain(foot)) {
      if (used[at(joint)]) return refuse("its feet do not each hang on the base by joints of their own");
      used[at(joint)] = true;
      if (model.bus_index[at(joint)] >= 0) leg.joints.insert(leg.joints.begin(), joint);
    }
    if (leg.joints.size() < kLeastJoints) return refuse("a leg has fewer than three joints that are driven");
    if (feet.count() == 2 && leg.joints.size() > kMostOfTwo)
      return refuse("its two legs can turn their feet, and robot.yaml names no soles");
    legs.push_back(leg);
  }
  Configuration c(model);
  for (int j = 0; j < model.joint_count(); ++j) c.q[j] = std::clamp(0.0, model.joints[at(j)].lower, model.joints[at(j)].upper);
  Kinematics k(model);
  k.update(c);
  const auto root = [&](const PointLeg& leg) { return k.link_in_world(leg.joints.front() + 1).translation(); };
  const auto side = [&](const PointLeg& leg) { return k.link_in_world(leg.link).translation().y(); };
  const bool four = legs.size() == 4;
  if (four) std::sort(legs.begin(), legs.end(), [&](const PointLeg& a, const PointLeg& b) { return root(a).x() > root(b).x(); });
  for (std::size_t pair = 0; pair < legs.size(); pair += 2) {
    if (side(legs[pair]) < side(legs[pair + 1])) std::swap(legs[pair], legs[pair + 1]);
    if (!(side(legs[pair]) > side(legs[pair + 1]))) return refuse("its feet are not left and right of each other");
  }
  const auto before = [&](std::size_t a, std::size_t b) { return root(legs[a]).x() > root(legs[b]).x(); };
  if (four && !(before(1, 2) && before(1, 3) && before(0, 2)))
    return refuse("its legs are not two before and two behind");
  return legs;
}

double leg_length(const Model& model, const PointLeg& leg, const StandingFeet& feet) {
  Configuration c(model);
  Kinematics k(model);
  k.update(c);
  StandingFeet placed = feet;
  placed.place(k, Eigen::Matrix3d::Identity());
  double length = 0.0;
  for (std::size_t i = 1; i < leg.joints.size(); ++i) {
    const Eigen::Vector3d here = k.link_in_world(leg.joints[i] + 1).translation();
    const Eigen::Vector3d next = i + 1 < leg.joints.size() ? Eigen::Vector3d(k.link_in_world(leg.joints[i + 1] + 1).translation())
                                                           : placed.point(leg.foot);
    // Sideways offsets between a thigh and its knee do not lengthen the leg.
    const Eigen::Vector3d axis = k.axis_in_world(leg.joints[i]);
    const Eigen::Vector3d way = next - here;
    length += (way - axis * axis.dot(way)).norm();
  }
  return length;
}

}  // namespace twinbus::robot
