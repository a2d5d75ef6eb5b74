// Planning problems of ../data/problems and the robot they are for.

#pragma once

#include <string>
#include <vector>

#include "planner/batch/robot.h"
#include "planner/batch/scene.h"
#include "planner/search/rrt_connect.h"

namespace twinbus {

struct PlanningProblem {
  std::string set;
  int number = 0;
  SearchPoint start{}, goal{};
  std::vector<Obstacle> obstacles;  // as they are
  BlockScene as_vamp;               // cylinders taken as VAMP takes them
};

struct ProblemFile {
  std::string robot;
  std::vector<std::string> joints;  // of all configurations
  std::vector<PlanningProblem> problems;
};
// Throws std::runtime_error naming file and line.
ProblemFile read_problems(const std::string& file);

// The links of a URDF that bear collision shapes, fixed ones not merged, and the pairs that the SRDF
// leaves.
struct RobotParts {
  std::vector<std::string> names;
  std::vector<BallGroup> groups;  // balls as the file has them; empty without sphere shapes
  std::vector<std::vector<Shape>> shapes;  // in the frame of the group's link
  std::vector<std::pair<int, int>> pairs;
};
// folder: of the robot, which is a package of its own name.
RobotParts robot_parts(const Model& model, const std::string& urdf_file,
                       const std::string& srdf_file, const std::string& folder);

// The robot of a problem file, from ROBOTS/NAME: NAME.urdf, its shapes or those of NAME_spherized.urdf, and NAME.srdf.
struct ProblemRobot {
  Model model;
  RobotParts parts;
  std::vector<int> planned;  // the joints of the problems
};
ProblemRobot robot_of(const ProblemFile& file, const std::string& robots, bool balls);

// Fills the balls of the groups from the shapes: no triangle sticks out.
void cover_parts(RobotParts& parts);

}  // namespace twinbus
