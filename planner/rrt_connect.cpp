#include "planner/rrt_connect.h"

#include <algorithm>
#include <cstddef>

namespace twinbus {

namespace {

struct Node {
  JointPoint q;
  int parent;
};

using Tree = std::vector<Node>;

enum class Growth { kTrapped, kAdvanced, kReached };

int nearest(const Tree& tree, const JointPoint& q) {
  int best = 0;
  double best_distance = (tree[0].q - q).squaredNorm();
  for (std::size_t i = 1; i < tree.size(); ++i) {
    const double distance = (tree[i].q - q).squaredNorm();
    if (distance < best_distance) {
      best = static_cast<int>(i);
      best_distance = distance;
    }
  }
  return best;
}

// One edge of at most `step` from node `from` towards q; `from` becomes the new node.
Growth extend(FreeSpace& space, Tree& tree, const JointPoint& q, double step, int& from) {
  const JointPoint& start = tree[static_cast<std::size_t>(from)].q;
  const double distance = (q - start).norm();
  const bool reaches = !(distance > step);
  const JointPoint next = reaches ? q : JointPoint(start + step / distance * (q - start));
  if (!space.line_free(start, next)) return Growth::kTrapped;
  tree.push_back({next, from});
  from = static_cast<int>(tree.size()) - 1;
  return reaches ? Growth::kReached : Growth::kAdvanced;
}

Growth connect(FreeSpace& space, Tree& tree, const JointPoint& q, double step, int& from) {
  Growth growth = Growth::kAdvanced;
  while (growth == Growth::kAdvanced) growth = extend(space, tree, q, step, from);
  return growth;
}

JointPath to_root(const Tree& tree, int node) {
  JointPath path;
  for (; node >= 0; node = tree[static_cast<std::size_t>(node)].parent) {
    path.push_back(tree[static_cast<std::size_t>(node)].q);
  }
  return path;
}

JointPath join(const Tree& from_start, int a, const Tree& from_goals, int b) {
  JointPath path = to_root(from_start, a);
  std::reverse(path.begin(), path.end());
  const JointPath rest = to_root(from_goals, b);
  path.insert(path.end(), rest.begin() + 1, rest.end());  // the meeting point is in both
  return path;
}

}  // namespace

RrtResult rrt_connect(FreeSpace& space, const JointPoint& start, const JointPath& goals,
                      const RrtLimits& limits, Random& random, bool (*keep_on)(void*), void* user) {
  RrtResult result;
  if (goals.empty()) return result;
  for (const JointPoint& goal : goals) {  // most goals are in sight
    if (!space.line_free(start, goal)) continue;
    result.found = true;
    result.path = {start, goal};
    return result;
  }

  Tree start_tree{{start, -1}};
  Tree goal_tree;
  for (const JointPoint& goal : goals) goal_tree.push_back({goal, -1});
  bool from_start = true;  // which tree grows into the unknown this round
  while (result.rounds < limits.max_rounds && (keep_on == nullptr || keep_on(user))) {
    ++result.rounds;
    Tree& growing = from_start ? start_tree : goal_tree;
    Tree& other = from_start ? goal_tree : start_tree;
    JointPoint sample = limits.lower;
    for (int k = 0; k < sample.size(); ++k)
      sample[k] = random.uniform(limits.lower[k], limits.upper[k]);

    int tip = nearest(growing, sample);
    if (extend(space, growing, sample, limits.step, tip) != Growth::kTrapped) {
      const JointPoint target = growing[static_cast<std::size_t>(tip)].q;
      int other_tip = nearest(other, target);
      if (connect(space, other, target, limits.step, other_tip) == Growth::kReached) {
        result.found = true;
        result.path = from_start ? join(start_tree, tip, goal_tree, other_tip)
                                 : join(start_tree, other_tip, goal_tree, tip);
        return result;
      }
    }
    from_start = !from_start;
  }
  return result;
}

}  // namespace twinbus
