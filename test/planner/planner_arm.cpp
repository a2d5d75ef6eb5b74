// What the planner's process does with an ARM_GOAL: ArmPlanner::plan of hrp1s at the table of the scene reach.
//
//   planner_arm QUESTIONS ROUNDS
//
// Each plan goes on from where the last one ended, to a hand position over the table, drawn; some are out of reach or touch.
// Prints, as planner_humanoid does: questions, plans, median and 99th percentile of the time of a plan [us], a hash of all of
// them (same seed, same hash).

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "common/math/splitmix64.h"
#include "sim/scene/scene.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

std::uint64_t hash_of(std::uint64_t hash, const ArmPlan& plan) {
  for (const Knot& knot : plan.path) {
    for (int j = 0; j < knot.q.size(); ++j) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &knot.q[j], sizeof bits);
      hash = (hash ^ bits) * 1099511628211ULL;
    }
  }
  return hash;
}

int run(int questions, int rounds) {
  const Scene scene = load_scene("reach");
  ArmPlanner planner(hrp1s());
  planner.set_obstacles(scene.obstacles);
  planner.set_balancing(true);
  Configuration start = standing();
  SplitMix64 random(1);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  std::vector<double> us;
  std::uint64_t hash = 14695981039346656037ULL;
  int planned = 0;
  bool same = true;
  for (int i = 0; i < questions; ++i) {
    const ArmGoal goal = hand_to(ArmSide::kLeft, between(0.25, 0.40), between(0.05, 0.50), between(0.80, 1.05));
    std::vector<double> times;
    ArmPlan first;
    for (int round = 0; round < rounds; ++round) {
      const auto begin = std::chrono::steady_clock::now();
      const ArmPlan plan = planner.plan(goal, start, Eigen::Isometry3d::Identity(), static_cast<std::uint64_t>(i + 1));
      times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
      if (round == 0) first = plan;
      same = same && hash_of(0, plan) == hash_of(0, first);
    }
    std::sort(times.begin(), times.end());
    us.push_back(times[times.size() / 2]);
    hash = hash_of(hash, first);
    if (first.status != ArmPathStatus::kOk) continue;
    ++planned;
    for (std::size_t k = 0; k < first.joints.size(); ++k)
      start.q[first.joints[k]] = first.path.back().q[static_cast<int>(k)];
  }
  std::sort(us.begin(), us.end());
  std::printf("hand_goals asked %d planned %d median_us %.1f p99_us %.1f worst_us %.1f same %d hash %016llx\n", questions, planned,
              us[us.size() / 2], us[us.size() * 99 / 100], us.back(), same ? 1 : 0, static_cast<unsigned long long>(hash));
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  return twinbus::run(std::atoi(argv[1]), std::atoi(argv[2]));
} catch (const std::exception& error) {
  std::fprintf(stderr, "planner_arm: %s\n", error.what());
  return 1;
}
