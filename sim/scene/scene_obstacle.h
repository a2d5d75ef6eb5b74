// The obstacles of a scene file, and triangles from files beside it.

#pragma once

#include <vector>

#include "common/text/strict_yaml.h"
#include "geometry/mesh/mesh_file.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// `file` and `scale` of a map: a mesh beside the scene.
TriangleMesh read_mesh(const ConfigNode& node);

// One obstacle: [shape (box, sphere, cylinder), size, position, rpy_deg], or [shape (mesh, points, height_map), file,
// scale (of a mesh) or spacing (of a height map), cell, position, rpy_deg], which becomes boxes.
void read_obstacle(const ConfigNode& node, std::vector<Obstacle>& obstacles);

// The ground below an arm on a fixed base, which planner and guard know as obstacles, once: boxes around what stands on it; none where
// the arm begins lower, nor for a robot with a free base, feet, or no hand.
void add_floor(Scene& scene, const Model& model);
// Which link of such an arm begins in the ground, how deep, and what helps; empty when none does.
std::string begins_in_ground(const Scene& scene, const Model& model);

}  // namespace twinbus::sim
