// A post and an arm that turns beside it: the smallest robot that touches itself.

#pragma once

#include <Eigen/Geometry>

#include "robot/description/model.h"

namespace twinbus {

// A post of 0.1 m, and an arm of 0.3 m that turns about z, 0.3 m beside it.
inline Model post_and_arm() {
  Model model;
  Shape shape;
  shape.size = {0.1, 0.1, 0.1};
  model.links.resize(2);
  model.links[0].collision.push_back(shape);
  shape.size = {0.3, 0.02, 0.02};
  shape.pose.translation() = Eigen::Vector3d(0.15, 0.0, 0.0);
  model.links[1].collision.push_back(shape);
  Joint joint;
  joint.kind = JointKind::kRevolute;
  joint.axis = Eigen::Vector3d::UnitZ();
  joint.placement.translation() = Eigen::Vector3d(-0.3, 0.0, 0.0);
  joint.lower = -2.0;
  joint.upper = 2.0;
  joint.child = 1;
  model.links[1].parent = 0;
  model.joints.push_back(joint);
  return model;
}

}  // namespace twinbus
