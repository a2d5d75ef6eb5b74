#include "sim/scene/scene_places.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "common/math/index.h"
#include "common/text/closest_name.h"
#include "robot/kinematics/kinematics.h"
#include "sim/scene/arm_places.h"

namespace twinbus::inline sim {

namespace {

constexpr double kPitch = 0.7;  // cosine: an axis so nearly to the left bends a leg forward or back

std::vector<int> way_up(const Model& model, int link) {  // from the link to the base
  std::vector<int> way;
  for (; link >= 0; link = model.links[at(link)].parent) way.push_back(link);
  return way;
}

int chest(const Model& model) {
  if (model.hands[0].link < 0 || model.hands[1].link < 0) return 0;
  const std::vector<int> left = way_up(model, model.hands[0].link);
  for (const int link : way_up(model, model.hands[1].link)) {
    if (std::find(left.begin(), left.end(), link) != left.end()) return link;
  }
  return 0;
}

// Called so, of the last if several are.
int head(const Model& model) {
  int found = -1;
  for (const Frame& frame : model.frames) {
    std::string lower = frame.name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (lower.find("head") != std::string::npos && frame.link > 0) found = std::max(found, frame.link);
  }
  return found;
}

// Joints of a leg that bend it forward or back, from the foot up.
std::vector<int> pitch_joints(const Model& model, int foot) {
  if (foot < 0) return {};
  Configuration c(model);
  Kinematics k(model);
  k.update(c);
  std::vector<int> joints;
  for (int link = foot; link > 0; link = model.links[at(link)].parent) {
    if (std::abs(k.axis_in_world(link - 1).y()) > kPitch) joints.push_back(link - 1);
  }
  return joints;
}

}  // namespace

int find_place(const Model& model, const std::string& name) {
  if (const int link = model.find_link(name); link >= 0) return link;
  if (name == "base") return 0;
  if (name == "chest") return chest(model);
  if (name == "head") return head(model);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string which = side == 0 ? "left" : "right";
    if (name == which + "_foot") return model.soles[side].link;
    if (name != which + "_hand") continue;
    return model.hands[side].link >= 0 ? model.hands[side].link : model.hands[1 - side].link;
  }
  return -1;
}

int find_joint_place(const Model& model, const std::string& name) {
  if (const int joint = model.find_joint(name); joint >= 0) return joint;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string which = side == 0 ? "left" : "right";
    const bool ankle = name == which + "_ankle_pitch", knee = name == which + "_knee";
    if (!ankle && !knee) continue;
    const std::vector<int> joints = pitch_joints(model, model.soles[side].link);
    const std::size_t index = ankle ? 0 : 1;
    return index < joints.size() ? joints[index] : -1;
  }
  return -1;
}

void name_places(Scene& scene, const Model& model) {
  measure_by_arm(scene, model);
  const auto link = [&](std::string& name) {
    const int found = name.empty() ? -1 : find_place(model, name);
    if (found >= 0) name = model.links[at(found)].name;
  };
  const auto joint = [&](std::string& name) {
    const int found = name.empty() ? -1 : find_joint_place(model, name);
    if (found >= 0) name = model.joints[at(found)].name;
  };
  for (Push& push : scene.pushes) link(push.link);
  link(scene.push_round.link);
  for (BodyChange& body : scene.bodies) link(body.link);
  for (Grasp& grasp : scene.grasps) {
    link(grasp.link);
    const bool loose = std::any_of(scene.loose.begin(), scene.loose.end(),
                                   [&](const LooseBody& body) { return body.name == grasp.to; });
    if (!loose) link(grasp.to);
  }
  joint(scene.criteria.swing.joint);
  for (JointEnd& end : scene.criteria.joints) joint(end.name);
  for (auto& [name, speed] : scene.start_velocity) joint(name);
  for (TimedGoal& timed : scene.goals) {
    const auto named = std::find_if(model.more_hands.begin(), model.more_hands.end(),
                                    [&](const Hand& other) { return other.name == timed.hand; });
    const bool is_side = timed.hand.empty() || timed.hand == "left" || timed.hand == "right";
    if (!is_side && named == model.more_hands.end()) {
      throw std::runtime_error("scene " + scene.name + ": " + model.name + " has no arm " + timed.hand +
                               suggestion(timed.hand, model.more_hands) + "; say left, right, or a name under hands of its robot.yaml");
    }
    const Hand* hand = is_side ? hand_of(model, number_of(timed.request.side)) : &*named;
    if (hand == nullptr) continue;
    timed.request.side = static_cast<ArmSide>(number_of(model, *hand) + 1);
    if (!timed.of_reach || hand->joints.empty()) continue;
    const ArmSpan arm = arm_in_scene(scene, model, *hand);
    const Eigen::Vector3d position = arm.shoulder + arm.length * timed.reach;
    for (int i = 0; i < 3; ++i) timed.request.position[at(i)] = position[i];
  }
  if (model.floating_base) return;
  for (TimedMode& timed : scene.modes) {
    if (timed.request.mode == Mode::kBalance) timed.request.mode = Mode::kHold;
  }
}

}  // namespace twinbus::sim
