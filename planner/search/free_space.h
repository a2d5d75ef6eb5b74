// What a search in joint space needs to know of the world: which points are free, and which
// straight lines.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline planner {

// Positions of the joints that are planned, never on the heap.
using JointPoint = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kArmJoints, 1>;  // [rad or m]
using JointPath = std::vector<JointPoint>;

class FreeSpace {
 public:
  virtual ~FreeSpace() = default;
  virtual bool point_free(const JointPoint& q) = 0;
  // Every point of the straight line, both ends included.
  virtual bool line_free(const JointPoint& from, const JointPoint& to) = 0;
};

}  // namespace twinbus::planner
