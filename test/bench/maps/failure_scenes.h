// Scenes that are made worse until an engine fails: one cell of a map is a few of them.
//
// A cell names its map, the engine and how far its settings go; failure_scenes() makes what is simulated, run_scene() says what
// became of it.  Nothing here judges: bench_maps.py does, for MuJoCo in the same words.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/world/world.h"
#include "test/bench/physics_scenes.h"

namespace twinbus {

struct FailureScene {
  PhysicsScene robot;  // that is looked at, or a bystander
  WorldConfig config;
  bool watch_robot = false;  // its links are what is followed; else the loose bodies
  double duration = 1.0;     // [s]
  double every = 0.0;        // where everything is, is written down so often [s]; 0: never
  double scale = 0.0;        // energy that a gain is compared with [J]; 0: energy is not looked at
  bool conservative = false;  // nothing takes energy: a loss is wrong too
  std::function<bool(const World&)> through;  // something is where it can only get through another
};

// cell: {"map": ..., "engine": articulated1 .. 3, rkf78 or ode, "step": [s], ...}.  Throws std::runtime_error, naming the map or
// the key that is missing.
std::vector<FailureScene> failure_scenes(const nlohmann::json& cell);

// Kinetic and potential, from z = 0 of the world [J].
double energy_of(const LooseBody& body, const LooseState& state);

// What became of it: {"status", "ended", "said_at", "said", "doubts_at", "energy_at", "gain", "through_at", "speed", "upright", "at",
// "cpu"}; doubts_at: first and last time of doubted steps in a row [s].
nlohmann::json run_scene(const FailureScene& scene);

// The scene for MuJoCo, but for the speeds at its start: {"xml", "loose": [velocities], ...}.
nlohmann::json mujoco_scene(const FailureScene& scene);

// A robot of `cell` walks; {"held"}.
nlohmann::json run_walk(const nlohmann::json& cell);

}  // namespace twinbus
