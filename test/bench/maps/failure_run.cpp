// What becomes of a scene: one run, and what its engine said of it.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "robot/dynamics/energy.h"
#include "sim/engine/make_world.h"
#include "sim/step_watch.h"
#include "test/bench/maps/failure_scenes.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr double kWrongEnergy = 0.05;  // of the scale

// Kinetic and potential of what is looked at, none of springs.
double energy_of(const FailureScene& scene, const World& world, Kinematics& kinematics) {
  if (scene.watch_robot) {
    kinematics.update(world.configuration());
    return mechanical_energy(kinematics, world.configuration());
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.config.loose.size(); ++i)
    sum += energy_of(scene.config.loose[i], world.loose(static_cast<int>(i)));
  return sum;
}

// Where links or bodies are; of no interest beyond a tenth of a micrometre.
nlohmann::json places(const FailureScene& scene, const World& world) {
  nlohmann::json list = nlohmann::json::array();
  const auto add = [&list](const Vector3d& p) {
    for (int k = 0; k < 3; ++k) list.push_back(1e-7 * std::round(1e7 * p[k]));
  };
  const int count = scene.watch_robot ? scene.robot.model.link_count() : world.loose_count();
  for (int i = 0; i < count; ++i)
    add(scene.watch_robot ? Vector3d(world.link_in_world(i) * scene.robot.model.links[static_cast<std::size_t>(i)].com)
                          : Vector3d(world.loose(i).pose.translation()));
  return list;
}

double fastest(const FailureScene& scene, const World& world) {
  double speed = 0.0;
  if (scene.watch_robot) {
    for (int i = 0; i < scene.robot.model.link_count(); ++i)
      speed = std::max(speed, world.point_velocity(i, world.link_in_world(i).translation()).norm());
  }
  for (int i = 0; i < world.loose_count(); ++i) speed = std::max(speed, world.loose(i).velocity.norm());
  return speed;
}

double uprightness(const FailureScene& scene, const World& world) {
  double least = scene.watch_robot ? world.configuration().base.linear()(2, 2) : 1.0;
  for (int i = 0; i < world.loose_count(); ++i) least = std::min(least, world.loose(i).pose.linear()(2, 2));
  return least;
}

}  // namespace

nlohmann::json run_scene(const FailureScene& scene) {
  constexpr double kPatience = 20.0;      // CPU of a scene's steps [s]
  constexpr std::size_t kMostRuns = 1000;  // of doubted steps in a row that are written down
  const WorldConfig& config = scene.config;
  const auto world = make_world(scene.robot.model, config);
  const bool servoed = scene.robot.tau.size() == scene.robot.start.q.size();
  if (world->set(scene.robot.start, servoed ? &scene.robot.tau : nullptr) != Status::kOk)
    throw std::runtime_error("map: a scene cannot be set to its start");
  for (std::size_t j = 0; j < scene.robot.servos.size(); ++j)
    (void)world->set_servo(static_cast<int>(j), scene.robot.servos[j]);
  StepWatch watch(scene.robot.model, config, 0);
  watch.begin(*world);
  watch.time_steps();
  Kinematics kinematics(scene.robot.model);
  const double first = energy_of(scene, *world, kinematics), h = config.step;
  const long steps = std::lround(scene.duration / h);
  const long look = scene.every > 0.0 ? std::max(1L, std::lround(scene.every / h)) : 0;
  nlohmann::json at = nlohmann::json::object(), doubts_at = nlohmann::json::array(), energy_at, through_at;
  std::string status = "ok";
  double gain = 0.0, time = 0.0;
  long doubted = 0;
  bool was_doubted = false;
  for (long i = 1; i <= steps; ++i) {
    time = static_cast<double>(i) * h;
    if (watch.step(*world, time) != Status::kOk) {
      status = "diverged";
      break;
    }
    const bool is_doubted = watch.counts().doubted > doubted;
    doubted = watch.counts().doubted;
    if (is_doubted && was_doubted) {
      doubts_at.back()[1] = time;
    } else if (is_doubted && doubts_at.size() < kMostRuns) {
      doubts_at.push_back({time, time});
    }
    was_doubted = is_doubted && !doubts_at.empty();
    if (scene.scale > 0.0) {
      const double change = (energy_of(scene, *world, kinematics) - first) / scene.scale;
      gain = std::max(gain, change);
      if (energy_at.is_null() && (change > kWrongEnergy || (scene.conservative && change < -kWrongEnergy))) energy_at = time;
    }
    if (through_at.is_null() && scene.through && scene.through(*world)) through_at = time;
    if (look > 0 && i % look == 0) at[std::to_string(std::lround(1e4 * time))] = places(scene, *world);  // [0.1 ms]
    if (watch.seconds() > kPatience) {
      status = "slow";
      break;
    }
  }
  const TrustCounts& counts = watch.counts();
  nlohmann::json found = {{"status", status},
                          {"ended", time},
                          {"cpu", watch.seconds()},
                          {"said_at", nullptr},
                          {"doubts_at", doubts_at},
                          {"energy_at", energy_at},
                          {"through_at", through_at},
                          {"gain", gain},
                          {"speed", fastest(scene, *world)},
                          {"upright", uprightness(scene, *world)},
                          {"at", at}};
  if (counts.doubted > 0) {
    found["said_at"] = counts.first_at;
    found["said"] = kDoubtNames[static_cast<std::size_t>(counts.first)];
  }
  return found;
}

}  // namespace twinbus
