#include "sim/scene/scene_obstacle.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/kinematics/arm_span.h"
#include "robot/kinematics/kinematics.h"
#include "sim/objects/rigid_object_mesh.h"
#include "sim/scene/obstacle_cover.h"
#include "sim/scene/scene_vectors.h"

namespace twinbus::inline sim {

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

constexpr double kTouches = 0.001;  // that an arm may begin in the ground [m]

// An arm on a fixed base and the ground, while it is as the scene starts it.
struct ArmOverGround {
  int link = -1;         // of the arms, that begins lowest
  double low = 1e9;      // its lowest point above the ground [m]
  Eigen::AlignedBox2d stands;  // around what stands on the ground or just above it; empty where nothing does [m]
};

ArmOverGround over_ground(const Scene& scene, const Model& model) {
  constexpr double kStands = 0.03;  // [m]
  ArmOverGround found;
  Kinematics k(model);
  k.update(Configuration(model, scene.start_pose));
  const std::vector<const Hand*> hands = hands_of(model);
  const auto of_arm = [&](int link) {
    return std::any_of(hands.begin(), hands.end(), [&](const Hand* hand) {
      if (hand->joints.empty() || !hangs_on(model, link, hand->joints.front() + 1)) return false;
      return link != hand->joints.front() + 1 || !turns_in_place(k, *hand);
    });
  };
  for (int link = 0; link < model.link_count(); ++link) {
    const bool moves = of_arm(link);
    for (const Shape& shape : model.links[at(link)].collision) {
      std::vector<Eigen::Vector3d> points;
      add_points(shape, points);
      for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d p = k.link_in_world(link) * point;
        if (!moves && p.z() < kStands) found.stands.extend(Eigen::Vector2d(p.head<2>()));
        if (!moves || !(p.z() < found.low)) continue;
        found.low = p.z();
        found.link = link;
      }
    }
  }
  return found;
}

bool is_arm(const Model& model) {
  const bool feet = model.soles[0].link >= 0 || model.soles[1].link >= 0;
  return !model.floating_base && !feet && hand_of(model, 0) != nullptr;
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
  constexpr double kGap = 0.06, kThick = 0.1, kHalf = 5.0, kBeyond = 2.0;  // [m]; a gap as wide as planners keep of what they take for thicker
  if (!is_arm(model)) return;
  const ArmOverGround arm = over_ground(scene, model);
  if (!(arm.low > 0.0)) return;
  const auto add = [&](double from_x, double to_x, double from_y, double to_y) {
    Obstacle floor;
    floor.shape = ObstacleShape::kBox;
    floor.size = {to_x - from_x, to_y - from_y, kThick};
    floor.pose.translation() = Eigen::Vector3d(0.5 * (from_x + to_x), 0.5 * (from_y + to_y), -0.5 * kThick);
    const auto is_it = [&](const Obstacle& o) { return o.size == floor.size && o.pose.isApprox(floor.pose); };
    if (std::none_of(scene.obstacles.begin(), scene.obstacles.end(), is_it)) scene.obstacles.push_back(floor);
  };
  if (!model.plane_joints.empty()) {  // wherever it goes
    const double half = std::max(kHalf, model.joints[at(model.plane_joints.front())].upper + kBeyond);
    return add(-half, half, -half, half);
  }
  if (arm.stands.isEmpty()) return add(-kHalf, kHalf, -kHalf, kHalf);
  const Eigen::Vector2d low = arm.stands.min().array() - kGap, high = arm.stands.max().array() + kGap;
  add(high.x(), kHalf, -kHalf, kHalf);
  add(low.x(), high.x(), high.y(), kHalf);
  add(-kHalf, low.x(), -kHalf, kHalf);
  add(low.x(), high.x(), -kHalf, low.y());
}

std::string begins_in_ground(const Scene& scene, const Model& model) {
  if (!is_arm(model)) return "";
  const ArmOverGround arm = over_ground(scene, model);
  if (arm.low > -kTouches) return "";
  return model.links[at(arm.link)].name + formatted(" of its arm begins %.0f mm", -1e3 * arm.low) +
         " in the ground: begin in another pose (--start-pose, start_pose:), write a half_sitting into its SRDF that is above it, or "
         "put its base on a stand (`check --propose` of its URDF does)";
}

}  // namespace twinbus::sim
