// A simulated world as MuJoCo reads it: `twinbus export` writes it into a file, engine mujoco simulates it.

#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/mjcf/model_writer.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// For whom it is written.
enum class MjcfUse {
  kExport,  // people: shapes to look at, position servos, the keyframe `start`
  kEngine,  // no servos and no damping of joints (mujoco_world.h has them); links touch one another if the world says so
};

struct MjcfWorld {
  std::string xml;
  std::map<std::string, MjcfText::Geom> geoms;  // of the robot
  std::string unbalanced;  // links whose moments of inertia no body has: MuJoCo takes their mean
};

// Of what stands fixed.
std::vector<Shape> shapes_of(const std::vector<Obstacle>& obstacles);

// Name of the free joint of a loose body.
std::string mjcf_loose_joint(std::size_t body);

// model: as it is to be simulated, start: of it.  Loose meshes, further robots and ties are left out.
MjcfWorld mjcf_of_world(const std::string& name, const Model& model, const WorldConfig& config, const Configuration& start,
                        MjcfUse use, ExportedMeshes& meshes);

}  // namespace twinbus::sim
