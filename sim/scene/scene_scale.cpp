#include "sim/scene/scene_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "robot/description/load.h"
#include "robot/description/walking_config.h"
#include "robot/estimation/point_legs.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline sim {

namespace {

constexpr double kOfFastest = 0.9;
constexpr double kNearHand = 0.1;      // before the centre of mass, in legs: nearer is as good as there
constexpr double kBetweenSoles = 0.05;  // side by side, at least [m]

double sole_length(const Model& model) {
  return std::min(model.soles[0].front + model.soles[0].back, model.soles[1].front + model.soles[1].back);
}

double sole_width(const Model& model) {
  return std::min(model.soles[0].left + model.soles[0].right, model.soles[1].left + model.soles[1].right);
}

Kinematics half_sitting(const Model& model) {
  Kinematics k(model);
  k.update(Configuration(model, "half_sitting"));
  return k;
}

// How far a hand is held before the centre of mass, or behind, in legs.
double held_out(const Model& model, const std::string& hand) {
  const Kinematics k = half_sitting(model);
  const Hand& held = model.hands[hand == "left_hand" ? 0 : 1];
  if (held.link < 0) return kNearHand;
  const Eigen::Vector3d from_com = k.link_in_world(held.link) * held.frame.translation() - k.com();
  return std::max(kNearHand, std::abs(from_com.x()) / leg_length_of(model));
}

// The hand, from the middle between the soles, in half_sitting [m].
Eigen::Vector3d hand_above_soles(const Model& model, const Hand& hand) {
  const Kinematics k = half_sitting(model);
  const auto sole = [&](const Sole& s) -> Eigen::Vector3d { return k.link_in_world(s.link) * s.frame.translation(); };
  return k.link_in_world(hand.link) * hand.frame.translation() - 0.5 * (sole(model.soles[0]) + sole(model.soles[1]));
}

// A body that a hand grips from the start lies in this robot's hand as it lay in that of the robot of the scene, and ends below it.
void lay_in_hands(Scene& scene, const Model& own, const Model& model, double mass) {
  for (const Grasp& grasp : scene.grasps) {
    const std::size_t side = grasp.link == "left_hand" ? 0 : 1;
    if (grasp.at > 0.0 || (side == 1 && grasp.link != "right_hand")) continue;
    if (own.hands[side].link < 0 || model.hands[side].link < 0) continue;
    const Eigen::Vector3d shift = hand_above_soles(model, model.hands[side]) - hand_above_soles(own, own.hands[side]);
    for (LooseBody& body : scene.loose) {
      if (body.name != grasp.to) continue;
      body.start.pose.translation() += shift;
      body.mass *= mass;
    }
    for (LooseEnd& end : scene.criteria.loose) {
      if (end.name == grasp.to) end.position.head<2>() += shift.head<2>();
    }
  }
}

// From the middle between the soles to the outer edge of one, in half_sitting [m].
double half_stance(const Model& model) {
  const Kinematics k = half_sitting(model);
  std::array<double, 2> edge{};
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model.soles[f];
    edge[f] = (k.link_in_world(sole.link) * sole.frame * Eigen::Vector3d(0.0, f == 0 ? sole.left : -sole.right, 0.0)).y();
  }
  return 0.5 * (edge[0] - edge[1]);
}

void scale_steps(Scene& scene, const Model& model, double length) {
  const double least = model.soles[0].right + model.soles[1].left + kBetweenSoles;
  for (TimedSteps& timed : scene.steps) {
    for (int k = 0; k < timed.request.count; ++k) {
      timed.request.x[at(k)] *= static_cast<float>(length);
      const auto y = static_cast<double>(timed.request.y[at(k)]);
      timed.request.y[at(k)] = static_cast<float>(std::copysign(std::max(std::abs(y) * length, least), y));
    }
  }
}

}  // namespace

