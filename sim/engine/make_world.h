// A simulated world of the engine that its configuration names.

#pragma once

#include <memory>

#include "sim/world/world.h"

namespace twinbus::inline sim {

// The world of config.engine.  The model must outlive it.  Throws std::runtime_error when the model
// cannot be simulated (a massless link, an indefinite inertia), naming it, or when the engine does
// not know the contact asked for.
std::unique_ptr<World> make_world(const Model& model, const WorldConfig& config);

}  // namespace twinbus::sim
