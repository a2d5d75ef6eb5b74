#include "robot/mjcf/mjcf_selection.h"

#include <algorithm>

#include "common/math/index.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

namespace {

// A body of the world and everything on it.
struct Tree {
  int root = 0;
  std::vector<int> bodies;
  bool floats = false;
  int joints = 0;  // beside the free one
};

std::vector<Tree> trees_of(const MjcfModel& model) {
  std::vector<Tree> trees;
  std::vector<int> tree_of(model.bodies.size(), -1);
  for (int i = 1; i < static_cast<int>(model.bodies.size()); ++i) {
    const MjcfBody& body = model.bodies[at(i)];
    if (body.parent == 0) {
      tree_of[at(i)] = static_cast<int>(trees.size());
      trees.push_back({.root = i, .bodies = {}});
    } else {
      tree_of[at(i)] = tree_of[at(body.parent)];
    }
    Tree& tree = trees[at(tree_of[at(i)])];
    tree.bodies.push_back(i);
    for (const MjcfJoint& joint : body.joints) {
      tree.floats = tree.floats || joint.kind == MjcfJointKind::kFree;
      tree.joints += joint.kind == MjcfJointKind::kFree ? 0 : 1;
    }
  }
  return trees;
}

std::string name_of(const MjcfBody& body) { return body.name.empty() ? "without a name" : body.name; }

}  // namespace

MjcfSelection select_robot(const MjcfModel& model, const std::string& file, std::vector<std::string>& notes) {
  const std::vector<Tree> trees = trees_of(model);
  const Tree* floating = nullptr;
  std::vector<const Tree*> fixed;
  for (const Tree& tree : trees) {
    const MjcfBody& root = model.bodies[at(tree.root)];
    if (tree.floats && tree.joints > 0) {
      if (floating != nullptr) {
        root.element.fail("is a second robot beside body " + name_of(model.bodies[at(floating->root)]) +
                          "; a file has one: take the others out");
      }
      floating = &tree;
    } else if (!tree.floats && tree.joints > 0) {
      fixed.push_back(&tree);
    }
  }
  if (floating != nullptr && !fixed.empty()) {
    model.bodies[at(fixed.front()->root)].element.fail(
        "has joints and hangs on the world, beside the robot " + name_of(model.bodies[at(floating->root)]) +
        " that floats; a file has one robot: take one out");
  }
  if (floating == nullptr && fixed.empty())
    fail_at(file, 1, "no body has a joint other than a free one: this is a scene without a robot");
  MjcfSelection selection;
  selection.floating = floating != nullptr;
  if (floating != nullptr) fixed = {floating};
  for (const Tree* tree : fixed) selection.bodies.insert(selection.bodies.end(), tree->bodies.begin(), tree->bodies.end());
  for (const int i : selection.bodies) {
    for (const MjcfJoint& joint : model.bodies[at(i)].joints) {
      if (joint.kind == MjcfJointKind::kBall) {
        joint.element.fail("a ball joint has three angles in one joint, and the bus carries one number a joint; write three "
                           "hinges with axes 1 0 0, 0 1 0 and 0 0 1 in this body");
      }
    }
  }
  std::string scenery;
  int left_out = 0;
  for (const Tree& tree : trees) {
    if (std::find(selection.bodies.begin(), selection.bodies.end(), tree.root) != selection.bodies.end()) continue;
    if (++left_out <= 5) scenery += (scenery.empty() ? "" : ", ") + name_of(model.bodies[at(tree.root)]);
  }
  if (left_out > 0)
    notes.push_back(std::to_string(left_out) + " bodies are scenery, not the robot, and are left out: " + scenery);
  return selection;
}

}  // namespace twinbus::robot
