#include "robot/collision/collision_pairs.h"

#include <algorithm>
#include <cstddef>

#include "robot/collision/loop_joints.h"

namespace twinbus::inline robot {

namespace {

const Link& link_of(const Model& model, int link) {
  return model.links[static_cast<std::size_t>(link)];
}

bool bears_geometry(const Model& model, int link) {
  return !link_of(model, link).collision.empty();
}

int nearest_bearing_ancestor(const Model& model, int link) {
  int ancestor = link_of(model, link).parent;
  while (ancestor >= 0 && !bears_geometry(model, ancestor))
    ancestor = link_of(model, ancestor).parent;
  return ancestor;
}

bool disabled(const Model& model, int a, int b) {
  for (const auto& pair : model.disabled_pairs) {
    if ((pair[0] == a && pair[1] == b) || (pair[0] == b && pair[1] == a)) return true;
  }
  return false;
}

bool joint_moves_link(const Model& model, int joint, int link) { return hangs_on(model, link, joint + 1); }

}  // namespace

bool hangs_on(const Model& model, int link, int on) {
  while (link >= 0 && link != on) link = link_of(model, link).parent;
  return link == on;
}

bool stays_above_ground(const Model& model, int link) {
  if (model.plane_joints.empty() || !hangs_on(model, link, model.plane_joints.back() + 1)) return false;
  const std::vector<const Hand*> hands = hands_of(model);
  return std::none_of(hands.begin(), hands.end(), [&](const Hand* hand) {
    return !hand->joints.empty() && hangs_on(model, link, hand->joints.front() + 1);
  });
}

bool is_ground(const Obstacle& obstacle) noexcept {
  constexpr double kWide = 2.0, kLevel = 1e-3, kThicker = 0.05;  // [m]
  const double middle = obstacle.pose.translation().z();
  return obstacle.shape == ObstacleShape::kBox && obstacle.hand < 0 && obstacle.size.head<2>().maxCoeff() > kWide &&
         obstacle.pose.linear()(2, 2) > 1.0 - 0.5 * kLevel * kLevel && middle < 0.0 &&
         middle + 0.5 * obstacle.size.z() < kThicker;
}

std::vector<CollisionPair> pairs_to_check(const Model& model) {
  const std::vector<PinnedLinks> pins = pinned_links(model);
  const auto pinned = [&](int a, int b) {
    return std::any_of(pins.begin(), pins.end(), [&](const PinnedLinks& pin) {
      return (pin.a == a && pin.b == b) || (pin.a == b && pin.b == a);
    });
  };
  std::vector<CollisionPair> pairs;
  for (int b = 0; b < model.link_count(); ++b) {
    if (!bears_geometry(model, b)) continue;
    for (int a = 0; a < b; ++a) {
      if (!bears_geometry(model, a) || disabled(model, a, b) || pinned(a, b)) continue;
      if (nearest_bearing_ancestor(model, a) == b || nearest_bearing_ancestor(model, b) == a)
        continue;
      pairs.push_back({a, b});
    }
  }
  return pairs;
}

bool joint_moves_pair(const Model& model, int joint, int link_a, int link_b) {
  const bool moves_b = link_b >= 0 && joint_moves_link(model, joint, link_b);
  return joint_moves_link(model, joint, link_a) != moves_b;
}

}  // namespace twinbus::robot
