#include "robot/collision/loop_joints.h"

#include <algorithm>
#include <cstdio>

#include "robot/collision/collision_pairs.h"
#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {

int link_of(const Model& model, const std::string& name) {
  return name == "world" ? -1 : frame_called(model, name, "robot.yaml: loops").link;
}

}  // namespace

std::vector<PinnedLinks> pinned_links(const Model& model) {
  std::vector<PinnedLinks> pins;
  for (const Loop& loop : model.loops) {
    const PinnedLinks pin{link_of(model, loop.link), link_of(model, loop.to)};
    if (loop.length < 0.0) pins.push_back(pin.a < 0 ? PinnedLinks{pin.b, pin.a} : pin);
  }
  return pins;
}

std::vector<int> joints_in_loops(const Model& model) {
  const std::vector<PinnedLinks> pins = pinned_links(model);
  std::vector<int> joints;
  for (int j = 0; j < model.joint_count(); ++j) {
    const bool tied = std::any_of(pins.begin(), pins.end(), [&](const PinnedLinks& pin) {
      return pin.a >= 0 && joint_moves_pair(model, j, pin.a, pin.b);
    });
    if (tied) joints.push_back(j);
  }
  return joints;
}

std::string loops_sentence(const Model& model) {
  const std::vector<int> joints = joints_in_loops(model);
  if (joints.empty()) return "";
  std::string names;
  for (const int j : joints) names += (names.empty() ? "" : ", ") + model.joints[at(j)].name;
  return "closed loops tie " + names +
         ": the simulator knows it; the planner refuses goals for them, and balance, walking and "
         "the guard's look ahead "
         "take them for free";
}

void print_loops(const Model& model, const char* program) {
  const std::string sentence = loops_sentence(model);
  if (!sentence.empty()) std::fprintf(stderr, "%s: %s\n", program, sentence.c_str());
}

}  // namespace twinbus::robot