double leg_length_of(const Model& model) {
  if (stands_on_points(model)) {
    const StandingFeet feet(model);
    const std::optional<PointLegs> legs = point_legs(model, feet);
    return legs ? leg_length(model, legs->front(), feet) : 0.0;
  }
  if (model.soles[0].link < 0 || model.soles[1].link < 0) return 0.0;
  Configuration c(model);
  Kinematics k(model);
  k.update(c);
  int hip = model.soles[0].link;
  while (model.links[at(hip)].parent > 0) hip = model.links[at(hip)].parent;
  const Sole& sole = model.soles[0];
  return k.link_in_world(hip).translation().z() - (k.link_in_world(sole.link) * sole.frame.translation()).z();
}

void scale_between(Scene& scene, const Model& own, const Model& model) {
  const double l0 = leg_length_of(own), l = leg_length_of(model);
  if (!(l0 > 0.0 && l > 0.0)) return;
  const double length = std::min(1.0, l / l0);
  double speed = std::sqrt(length);
  double most = 0.0;
  for (const TimedWalk& walk : scene.walks) most = std::max(most, std::abs(static_cast<double>(walk.request.vx)));
  const double fastest = model.walking.fastest;
  if (fastest > 0.0 && most > 0.0) speed = std::min(speed, kOfFastest * fastest / most);
  const double mass = std::min(1.0, model.total_mass() / own.total_mass());
  const double falls = std::min(1.0, std::sqrt(length));  // four feet stand farther apart than soles are long
  Eigen::Vector3d support(falls, falls, falls);           // forward, sideways, up
  if (!stands_on_points(model)) {
    support.x() = std::min(falls, sole_length(model) / sole_length(own) * std::sqrt(l0 / l));
    support.y() = std::min(support.x(), half_stance(model) / half_stance(own) * std::sqrt(l0 / l));
  }
  const double aside = stands_on_points(model) ? speed : speed * std::min(1.0, sole_width(model) / sole_width(own));
  for (TimedWalk& walk : scene.walks) {
    walk.request.vx *= static_cast<float>(speed);
    walk.request.vy *= static_cast<float>(aside);
    walk.request.wz *= static_cast<float>(aside);
  }
  scale_steps(scene, model, length);
  scene.criteria.travel_min_m *= scene.steps.empty() ? speed : length;
  scene.terrain.height *= length;
  for (Push& push : scene.pushes) push.impulse = mass * push.impulse.cwiseProduct(support);
  for (double* velocity : {&scene.push_round.forward, &scene.push_round.back}) *velocity *= support.x();
  scene.push_round.sideways *= support.y();
  for (TimedMode& timed : scene.modes) {
    const bool sways = timed.request.motion == Motion::kSway;
    timed.request.amplitude *= static_cast<float>(sways ? support.y() : length);
  }
  if (!stands_on_points(model)) lay_in_hands(scene, own, model, mass);
  for (BodyChange& body : scene.bodies) {
    body.mass *= mass;
    if (body.link == "left_hand" || body.link == "right_hand") body.mass *= std::min(1.0, held_out(own, body.link) / held_out(model, body.link));
    body.at *= length;
  }
  const bool asked = !scene.walks.empty() || !scene.steps.empty() || !scene.pushes.empty() || !scene.bodies.empty() ||
                     scene.push_round.count > 0 || !scene.grasps.empty() || scene.terrain.length > 0.0;
  if (!asked) return;
  scene.scaled = formatted("for a leg of %.2f m, not %.2f, and %.0f kg, not %.0f: speeds x%.2f (to the side and turning x%.2f), "
                           "lengths x%.2f, impulses x%.2f, to the side x%.2f",
                           l, l0, model.total_mass(), own.total_mass(), speed, aside, length, mass * support.x(),
                           mass * support.y());
}

void scale_to(Scene& scene, const Model& model) {
  if (!(model.walking.fastest > 0.0)) return;
  const Model own = load_robot(scene.robot);
  if (own.hash != model.hash) scale_between(scene, own, model);
}

}  // namespace twinbus::sim
