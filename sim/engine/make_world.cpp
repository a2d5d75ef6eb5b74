#include "sim/engine/make_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sim/engine/articulated_world.h"
#include "sim/engine/ode_world.h"
#include "sim/engine/twinned_world.h"
#include "sim/engine/welded_world.h"
#include "sim/mujoco/mujoco_world.h"

namespace twinbus::inline sim {

namespace {

void check_bodies(const std::vector<LooseBody>& bodies) {
  for (const LooseBody& body : bodies) {
    const double radius = bounding_radius(body.solid);
    if (body.mass > 0.0 && radius > 0.0 && std::isfinite(body.mass + radius)) continue;
    throw std::runtime_error("loose body '" + body.name + "': mass and size must be positive");
  }
}

bool less_is_modelled(const WorldConfig& config) {
  const auto any = [](const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); };
  return any(config.held) || any(config.rigid_robots);
}

}  // namespace

std::unique_ptr<World> make_world(const Model& model, const WorldConfig& config) {
  check_bodies(config.loose);
  if ((config.rolling_friction > 0.0 || config.torsional_friction > 0.0) &&
      (config.engine == Engine::kMujoco || config.contact == ContactModel::kSoft)) {
    throw std::runtime_error(std::string(config.engine == Engine::kMujoco ? "engine mujoco" : "contact soft") +
                             " has no contact.rolling_friction or contact.torsional_friction here; leave them out");
  }
  if (config.local_error > 0.0 && (config.engine != Engine::kArticulated || config.order < 2)) {
    throw std::runtime_error("solver.local_error is of engine articulated at solver.order 2 or 3; leave it out, or set the order");
  }
  if (config.twin) return std::make_unique<TwinnedWorld>(model, config);
  if (less_is_modelled(config)) return std::make_unique<WeldedWorld>(model, config);
  if (config.engine != Engine::kArticulated && (config.asleep || !config.untouched.empty() || !config.aloft.empty())) {
    throw std::runtime_error(std::string(config.asleep ? "asleep" : config.aloft.empty() ? "untouched" : "aloft") +
                             " is of engine articulated only; leave it out, or say --engine articulated");
  }
  if (config.engine == Engine::kMujoco) return std::make_unique<MujocoWorld>(model, config);
  if (config.engine == Engine::kOde && config.continuous) {
    throw std::runtime_error("contact.continuous is of engine articulated only; leave it out, or say --engine articulated");
  }
  if (config.engine == Engine::kOde && config.contact == ContactModel::kSoft)
    throw std::runtime_error("contact soft is not of engine ode; leave it out, or say --engine articulated or --engine mujoco");
  if (config.engine == Engine::kOde) return std::make_unique<OdeWorld>(model, config);
  if (config.contact == ContactModel::kRigid) {
    throw std::runtime_error("contact rigid is of engine ode only; say --engine ode, or engine: ode in the scene");
  }
  return std::make_unique<ArticulatedWorld>(model, config);
}

}  // namespace twinbus::sim
