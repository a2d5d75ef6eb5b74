// What becomes of a scene: one run, and what its engine said of it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <time.h>

#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "sim/step_watch.h"
#include "test/bench/maps/failure_scenes.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr double kWrongEnergy = 0.05;  // of the scale

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Kinetic and potential of what is looked at, none of springs.
double energy_of(const FailureScene& scene, const World& world) {
  double sum = 0.0;
  if (scene.watch_robot) {
    for (int i = 0; i < scene.robot.model.link_count(); ++i) {
      const Link& link = scene.robot.model.links[static_cast<std::size_t>(i)];
      const Eigen::Isometry3d pose = world.link_in_world(i);
      const Vector3d com = pose * link.com;
      const Vector3d spin = pose.linear().transpose() * world.angular_velocity(i);
      sum += 0.5 * link.mass * world.point_velocity(i, com).squaredNorm() + 0.5 * spin.dot(link.inertia * spin) +
             link.mass * kGravity * com.z();
    }
    return sum;
  }
  for (std::size_t i = 0; i < scene.config.loose.size(); ++i) {
    const LooseBody& body = scene.config.loose[i];
    const LooseState now = world.loose(static_cast<int>(i));
    const Vector3d spin = now.pose.linear().transpose() * now.angular_velocity;
    sum += 0.5 * body.mass * now.velocity.squaredNorm() + 0.5 * spin.dot(inertia_of(body.solid, body.mass) * spin) +
           body.mass * kGravity * now.pose.translation().z();
  }
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
  constexpr double kPatience = 20.0;  // CPU of a scene [s]
  WorldConfig config = scene.config;
  const auto world = make_world(scene.robot.model, config);
  const bool servoed = scene.robot.tau.size() == scene.robot.start.q.size();
  if (world->set(scene.robot.start, servoed ? &scene.robot.tau : nullptr) != Status::kOk)
    throw std::runtime_error("map: a scene cannot be set to its start");
  for (std::size_t j = 0; j < scene.robot.servos.size(); ++j)
    (void)world->set_servo(static_cast<int>(j), scene.robot.servos[j]);
  StepWatch watch(scene.robot.model, config, 0);
  watch.begin(*world);
  const double first = energy_of(scene, *world), h = config.step, begun = cpu_seconds();
  const long steps = std::lround(scene.duration / h);
  const long look = scene.every > 0.0 ? std::max(1L, std::lround(scene.every / h)) : 0;
  nlohmann::json at = nlohmann::json::object(), energy_at, through_at;
  std::string status = "ok";
  double gain = 0.0, loss = 0.0, low = std::numeric_limits<double>::infinity(), time = 0.0;
  for (long i = 1; i <= steps; ++i) {
    time = static_cast<double>(i) * h;
    if (watch.step(*world, time) != Status::kOk) {
      status = "diverged";
      break;
    }
    if (scene.scale > 0.0) {
      const double change = (energy_of(scene, *world) - first) / scene.scale;
      gain = std::max(gain, change);
      loss = std::max(loss, -change);
      if (energy_at.is_null() && (change > kWrongEnergy || (scene.conservative && change < -kWrongEnergy))) energy_at = time;
    }
    for (int k = 0; k < world->loose_count(); ++k) low = std::min(low, world->loose(k).pose.translation().z());
    if (through_at.is_null() && scene.through && scene.through(*world)) through_at = time;
    if (look > 0 && i % look == 0) at[std::to_string(std::lround(1e4 * time))] = places(scene, *world);  // [0.1 ms]
    if (cpu_seconds() - begun > kPatience) {
      status = "slow";
      break;
    }
  }
  const TrustCounts& counts = watch.counts();
  nlohmann::json found = {{"status", status},
                          {"ended", time},
                          {"cpu", cpu_seconds() - begun},
                          {"doubted", counts.doubted},
                          {"said_at", nullptr},
                          {"energy_at", energy_at},
                          {"through_at", through_at},
                          {"gain", gain},
                          {"loss", loss},
                          {"speed", fastest(scene, *world)},
                          {"upright", uprightness(scene, *world)},
                          {"at", at}};
  if (counts.doubted > 0) {
    found["said_at"] = counts.first_at;
    found["said"] = kDoubtNames[static_cast<std::size_t>(counts.first)];
    for (std::size_t i = 0; i < kDoubts; ++i) {
      if (counts.steps[i] > 0) found["doubts"][kDoubtNames[i]] = counts.steps[i];
    }
  }
  if (std::isfinite(low)) found["low"] = low;
  return found;
}

}  // namespace twinbus
