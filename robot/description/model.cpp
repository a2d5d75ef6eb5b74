#include "robot/description/model.h"

#include <algorithm>
#include <stdexcept>

#include "common/text/closest_name.h"

namespace twinbus::inline robot {

namespace {

template <class Items>
int find_named(const Items& items, const std::string& name) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

double Model::total_mass() const {
  double sum = 0.0;
  for (const Link& link : links) sum += link.mass;
  return sum;
}

int Model::find_joint(const std::string& joint_name) const {
  return find_named(joints, joint_name);
}
int Model::find_link(const std::string& link_name) const { return find_named(links, link_name); }
int Model::find_pose(const std::string& pose_name) const { return find_named(poses, pose_name); }

const Frame& frame_called(const Model& model, const std::string& name, const std::string& where) {
  const auto found = std::find_if(model.frames.begin(), model.frames.end(), [&](const Frame& f) { return f.name == name; });
  if (found == model.frames.end())
    throw std::runtime_error(where + ": there is no link " + name + " in the URDF" + suggestion(name, model.frames));
  return *found;
}

std::vector<const Hand*> hands_of(const Model& model) {
  std::vector<const Hand*> hands;
  for (const Hand& hand : model.hands) {
    if (hand.link >= 0) hands.push_back(&hand);
  }
  for (const Hand& hand : model.more_hands) hands.push_back(&hand);
  return hands;
}

int number_of(const Model& model, const Hand& hand) noexcept {
  for (int side = 0; side < 2; ++side) {
    if (&hand == &model.hands[static_cast<std::size_t>(side)]) return side;
  }
  return static_cast<int>(&hand - model.more_hands.data()) + 2;
}

std::vector<PassiveJoint> passive_joints_of(const Model& model) {
  std::vector<PassiveJoint> passive;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    if (joint.passive) passive.push_back({j, joint.spring, joint.spring_rest});
  }
  return passive;
}

}  // namespace twinbus::robot
