// OMPL's RRT-Connect with FCL, on the exact meshes or on VAMP's balls, on every tenth problem of
// `bench planner`.
//
//   ompl_peer meshes|balls ROBOTS PROBLEMS SECONDS ROUNDS RANGE
// prints: set number plan_us simplify_us cost points
//
// 32 states per radian and the longest step RANGE [rad] (0: OMPL's own choice), as in the other planners; its own
// simplifier; SECONDS: limit of a plan.  Its random numbers differ from round to round, by one seed: times and costs
// are medians over the rounds that found a path, and a problem is solved when most did.

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "robot/description/load.h"
#include "test/bench/fcl_world.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using twinbus::PlanningProblem;

namespace {

struct Found {
  std::vector<double> plan_us, simplify_us, cost;
  std::size_t points = 0;
};

double middle(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  const double seconds = std::atof(argv[4]), range = std::atof(argv[6]);
  const int rounds = std::atoi(argv[5]);
  const twinbus::ProblemFile asked = twinbus::read_problems(argv[3]);
  const auto [model, parts, planned] = twinbus::robot_of(asked, argv[2], std::string(argv[1]) == "balls");
  const auto joints = static_cast<unsigned>(planned.size());
  twinbus::FclWorld world(model, parts, planned);
  const auto now = [] {
    return std::chrono::duration<double, std::micro>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  int index = 0;
  for (const PlanningProblem& p : asked.problems) {
    if (index++ % 10 != 0) continue;
    world.set_obstacles(p.obstacles);
    auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
    ob::RealVectorBounds bounds(joints);
    for (unsigned j = 0; j < joints; ++j) {
      bounds.setLow(j, model.joints[static_cast<std::size_t>(planned[j])].lower);
      bounds.setHigh(j, model.joints[static_cast<std::size_t>(planned[j])].upper);
    }
    space->setBounds(bounds);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker([&](const ob::State* s) {
      twinbus::SearchPoint q{};
      for (unsigned j = 0; j < joints; ++j)
        q[j] = static_cast<float>(s->as<ob::RealVectorStateSpace::StateType>()->values[j]);
      return world.free(q.data());
    });
    setup.getSpaceInformation()->setStateValidityCheckingResolution(1.0 / 32.0 /
                                                                    space->getMaximumExtent());
    ob::ScopedState<> start(space), goal(space);
    for (unsigned j = 0; j < joints; ++j) {
      start[j] = static_cast<double>(p.start[j]);
      goal[j] = static_cast<double>(p.goal[j]);
    }
    setup.setStartAndGoalStates(start, goal);
    auto planner = std::make_shared<og::RRTConnect>(setup.getSpaceInformation());
    if (range > 0.0) planner->setRange(range);
    setup.setPlanner(planner);
    setup.setup();
    Found found;
    for (int round = 0; round < rounds; ++round) {
      setup.clear();
      const double t0 = now();
      const bool solved = setup.solve(seconds) == ob::PlannerStatus::EXACT_SOLUTION;
      const double t1 = now();
      if (!solved) continue;
      setup.simplifySolution();
      found.simplify_us.push_back(now() - t1);
      found.plan_us.push_back(t1 - t0);
      found.cost.push_back(setup.getSolutionPath().length());
      found.points = setup.getSolutionPath().getStateCount();
    }
    if (2 * static_cast<int>(found.plan_us.size()) <= rounds) {
      std::printf("%s %d 0 0 0 0\n", p.set.c_str(), p.number);
      continue;
    }
    std::printf("%s %d %.1f %.1f %.6f %zu\n", p.set.c_str(), p.number, middle(found.plan_us),
                middle(found.simplify_us), middle(found.cost), found.points);
    std::fflush(stdout);
  }
}
