// What the seed of a run decides about its scene: the tiles of uneven ground, when and where a round of pushes comes,
// and how far a scene with a disturbance starts from what it says.
//
// The noise of the sensors has the same seed and is the simulator's business (sensor.seed).

#pragma once

#include <cstdint>

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// Fills tiles from terrain, adds the pushes of push_round, draws the disturbance; the same seed, the same scene.  Throws std::runtime_error
// naming a link that the robot does not have.
void apply_seed(Scene& scene, const Model& model, std::uint64_t seed);

// Whether another seed makes another scene of it; noise of the sensors is not asked for here.
bool draws_from_seed(const Scene& scene);
// Whether it has a disturbance.
bool is_disturbed(const Scene& scene);
// For scenes that ask for no disturbance of their own: one that whoever is robust does not mind.  What is loose stays as high and as
// upright as it was.
Disturbance small_disturbance();

// The robot as the scene's bodies change it.  Throws std::runtime_error naming a link that it does not have.
Model changed_model(const Model& model, const Scene& scene);

}  // namespace twinbus::sim
