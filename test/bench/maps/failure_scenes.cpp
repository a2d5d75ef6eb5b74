#include "test/bench/maps/failure_scenes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/random.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/world/static_equilibrium.h"
#include "test/bench/loop_scenes.h"
#include "test/sim/test_models.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;
using Json = nlohmann::json;

double value(const Json& cell, const char* key) {
  if (!cell.contains(key) || !cell[key].is_number())
    throw std::runtime_error("map " + cell.value("map", "") + ": a cell needs a number '" + key + "'");
  return cell[key].get<double>();
}

WorldConfig config_of(const Json& cell) {
  WorldConfig config;
  config.step = value(cell, "step");
  config.twin = cell.value("twin", false);
  const std::string engine = cell.value("engine", "");
  if (engine == "ode") {
    config.engine = Engine::kOde;
  } else if (engine == "rkf78") {
    config.flight = Flight::kRkf78;
  } else if (engine.size() == 12 && engine.rfind("articulated", 0) == 0 && engine.back() >= '1' && engine.back() <= '3') {
    config.order = engine.back() - '0';
  } else {
    throw std::runtime_error("there is no engine '" + engine + "'; use articulated1, articulated2, articulated3, rkf78 or ode");
  }
  return config;
}

// A world of loose bodies, the robot of which is far away.
FailureScene of_bodies(const Json& cell, double duration) {
  FailureScene scene;
  scene.robot.name = "bystander";
  scene.robot.model = test::bystander();
  scene.robot.fixed_base = true;
  scene.robot.start = Configuration(scene.robot.model);
  scene.robot.start.q.setZero();
  scene.robot.start.qd.setZero();
  scene.config = config_of(cell);
  scene.config.fixed_base = true;
  scene.duration = duration;
  return scene;
}

LooseBody box(double mass, const Vector3d& size, double stiffness, double friction) {
  LooseBody body;
  body.name = "box";
  body.mass = mass;
  body.solid.size = size;
  body.stiffness = stiffness;
  body.damping = std::sqrt(stiffness * mass);
  body.friction = friction;
  return body;
}

double energy_at_start(const WorldConfig& config) {
  double sum = 0.0;
  for (const LooseBody& body : config.loose) sum += energy_of(body, body.start);
  return sum;
}

