// Do paths of `bench planner` touch the exact meshes?  By FCL, at 1,000 postures per radian.
//
//   planner_oracle ROBOTS PROBLEMS < PATHS    PATHS as planner_cases and vamp_peer print them
//
// Prints each path that touches, with what and where, and the number of them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>

#include "test/bench/fcl_world.h"

namespace twinbus {
namespace {

constexpr float kPerRadian = 1000.0F;

int run(const std::string& robots, const std::string& file) {
  const ProblemFile asked = read_problems(file);
  const std::vector<PlanningProblem>& problems = asked.problems;
  const ProblemRobot robot = robot_of(asked, robots, false);
  const std::size_t joints = robot.planned.size();
  FclWorld world(robot.model, robot.parts, robot.planned);
  std::string line;
  int paths = 0, touching = 0;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string set;
    int number = 0;
    double skip = 0.0;
    std::size_t points = 0;
    words >> set >> number >> skip >> skip >> skip >> points;
    SearchPath path(points);
    for (SearchPoint& q : path) {
      for (std::size_t j = 0; j < joints; ++j) words >> q[j];
    }
    const auto problem = std::find_if(problems.begin(), problems.end(), [&](const auto& p) {
      return p.set == set && p.number == number;
    });
    if (words.fail() || points < 2 || problem == problems.end()) continue;
    ++paths;
    world.set_obstacles(problem->obstacles);
    bool free = true;
    for (std::size_t i = 0; free && i + 1 < points; ++i) {
      const int steps =
          std::max(1, static_cast<int>(std::ceil(distance(path[i], path[i + 1], static_cast<int>(joints)) * kPerRadian)));
      for (int n = 0; free && n <= steps; ++n) {
        SearchPoint q{};
        for (std::size_t j = 0; j < joints; ++j)
          q[j] = path[i][j] +
                 static_cast<float>(n) / static_cast<float>(steps) * (path[i + 1][j] - path[i][j]);
        std::string who;
        free = world.free(q.data(), &who);
        if (!free)
          std::printf("%s %d line %zu at %d of %d: %s\n", set.c_str(), number, i, n, steps,
                      who.c_str());
      }
    }
    touching += free ? 0 : 1;
  }
  std::printf("paths %d touching %d\n", paths, touching);
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  return twinbus::run(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "planner_oracle: %s\n", error.what());
  return 1;
}
