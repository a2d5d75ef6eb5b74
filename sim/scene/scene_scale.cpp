#include "sim/scene/scene_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/math/index.h"
#include "robot/description/load.h"
#include "robot/description/walking_config.h"
#include "robot/estimation/point_legs.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

namespace {

constexpr double kOfFastest = 0.9;
constexpr double kBetweenSoles = 0.05;  // side by side, at least [m]

double sole_length(const Model& model) {
  return std::min(model.soles[0].front + model.soles[0].back, model.soles[1].front + model.soles[1].back);
}

void scale_steps(Scene& scene, const Model& model, double length) {
  const double least = model.soles[0].right + model.soles[1].left + kBetweenSoles;
  for (TimedSteps& timed : scene.steps) {
    for (int k = 0; k < timed.list.count; ++k) {
      timed.list.x[at(k)] *= static_cast<float>(length);
      const auto y = static_cast<double>(timed.list.y[at(k)]);
      timed.list.y[at(k)] = static_cast<float>(std::copysign(std::max(std::abs(y) * length, least), y));
    }
  }
}

}  // namespace

double leg_length_of(const Model& model) {
  if (stands_on_points(model)) {
    const StandingFeet feet(model);
    const std::optional<FourLegs> legs = four_legs(model, feet);
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
  for (const TimedWalk& walk : scene.walks) most = std::max(most, std::abs(static_cast<double>(walk.command.vx)));
  const double fastest = walking_of(model).fastest;
  if (fastest > 0.0 && most > 0.0) speed = std::min(speed, kOfFastest * fastest / most);
  const double mass = std::min(1.0, model.total_mass() / own.total_mass());
  double support = std::min(1.0, std::sqrt(length));  // four feet stand farther apart than soles are long
  if (!stands_on_points(model)) support = std::min(support, sole_length(model) / sole_length(own) / std::sqrt(length));
  for (TimedWalk& walk : scene.walks) {
    walk.command.vx *= static_cast<float>(speed);
    walk.command.vy *= static_cast<float>(speed);
    walk.command.wz *= static_cast<float>(speed);
  }
  scale_steps(scene, model, length);
  scene.criteria.travel_min_m *= scene.steps.empty() ? speed : length;
  scene.terrain.height *= length;
  for (Push& push : scene.pushes) push.impulse *= mass * support;
  for (double* velocity : {&scene.push_round.forward, &scene.push_round.back, &scene.push_round.sideways}) *velocity *= support;
  for (BodyChange& body : scene.bodies) {
    body.mass *= mass;
    body.at *= length;
  }
  const bool asked = !scene.walks.empty() || !scene.steps.empty() || !scene.pushes.empty() || !scene.bodies.empty() ||
                     scene.push_round.count > 0 || scene.terrain.length > 0.0;
  if (!asked) return;
  char text[200];
  std::snprintf(text, sizeof text, "for a leg of %.2f m, not %.2f, and %.0f kg, not %.0f: speeds x%.2f, lengths x%.2f, impulses x%.2f",
                l, l0, model.total_mass(), own.total_mass(), speed, length, mass * support);
  scene.scaled = text;
}

void scale_to(Scene& scene, const Model& model) {
  if (!(walking_of(model).fastest > 0.0)) return;
  const Model own = load_robot(scene.robot);
  if (own.hash != model.hash) scale_between(scene, own, model);
}

}  // namespace twinbus