Eigen::Matrix3d drawn_attitude(Random& random) {
  const auto u = [&random] { return 2.0 * random.uniform() - 1.0; };
  const double w = u(), x = u(), y = u(), z = u();
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

// A humanoid on its servos, pushed at 0.07 m/s: gain, stiffness of a corner of its soles, friction.
std::vector<FailureScene> stands(const Json& cell) {
  FailureScene scene;
  scene.robot = physics_scene("stand", value(cell, "gain"));
  const double stiffness = value(cell, "stiffness"), friction = value(cell, "friction");
  for (Sole& sole : scene.robot.model.soles) {
    sole.stiffness = kSoleCorners * stiffness;
    sole.damping = kSoleCorners * std::sqrt(stiffness * 15.0);
    sole.friction = friction;
  }
  const Standing standing =
      stand(scene.robot.model, scene.robot.start.q, 1.0, {stiffness, stiffness}, {0.0, 0.0}, false);
  const Vector3d push = scene.robot.start.base_velocity;
  scene.robot.start = standing.configuration;
  scene.robot.start.base_velocity = push;
  scene.robot.tau = standing.tau;
  for (std::size_t j = 0; j < scene.robot.servos.size(); ++j)
    scene.robot.servos[j].tau = standing.tau[static_cast<Eigen::Index>(j)];
  scene.config = config_of(cell);
  scene.config.ground_friction = friction;
  scene.watch_robot = true;
  scene.every = 0.02;
  return {scene};
}

// A flat box of 1 kg slides at 2 m/s until friction has stopped it.
std::vector<FailureScene> slides(const Json& cell) {
  const double stiffness = value(cell, "stiffness"), friction = value(cell, "friction");
  FailureScene scene = of_bodies(cell, friction > 0.3 ? 1.0 : 2.5);
  scene.config.ground_friction = friction;
  LooseBody body = box(1.0, {0.4, 0.4, 0.02}, stiffness, friction);
  body.start.pose.translation().z() = 0.01 - kGravity / (4.0 * stiffness);
  body.start.velocity.x() = 2.0;
  scene.config.loose = {body};
  scene.scale = energy_at_start(scene.config);
  scene.every = 0.02;
  return {scene};
}

// Boxes thrown at the ground with spin.
std::vector<FailureScene> thrown(const Json& cell) {
  Random random(11);
  const auto u = [&random] { return 2.0 * random.uniform() - 1.0; };
  std::vector<FailureScene> scenes;
  for (int i = 0; i < static_cast<int>(value(cell, "draws")); ++i) {
    FailureScene scene = of_bodies(cell, 1.0);
    scene.config.ground_friction = value(cell, "friction");
    LooseBody body = box(1.0, {0.2, 0.3, 0.1}, value(cell, "stiffness"), value(cell, "friction"));
    body.start.pose.linear() = drawn_attitude(random);
    body.start.pose.translation().z() = 0.4;
    const double x = u(), y = u(), a = u(), b = u(), c = u();
    body.start.velocity = value(cell, "speed") * Vector3d(0.7 * x, 0.7 * y, -0.7);
    body.start.angular_velocity = 10.0 * Vector3d(a, b, c);
    scene.config.loose = {body};
    scene.scale = energy_at_start(scene.config);
    scene.through = [](const World& world) { return world.loose(0).pose.translation().z() < 0.0; };
    scenes.push_back(scene);
  }
  return scenes;
}

// A ball of 20 mm flies at a plate of 2 mm, which is fixed or, with "loose", a body of 100 kg.
std::vector<FailureScene> plates(const Json& cell) {
  Random random(3);
  const double speed = value(cell, "speed"), stiffness = value(cell, "stiffness"), h = value(cell, "step");
  std::vector<FailureScene> scenes;
  for (int i = 0; i < static_cast<int>(value(cell, "draws")); ++i) {
    FailureScene scene = of_bodies(cell, std::max(0.3 / speed, 4.0 * h));
    scene.config.continuous = cell.value("continuous", false);
    LooseBody ball = box(0.03, Vector3d(0.01, 0.0, 0.0), stiffness, 0.3);
    ball.name = "ball";
    ball.solid.shape = SolidShape::kSphere;
    ball.damping *= 0.1;
    const double back = random.uniform(), side = random.uniform();
    ball.start.pose.translation() = Vector3d(0.9 - 0.05 * back, 0.2 * (side - 0.5), 1.0);
    ball.start.velocity.x() = speed;
    scene.config.loose = {ball};
    scene.scale = energy_at_start(scene.config);
    const Vector3d size(0.002, 1.0, 1.0), place(1.0, 0.0, 1.0);
    if (cell.value("loose", false)) {
      LooseBody plate = box(100.0, size, stiffness, 0.3);
      plate.name = "plate";
      plate.start.pose.translation() = place;
      scene.config.loose.push_back(plate);
    } else {
      Obstacle plate;
      plate.shape = ObstacleShape::kBox;
      plate.size = size;
      plate.pose.translation() = place;
      scene.config.obstacles = {plate};
    }
    scene.through = [](const World& world) {
      const double at = world.loose_count() > 1 ? world.loose(1).pose.translation().x() : 1.0;
      return world.loose(0).pose.translation().x() > at;
    };
    scenes.push_back(scene);
  }
  return scenes;
}

// The least distance of two middle lines [m].
double lines_apart(const Vector3d& a, const Vector3d& along_a, const Vector3d& b, const Vector3d& along_b, double half) {
  const Vector3d r = b - a;
  const double c = along_a.dot(along_b), p = along_a.dot(r), q = along_b.dot(r), det = 1.0 - c * c;
  if (!(det > 1e-6)) return r.norm();
  const double s = (p - c * q) / det, t = (c * p - q) / det;
  if (std::abs(s) > half || std::abs(t) > half) return 1.0;  // past an end
  return (r + t * along_b - s * along_a).norm();
}

// A beam falls on a fixed one, edge on edge and across it.
std::vector<FailureScene> edges(const Json& cell) {
  constexpr double kLength = 0.4, kEdge = 0.06;
  Random random(7);
  const auto u = [&random] { return 2.0 * random.uniform() - 1.0; };
  std::vector<FailureScene> scenes;
  for (int i = 0; i < static_cast<int>(value(cell, "draws")); ++i) {
    FailureScene scene = of_bodies(cell, 0.5);
    scene.config.ground_friction = 0.6;
    Obstacle fixed;
    fixed.shape = ObstacleShape::kBox;
    fixed.size << kLength, kEdge, kEdge;
    fixed.pose.translation().z() = 1.0;
    fixed.pose.linear() = Eigen::AngleAxisd(0.25 * M_PI, Vector3d::UnitX()).toRotationMatrix();
    scene.config.obstacles = {fixed};
    LooseBody beam = box(1.0, {kEdge, kLength, kEdge}, value(cell, "stiffness"), 0.6);
    const double yaw = 0.4 * u(), tilt = 0.05 * u(), x = 0.05 * u(), y = 0.05 * u();
    beam.start.pose.linear() = (Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(tilt, Vector3d::UnitX()) *
                                Eigen::AngleAxisd(0.25 * M_PI, Vector3d::UnitY()))
                                   .toRotationMatrix();
    beam.start.pose.translation() << x, y, 1.0 + std::sqrt(2.0) * kEdge + 0.02;
    beam.start.velocity.z() = -value(cell, "speed");
    scene.config.loose = {beam};
    scene.scale = energy_at_start(scene.config);
    scene.through = [](const World& world) {
      const Eigen::Isometry3d pose = world.loose(0).pose;
      return lines_apart({0.0, 0.0, 1.0}, Vector3d::UnitX(), pose.translation(), pose.linear().col(1), 0.5 * kLength) < 0.5 * kEdge;
    };
    scenes.push_back(scene);
  }
  return scenes;
}

// Cubes of 0.1 m on one another; the uppermost is `ratio` times as heavy as the others.
std::vector<FailureScene> stacks(const Json& cell) {
  const int count = static_cast<int>(value(cell, "count"));
  const double ratio = value(cell, "ratio"), stiffness = value(cell, "stiffness");
  FailureScene scene = of_bodies(cell, count > 2 ? 0.5 : 1.0);
  for (int i = 0; i < count; ++i) {
    const double mass = i + 1 == count ? ratio : 1.0;
    LooseBody body = box(mass, Vector3d::Constant(0.1), stiffness * std::max(1.0, ratio / 100.0), 0.8);
    body.name = std::string("box") + std::to_string(i);
    body.damping = std::sqrt(body.stiffness * std::max(1.0, mass));
    body.start.pose.translation().z() = 0.05 + 0.1 * i;
    scene.config.loose.push_back(body);
  }
  scene.scale = energy_at_start(scene.config);
  scene.every = 0.1;
  scene.through = [](const World& world) { return world.loose(0).pose.translation().z() < 0.0; };
  return {scene};
}

double kinetic_at_start(const PhysicsScene& scene) {
  Kinematics kinematics(scene.model);
  kinematics.update(scene.start);
  double sum = 0.0;
  for (int i = 0; i < scene.model.link_count(); ++i) {
    const Link& link = scene.model.links[static_cast<std::size_t>(i)];
    const Vector3d com = kinematics.link_in_world(i) * link.com;
    sum += 0.5 * link.mass * kinematics.point_velocity(i, com).squaredNorm();
  }
  return sum;
}

// A chain of `count` joints turns in the air.
std::vector<FailureScene> chains(const Json& cell) {
  FailureScene scene;
  scene.robot = physics_scene("chain" + std::to_string(static_cast<int>(value(cell, "count"))));
  scene.config = config_of(cell);
  scene.watch_robot = true;
  scene.conservative = true;
  scene.scale = kinetic_at_start(scene.robot);
  scene.every = 0.1;
  return {scene};
}

// `count` four-bars in a row fall through the posture in which their rods lie in one line.
std::vector<FailureScene> loops(const Json& cell) {
  const int count = static_cast<int>(value(cell, "count"));
  const LoopScene loop = loop_scene("n_four_bar" + std::to_string(count));
  FailureScene scene;
  scene.robot.name = "loop";
  scene.robot.model = loop.model;
  scene.robot.fixed_base = true;
  scene.robot.ground = false;
  scene.robot.start = loop.start;
  scene.robot.servos.resize(loop.model.joints.size());
  scene.config = config_of(cell);
  scene.config.fixed_base = true;
  scene.config.ties = loop.config.ties;
  scene.watch_robot = true;
  scene.conservative = true;
  scene.scale = kinetic_at_start(scene.robot) + kGravity * (2 * count + 1);  // the rods are 1 m and 1 kg
  scene.every = 0.05;
  return {scene};
}

}  // namespace

double energy_of(const LooseBody& body, const LooseState& state) {
  const Vector3d spin = state.pose.linear().transpose() * state.angular_velocity;
  return 0.5 * body.mass * state.velocity.squaredNorm() + 0.5 * spin.dot(inertia_of(body.solid, body.mass) * spin) +
         body.mass * kGravity * state.pose.translation().z();
}

std::vector<FailureScene> failure_scenes(const Json& cell) {
  using Maker = std::vector<FailureScene> (*)(const Json&);
  const std::pair<const char*, Maker> makers[] = {{"stand", stands}, {"slide", slides}, {"throw", thrown},
                                                  {"plate", plates}, {"edge", edges},   {"stack", stacks},
                                                  {"chain", chains}, {"loop", loops}};
  const std::string map = cell.value("map", "");
  for (const auto& [name, make] : makers) {
    if (map == name) return make(cell);
  }
  throw std::runtime_error("there is no map '" + map + "'; use stand, slide, throw, plate, edge, stack, chain, loop or walk");
}

}  // namespace twinbus
