// Our planner on a file of problems, one line per problem, in the form of peers/vamp_peer.cpp.
//
//   planner_cases as_vamp|certain|planner ROBOTS PROBLEMS ROUNDS
//
// as_vamp: the search with VAMP's balls and looks.  certain: every line proved, without clearance.  planner: what the process
// answers a goal with, a timed motion that keeps clearances; its knots are printed, why there is none goes to stderr.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <set>
#include <string>

#include "common/math/index.h"
#include "planner/arm_planner.h"
#include "planner/search/certain_path.h"
#include "test/oracles/clear_cells.h"
#include "test/bench/planner_problems.h"
#include "test/oracles/sort_pairs.h"

namespace twinbus {
namespace {

double now_us() {
  return std::chrono::duration<double, std::micro>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double middle(std::vector<double>& v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

struct Answer {
  double plan_us = 0.0, shorten_us = 0.0;
  SearchPath path;
};

// VAMP's question: its balls, its obstacles, 32 postures per radian.
Answer as_vamp(JointSearch& search, BlockCheck& check, const PlanningProblem& p) {
  BlockLineTest test(check, 32.0F);
  Answer answer;
  const double t0 = now_us();
  answer.path = search.find(test, p.start, {p.goal});
  const double t1 = now_us();
  if (answer.path.size() > 2) shorten(test, answer.path, check.robot().joints);
  answer.plan_us = t1 - t0;
  answer.shorten_us = now_us() - t1;
  return answer;
}

// Ours: the meshes, the obstacles as they are, every line proved.
Answer certain(JointSearch& search, BlockCheck& check, const PlanningProblem& p) {
  const double t0 = now_us();
  CertainPath found = find_certain(search, check, 32.0F, p.start, {p.goal});
  if (!found.certain) found.path.clear();
  return {.plan_us = now_us() - t0, .shorten_us = 0.0, .path = found.path};
}

ArmGoal goal_of(const Model& model, const std::vector<int>& planned, const SearchPoint& q) {
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  for (std::size_t j = 0; j < planned.size(); ++j) {
    const auto& bus = model.bus_joints;
    const auto k = static_cast<std::size_t>(std::find(bus.begin(), bus.end(), planned[j]) - bus.begin());
    goal.joint_mask |= std::int64_t{1} << k;
    goal.q[k] = static_cast<double>(q[j]);
  }
  return goal;
}

// The planner's process, asked for one goal after another.
int as_process(const std::string& robots, const std::string& file, int rounds) {
  const ProblemFile asked = read_problems(file);
  auto [model, parts, planned] = robot_of(asked, robots, false);
  model.hands[0] = {};
  model.hands[0].link = model.joints[at(planned.back())].child;
  model.hands[0].joints = planned;
  std::set<std::array<int, 2>> kept;
  for (const auto& [a, b] : parts.pairs) {
    const int of[2] = {parts.groups[at(a)].link, parts.groups[at(b)].link};
    kept.insert({std::min(of[0], of[1]), std::max(of[0], of[1])});
  }
  for (int a = 0; a < model.link_count(); ++a) {
    for (int b = a + 1; b < model.link_count(); ++b) {
      if (kept.count({a, b}) == 0) model.disabled_pairs.push_back({a, b});
    }
  }
  ArmPlanner planner(model);
  for (const PlanningProblem& p : asked.problems) {
    planner.set_obstacles(p.obstacles);
    Configuration start(model);
    for (std::size_t j = 0; j < planned.size(); ++j) start.q[planned[j]] = static_cast<double>(p.start[j]);
    const ArmGoal goal = goal_of(model, planned, p.goal);
    std::vector<double> plan_us;
    ArmPlan plan;
    for (int round = 0; round < rounds; ++round) {
      const double t0 = now_us();
      plan = planner.plan(goal, start, Eigen::Isometry3d::Identity(), 1);
      plan_us.push_back(now_us() - t0);
      if (plan.status != ArmPathStatus::kOk) break;
    }
    if (plan.status != ArmPathStatus::kOk) {
      std::fprintf(stderr, "%s %d: %.0f us: %s\n", p.set.c_str(), p.number, plan_us.front(), describe(plan).c_str());
      std::printf("%s %d 0 0 0 0\n", p.set.c_str(), p.number);
      continue;
    }
    std::printf("%s %d %.3f 0 %.6f %zu", p.set.c_str(), p.number, middle(plan_us), plan.duration(), plan.path.size());
    for (const Knot& knot : plan.path) {
      for (int j = 0; j < knot.q.size(); ++j) std::printf(" %.7g", knot.q[j]);
    }
    std::printf("\n");
  }
  return 0;
}

int run(const std::string& mode, const std::string& robots, const std::string& file, int rounds) {
  if (mode == "planner") return as_process(robots, file, rounds);
  const bool proves = mode == "certain";
  const ProblemFile asked = read_problems(file);
  auto [model, parts, planned] = robot_of(asked, robots, !proves);
  if (proves) cover_parts(parts);
  BlockRobot robot = compile_robot(model, Configuration(model), planned, parts.groups, parts.pairs,
                                   proves ? 1e-5 : 0.0);
  sort_pairs(robot);
  if (proves) find_clear_cells(robot);
  JointSearch search({.lower = robot.lower, .upper = robot.upper});
  for (const PlanningProblem& p : asked.problems) {
    const BlockScene scene = proves ? BlockScene(p.obstacles) : p.as_vamp;
    BlockCheck check(robot, scene);
    check.settle_by_pieces(proves);
    check.settle_pairs(proves);
    // What stands still, as a base on its table, is no matter of a path.
    const bool possible = check.point_free(p.start.data()) && check.point_free(p.goal.data());
    if (!possible && !proves) continue;
    std::vector<double> plan_us, shorten_us;
    Answer answer;
    for (int round = 0; possible && round < rounds; ++round) {
      answer = proves ? certain(search, check, p) : as_vamp(search, check, p);
      if (answer.path.empty()) break;
      plan_us.push_back(answer.plan_us);
      shorten_us.push_back(answer.shorten_us);
    }
    if (plan_us.empty()) {
      std::printf("%s %d 0 0 0 0\n", p.set.c_str(), p.number);
      continue;
    }
    std::printf("%s %d %.3f %.3f %.6f %zu", p.set.c_str(), p.number, middle(plan_us),
                middle(shorten_us), static_cast<double>(length_of(answer.path, robot.joints)),
                answer.path.size());
    for (const SearchPoint& q : answer.path) {
      for (std::size_t j = 0; j < planned.size(); ++j) std::printf(" %.7g", static_cast<double>(q[j]));
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  if (argc != 5) return 2;
  return twinbus::run(argv[1], argv[2], argv[3], std::atoi(argv[4]));
} catch (const std::exception& error) {
  std::fprintf(stderr, "planner_cases: %s\n", error.what());
  return 1;
}
