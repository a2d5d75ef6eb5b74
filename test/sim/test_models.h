// Small robots for tests: a pendulum, a slider, a chain, a free block with soles.

#pragma once

#include <limits>
#include <string>

#include "robot/description/model.h"

namespace twinbus::test {

inline Link make_link(const std::string& name, int parent, double mass, const Eigen::Vector3d& com,
                      const Eigen::Vector3d& inertia) {
  Link link;
  link.name = name;
  link.parent = parent;
  link.mass = mass;
  link.com = com;
  link.inertia = inertia.asDiagonal();
  return link;
}

inline Joint make_joint(const std::string& name, int parent, int child, const Eigen::Vector3d& at,
                        const Eigen::Vector3d& axis, double effort) {
  Joint joint;
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.placement.translation() = at;
  joint.axis = axis;
  joint.lower = -3.0;
  joint.upper = 3.0;
  joint.velocity = 20.0;
  joint.effort = effort;
  joint.kp = 100.0;
  joint.kd = 2.0;
  return joint;
}

// Two soles of 0.2 m under link 0, this far left and right of its middle [m].
inline void put_soles(Model& model, double apart, double half_width, double stiffness, double damping) {
  for (int side = 0; side < 2; ++side) {
    Sole& sole = model.soles[static_cast<std::size_t>(side)];
    sole.link = 0;
    sole.frame.translation() = Eigen::Vector3d(0, side == 0 ? apart : -apart, 0);
    sole.sensor = sole.frame;
    sole.front = sole.back = 0.1;
    sole.left = sole.right = half_width;
    sole.stiffness = stiffness;
    sole.damping = damping;
    sole.friction = 0.8;
  }
}

// A fixed base and one link of mass 2 kg, 0.5 m off a horizontal hinge along y.
inline Model pendulum(double effort = 1000.0) {
  Model model;
  model.name = "pendulum";
  model.floating_base = false;
  model.links = {make_link("base", -1, 1.0, {0, 0, 0}, {0.1, 0.1, 0.1}),
                 make_link("arm", 0, 2.0, {0, 0, -0.5}, {0.02, 0.02, 0.01})};
  model.joints = {make_joint("hinge", 0, 1, {0, 0, 2}, {0, 1, 0}, effort)};
  model.bus_joints = model.bus_index = {0};
  return model;
}

// Inertia of the pendulum's link about its hinge.
// A robot that is far from whatever a test is about.
inline Model bystander() {
  Model model = pendulum();
  model.joints[0].placement.translation() = Eigen::Vector3d(50, 50, 5);
  return model;
}

inline constexpr double kPendulumInertia = 0.02 + 2.0 * 0.5 * 0.5;  // [kg m^2]

inline Model slider(double effort = 1000.0) {
  Model model = pendulum(effort);
  model.joints[0].kind = JointKind::kPrismatic;
  model.joints[0].axis = {0, 0, 1};
  model.joints[0].lower = -0.2;
  model.joints[0].upper = 0.3;
  return model;
}

// n links of 1 kg hanging from a base, hinge axes in turn along y, x, z.
inline Model chain(int n, bool floating) {
  Model model;
  model.name = "chain";
  model.floating_base = floating;
  model.links.push_back(make_link("link0", -1, 3.0, {0.05, 0, 0}, {0.03, 0.04, 0.05}));
  for (int i = 1; i <= n; ++i) {
    const Eigen::Vector3d axis =
        i % 3 == 1 ? Eigen::Vector3d::UnitY()
                   : (i % 3 == 2 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ());
    model.links.push_back(
        make_link("link" + std::to_string(i), i - 1, 1.0, {0.15, 0, 0.02}, {0.002, 0.01, 0.01}));
    model.joints.push_back(
        make_joint("joint" + std::to_string(i), i - 1, i, {0.3, 0, 0}, axis, 1000.0));
    model.bus_joints.push_back(i - 1);
    model.bus_index.push_back(i - 1);
  }
  return model;
}

// One box of 20 kg with two soles of 0.2 x 0.1 m under it, and a light arm so that it has a joint.
inline Model block() {
  Model model = pendulum();
  model.name = "block";
  model.floating_base = true;
  model.links[0] = make_link("block", -1, 20.0, {0, 0, 0.1}, {0.2, 0.2, 0.2});
  Shape box;
  box.size = {0.4, 0.4, 0.2};
  box.pose.translation() = Eigen::Vector3d(0, 0, 0.1);
  model.links[0].collision = {box};
  model.links[1] = make_link("arm", 0, 0.5, {0, 0, 0}, {0.01, 0.01, 0.01});
  model.joints[0].placement.translation() = Eigen::Vector3d(0, 0, 0.2);
  put_soles(model, 0.15, 0.05, 1e5, 500.0);
  return model;
}

}  // namespace twinbus::test
