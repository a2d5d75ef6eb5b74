// Two plates, one turning `height` above the other [m]: each in one ball that the other plate is inside of.

#pragma once

#include <vector>

#include "planner/batch/robot.h"

namespace twinbus::test {

inline BlockRobot plates(double height) {
  Model model;
  model.links.resize(2);
  Joint joint;
  joint.child = 1;
  joint.placement.translation() = Eigen::Vector3d(0.0, 0.0, height);
  joint.axis = Eigen::Vector3d::UnitZ();
  joint.lower = -2.0;
  joint.upper = 2.0;
  model.joints.push_back(joint);
  model.links[1].parent = 0;
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back((k & 1) != 0 ? 0.2 : -0.2, (k & 2) != 0 ? 0.2 : -0.2, (k & 4) != 0 ? 0.01 : -0.01);
  std::vector<BallGroup> groups;
  for (const int link : {0, 1}) groups.push_back({.link = link, .balls = {{Eigen::Vector3d::Zero(), 0.29}}, .pieces = {corners}});
  return compile_robot(model, Configuration(model), {0}, groups, {{0, 1}}, 1e-5);
}

}  // namespace twinbus::test
