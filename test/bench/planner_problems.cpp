#include "test/bench/planner_problems.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/collision/links/inscribed_spheres.h"
#include "test/oracles/sphere_cover.h"
#include "robot/description/load.h"
#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

namespace twinbus {

namespace {

std::string read_text(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Obstacle obstacle_from(const std::string& word, std::istringstream& line) {
  Obstacle o;
  std::array<double, 3> size{};
  for (double& v : size) line >> v;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) line >> o.pose.matrix()(r, c);
  }
  o.shape = word == "box"      ? ObstacleShape::kBox
            : word == "sphere" ? ObstacleShape::kSphere
                               : ObstacleShape::kCylinder;
  o.size = Eigen::Vector3d(size[0], size[1], size[2]);
  if (word == "cylinder") o.size = Eigen::Vector3d(size[1], size[0], 0.0);
  return o;
}

}  // namespace

ProblemFile read_problems(const std::string& file) {
  std::istringstream in(read_text(file));
  ProblemFile read;
  std::vector<PlanningProblem>& problems = read.problems;
  std::string text, word;
  for (int number = 1; std::getline(in, text); ++number) {
    std::istringstream line(text);
    if (!(line >> word) || word[0] == '#' || word == "problems" || word == "objects") continue;
    if (word == "robot") {
      line >> read.robot;
    } else if (word == "joints") {
      std::size_t count = 0;
      line >> count;
      if (count < 1 || count > at(kMostPlanned))
        throw std::runtime_error(file + ":" + std::to_string(number) + ": 1 to " + std::to_string(kMostPlanned) + " joints");
      read.joints.resize(count);
      for (std::string& joint : read.joints) line >> joint;
    } else if (word == "problem") {
      problems.emplace_back();
      line >> problems.back().set >> problems.back().number;
    } else if (problems.empty()) {
      throw std::runtime_error(file + ":" + std::to_string(number) + ": no problem before " + word);
    } else if (word == "start" || word == "goal") {
      SearchPoint& q = word == "start" ? problems.back().start : problems.back().goal;
      for (std::size_t j = 0; j < read.joints.size(); ++j) line >> q[j];
    } else if (word == "box" || word == "cylinder" || word == "sphere") {
      problems.back().obstacles.push_back(obstacle_from(word, line));
    } else {
      throw std::runtime_error(file + ":" + std::to_string(number) + ": unknown word " + word);
    }
    if (line.fail())
      throw std::runtime_error(file + ":" + std::to_string(number) + ": a number is missing");
  }
  for (PlanningProblem& p : problems) {
    for (Obstacle o : p.obstacles) {
      if (o.shape == ObstacleShape::kCylinder && p.set != "box") {
        const Eigen::Vector3d half = 0.5 * o.size.y() * o.pose.linear().col(2);
        p.as_vamp.add_capsule(o.pose.translation() + half, o.pose.translation() - half, o.size.x());
        continue;
      }
      if (o.shape == ObstacleShape::kCylinder) {
        o.shape = ObstacleShape::kBox;
        o.size = Eigen::Vector3d(2.0 * o.size.x(), 2.0 * o.size.x(), o.size.y());
      }
      p.as_vamp.add(o);
    }
    p.as_vamp.finish();
  }
  if (read.robot.empty() || read.joints.empty()) throw std::runtime_error(file + ": a line robot NAME and a line joints COUNT NAME... are missing");
  return read;
}

ProblemRobot robot_of(const ProblemFile& file, const std::string& robots, bool balls) {
  const std::string folder = robots + "/" + file.robot, start = folder + "/" + file.robot;
  const std::string urdf = start + ".urdf";
  ProblemRobot robot{.model = load_urdf(urdf, {{file.robot, folder}, {"meshes", folder + "/meshes"}}, false), .parts = {}, .planned = {}};
  robot.parts = robot_parts(robot.model, balls ? start + "_spherized.urdf" : urdf, start + ".srdf", folder);
  for (const std::string& joint : file.joints) {
    robot.planned.push_back(robot.model.find_joint(joint));
    if (robot.planned.back() < 0) throw std::runtime_error(urdf + ": no joint " + joint);
  }
  return robot;
}

RobotParts robot_parts(const Model& model, const std::string& urdf_file,
                       const std::string& srdf_file, const std::string& folder) {
  const std::string name = folder.substr(folder.rfind('/') + 1);
  const AssetRoots roots{.folder = folder, .packages = {{name, folder}, {"meshes", folder + "/meshes"}}};
  const UrdfTree tree = parse_urdf(read_text(urdf_file), urdf_file, roots);
  RobotParts parts;
  for (const Frame& frame : model.frames) {
    const auto link = std::find_if(tree.links.begin(), tree.links.end(),
                                   [&](const UrdfLink& l) { return l.name == frame.name; });
    if (link == tree.links.end() || link->collision.empty()) continue;
    BallGroup group;
    group.link = frame.link;
    std::vector<Shape> shapes = link->collision;
    for (Shape& shape : shapes) {
      shape.pose = frame.in_link * shape.pose;
      if (shape.kind == ShapeKind::kSphere)
        group.balls.push_back({shape.pose.translation(), shape.size.x()});
    }
    parts.names.push_back(frame.name);
    parts.groups.push_back(group);
    parts.shapes.push_back(shapes);
  }
  std::set<std::pair<std::string, std::string>> disabled;
  for (const SrdfPair& pair : parse_srdf(read_text(srdf_file), srdf_file).disabled) {
    disabled.emplace(pair.link_a, pair.link_b);
    disabled.emplace(pair.link_b, pair.link_a);
  }
  for (std::size_t a = 0; a < parts.groups.size(); ++a) {
    for (std::size_t b = a + 1; b < parts.groups.size(); ++b) {
      if (disabled.count({parts.names[a], parts.names[b]}) == 0)
        parts.pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return parts;
}

void cover_parts(RobotParts& parts) {
  for (std::size_t i = 0; i < parts.groups.size(); ++i) {
    LinkGeometry geometry = link_geometry(parts.shapes[i]);
    geometry.link = parts.groups[i].link;
    parts.groups[i] = group_from(geometry);
    parts.groups[i].balls = cover_with_balls(geometry.mesh, geometry.hull);
    parts.groups[i].inner = inner_balls(geometry, 12, 0);
  }
}

}  // namespace twinbus
