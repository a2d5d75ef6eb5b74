#include "sim/scene/scene_obstacle.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "robot/description/link_points.h"
#include "robot/kinematics/kinematics.h"
#include "sim/contact/rigid_object_mesh.h"
#include "sim/scene/obstacle_cover.h"
#include "sim/scene/scene_vectors.h"

namespace twinbus {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 64 << 20;

fs::path beside_scene(const ConfigNode& node) {
  const fs::path name = node.text("file");
  bool below = name.is_relative() && !name.empty();
  for (const fs::path& part : name) below = below && part != "..";
  if (!below) node.fail("file", "must be a file in the scene's folder or below it");
  return fs::path(node.file()).parent_path() / name;
}

std::string text_of(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw std::runtime_error("cannot read " + path.string());
  if (size > kMostBytes) throw std::runtime_error(path.string() + " is larger than 64 MiB");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<Obstacle> read_covered(const ConfigNode& node, int shape) {
  const double cell = node.number("cell", 0.002, 10.0, 0.05);
  const fs::path file = beside_scene(node);
  const double scale = shape == 0 ? node.number("scale", 1e-6, 1e3, 1.0) : 1.0;
  const double spacing = shape == 2 ? node.number("spacing", 1e-3, 10.0) : 1.0;
  try {
    if (shape == 0)
      return cover_mesh(load_mesh(file.string(), Eigen::Vector3d::Constant(scale)), cell);
    const std::string text = text_of(file);
    if (shape == 1) return cover_points(parse_points(text, file.string()), cell);
    return cover_heights(parse_heights(text, file.string(), spacing), cell);
  } catch (const std::runtime_error& error) {
    node.fail("file", error.what());
  }
}

// The lowest point of what no joint moves, and of what joints do, as the scene starts [m]; 0 where there is nothing.
std::array<double, 2> lowest(const Scene& scene, const Model& model) {
  Kinematics k(model);
  k.update(Configuration(model, scene.start_pose));
  std::array<double, 2> low{0.0, 1e9};
  for (int link = 0; link < model.link_count(); ++link) {
    double& of = low[link == 0 ? 0 : 1];
    for (const Shape& shape : model.links[at(link)].collision) {
      std::vector<Eigen::Vector3d> points;
      add_points(shape, points);
      for (const Eigen::Vector3d& point : points) of = std::min(of, (k.link_in_world(link) * point).z());
    }
  }
  return low;
}

}  // namespace

TriangleMesh read_mesh(const ConfigNode& node) {
  const fs::path file = beside_scene(node);
  const Eigen::Vector3d scale = Eigen::Vector3d::Constant(node.number("scale", 1e-6, 1e3, 1.0));
  try {
    const TriangleMesh mesh = load_mesh(file.string(), scale);
    if (mesh.triangles.size() > kMostContactTriangles) {
      throw std::runtime_error("more than " + std::to_string(kMostContactTriangles) + " triangles");
    }
    return mesh;
  } catch (const std::runtime_error& error) {
    node.fail("file", error.what());
  }
}

void read_obstacle(const ConfigNode& node, std::vector<Obstacle>& obstacles) {
  constexpr int kSimple = 3;
  const int shape = node.choice(
      "shape", {"box", "sphere", "cylinder", "mesh", "points", "height_map"}, 0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = bounded(node, "position", 1000.0, nullptr);
  pose.linear() = rpy(node).toRotationMatrix();
  if (shape >= kSimple) {
    for (Obstacle& box : read_covered(node, shape - kSimple)) {
      box.pose = pose * box.pose;
      obstacles.push_back(box);
    }
    node.finish();
    return;
  }
  Obstacle obstacle;
  obstacle.shape = static_cast<ObstacleShape>(shape + 1);
  const std::size_t numbers[] = {3, 1, 2};
  const std::vector<double> size = node.numbers("size", numbers[shape]);
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (!(size[i] >= 1e-3 && size[i] <= 100.0)) node.fail("size", "must be from 0.001 to 100 m");
    obstacle.size[static_cast<Eigen::Index>(i)] = size[i];
  }
  obstacle.pose = pose;
  node.finish();
  obstacles.push_back(obstacle);
}

void add_floor(Scene& scene, const Model& model) {
  constexpr double kBelow = 0.01, kThick = 0.1, kWide = 10.0;  // [m]
  if (model.floating_base || (model.hands[0].link < 0 && model.hands[1].link < 0)) return;
  const std::array<double, 2> low = lowest(scene, model);
  const double top = low[0] - kBelow;
  if (!(low[1] > top + kBelow)) return;
  Obstacle floor;
  floor.shape = ObstacleShape::kBox;
  floor.size = {kWide, kWide, kThick};
  floor.pose.translation().z() = top - 0.5 * kThick;
  const auto is_it = [&](const Obstacle& o) { return o.size == floor.size && o.pose.isApprox(floor.pose); };
  if (std::none_of(scene.obstacles.begin(), scene.obstacles.end(), is_it)) scene.obstacles.push_back(floor);
}

}  // namespace twinbus
