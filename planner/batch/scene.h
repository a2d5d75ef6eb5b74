// Obstacles compiled for checks of 8 postures at a time: shapes, and the boxes around them as arrays
// so that 8 obstacles are turned away per comparison.

#pragma once

#include <vector>

#include "robot/collision/collision.h"

namespace twinbus::inline planner {

struct BlockShape {
  enum class Kind { kBox, kCapsule, kCylinder, kSphere };
  Kind kind = Kind::kSphere;
  float center[3] = {};   // capsule: one end [m]
  float axis[3][3] = {};  // box: unit axes; cylinder: axis[2]; capsule: axis[0] from end to end [m]
  float half[3] = {};     // box: half edges; cylinder: radius, -, half length; else radius [m]
  bool upright = false;   // box: axis[2] is the world's z
  float inverse = 0.0F;   // capsule: 1 / length^2
};

class BlockScene {
 public:
  BlockScene() { finish(); }
  // In the world of the robot's posture; what is not a shape of positive size, or is held, is left out.
  explicit BlockScene(const std::vector<Obstacle>& obstacles);
  // A cylinder with round ends, as some planners take cylinders.
  void add_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);
  void add(const Obstacle& obstacle);
  void finish();  // after the last one

  std::vector<BlockShape> shapes;
  std::vector<int> shape_of;  // of each obstacle that it was made of; -1: it was left out
  std::vector<float> low[3], high[3];  // filled up to a multiple of 8 with boxes that hold nothing
};

}  // namespace twinbus::planner
