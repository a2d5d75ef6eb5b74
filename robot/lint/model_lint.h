// What is odd in a robot description though it could be loaded: numbers that no body has, limits
// that limit nothing, meshes with holes, and what robot.yaml leaves open.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

struct Suspicion {
  std::string about;   // "link X", "joint Y", "robot.yaml"
  std::string what;    // what is odd, with the number
  std::string remedy;  // what to do
};

// Masses, inertias, centres of mass against the geometry; limits; meshes.
std::vector<Suspicion> find_suspicions(const Model& model);

// What a controller or simulator of a humanoid would miss.
std::vector<Suspicion> find_missing(const Model& model);

// Edges of a closed surface belong to two triangles; this counts the others.  Corners within 1e-6
// of the mesh's size are one.
int open_edges(const std::string& mesh_file);

}  // namespace twinbus::robot
