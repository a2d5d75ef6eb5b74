// Robots of one link that turns about z past the world, for checks of lines.

#pragma once

#include <vector>

#include "planner/batch/robot.h"

namespace twinbus::test {

// origin: of the joint, in the world [m]; limits: to either side [rad].
inline Model turning_link(const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(), double limits = 2.0) {
  Model model;
  model.links.resize(2);
  Joint joint;
  joint.parent = 0;
  joint.child = 1;
  joint.placement.translation() = origin;
  joint.axis = Eigen::Vector3d::UnitZ();
  joint.lower = -limits;
  joint.upper = limits;
  model.joints.push_back(joint);
  model.links[1].parent = 0;
  return model;
}

inline std::vector<Eigen::Vector3d> corners_of_box(const Eigen::Vector3d& middle, const Eigen::Vector3d& half) {
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(middle + half.cwiseProduct(Eigen::Vector3d((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1)));
  return corners;
}

// Two plates, one turning `height` above the other [m]: each in one ball that the other plate is inside of.
inline BlockRobot plates(double height) {
  const Model model = turning_link({0.0, 0.0, height});
  std::vector<BallGroup> groups;
  for (const int link : {0, 1}) {
    groups.push_back({.link = link, .balls = {{Eigen::Vector3d::Zero(), 0.29}},
                      .pieces = {corners_of_box(Eigen::Vector3d::Zero(), {0.2, 0.2, 0.01})}});
  }
  return compile_robot(model, Configuration(model), {0}, groups, {{0, 1}}, 1e-5);
}

}  // namespace twinbus::test
