#include "launcher/figures/swing_watch.h"

#include <stdexcept>

#include "common/math/index.h"

namespace twinbus::inline launcher {

SwingWatch::SwingWatch(const Model& model, const Scene& scene, const WorldConfig& world)
    : period_(model.period()) {
  const SwingAsked& asked = scene.criteria.swing;
  if (asked.joint.empty()) return;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("scene " + scene.name + ": criteria: swing: " + why);
  };
  const int joint = model.find_joint(asked.joint);
  if (joint < 0 || model.bus_index[at(joint)] < 0)
    refuse("the robot " + model.name + " has no joint '" + asked.joint + "'");
  if (scene.pushes.size() != 1) refuse("wants one push, after which the robot is let go");
  const int pose = model.find_pose(scene.start_pose);
  const Push& push = scene.pushes.front();
  const int link = model.find_link(push.link);
  if (pose < 0 || link < 0) refuse("no pose " + scene.start_pose + " or no link " + push.link);
  const std::vector<double>& q = model.poses[at(pose)].q;
  const auto swing =
      swing_of(model, world, Eigen::Map<const Eigen::VectorXd>(q.data(), model.joint_count()),
               {.link = link, .point = push.point, .force = push.impulse / push.duration}, joint);
  if (!swing) refuse("in pose " + scene.start_pose + " the robot does not stand or does not swing");
  expected_ = *swing;
  joint_ = model.bus_index[at(joint)];
}

void SwingWatch::add(bool pushed, const RobotState& state) {
  if (!on()) return;
  if (pushed) {
    released_ = true;
    values_.clear();
  } else if (released_) {
    values_.push_back(static_cast<double>(state.tau[at(joint_)]));
  }
}

}  // namespace twinbus::launcher
