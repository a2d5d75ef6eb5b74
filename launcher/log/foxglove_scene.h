// What Foxglove draws in 3D: link frames, shapes of the links, contact forces and obstacles, as JSON of Foxglove's own schemas.
//
//   foxglove.FrameTransforms   world -> every link, at most 50 times a second
//   foxglove.SceneUpdate       shapes of the links (fixed to their frames), obstacles, arrows of contact forces
//
// World is that of the simulator where TRUTH tells it, else that of the controller's estimate.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline launcher {

inline constexpr char kTransformsSchema[] = "foxglove.FrameTransforms";
inline constexpr char kSceneSchema[] = "foxglove.SceneUpdate";
const std::string& transforms_json_schema();
const std::string& scene_json_schema();

class FoxgloveScene {
 public:
  // The model must outlive it.  Triangles of link meshes are read; a mesh that cannot be read is left out.
  explicit FoxgloveScene(const Model& model);

  // Base of the robot in the world.
  void on_truth(const SimTruth& truth, std::int64_t utime);
  void on_status(const ControllerStatus& status, std::int64_t utime);

  // Nothing while it is too early for the next one, or nothing says where the base is.
  std::optional<std::string> transforms(const RobotState& state, std::int64_t utime);
  std::string robot(std::int64_t utime) const;  // once, and again for who joins late
  std::optional<std::string> forces(const SimTruth& truth, std::int64_t utime);
  static std::string obstacles(const ObstaclesPiece& piece, const std::string& name,
                               std::int64_t utime);

 private:
  const Model* model_;
  Kinematics kinematics_;
  Configuration configuration_;
  std::string links_;  // the entities of the robot, but for their times
  bool has_base_ = false;
  std::int64_t truth_utime_ = 0, transforms_utime_ = 0, forces_utime_ = 0;
};

}  // namespace twinbus::launcher
