#include "test/oracles/sort_pairs.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/math/index.h"
#include "common/math/splitmix64.h"
#include "planner/batch/check.h"

namespace twinbus {

void sort_pairs(BlockRobot& robot) {
  constexpr int kPostures = 2000;
  const BlockScene empty;
  const std::vector<std::pair<int, int>> pairs = robot.pairs;
  std::vector<std::pair<int, std::size_t>> hits;
  std::vector<std::vector<float>> postures(kPostures);
  SplitMix64 random(3);
  for (std::vector<float>& q : postures) {
    for (int j = 0; j < robot.joints; ++j)
      q.push_back(static_cast<float>(random.uniform(static_cast<double>(robot.lower[at(j)]),
                                                    static_cast<double>(robot.upper[at(j)]))));
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    robot.pairs = {pairs[i]};
    BlockCheck check(robot, empty);
    int touched = 0;
    for (const std::vector<float>& q : postures) touched += check.point_free(q.data()) ? 0 : 1;
    hits.emplace_back(-touched, i);
  }
  std::sort(hits.begin(), hits.end());
  robot.pairs.clear();
  for (const auto& [count, i] : hits) {
    const auto bare = [&](int g) { return robot.groups[at(g)].piece_count == 0; };
    // Balls alone that touch in every posture do so by design: nothing would be free.
    if (-count == kPostures && bare(pairs[i].first) && bare(pairs[i].second)) continue;
    robot.pairs.push_back(pairs[i]);
  }
}

}  // namespace twinbus
