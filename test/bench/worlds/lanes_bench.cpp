// Many worlds on one core: four in the lanes of a vector (sim/lanes/lane_worlds.h) beside single runs of engine articulated and MuJoCo.
//
//     lanes_bench [--scene S] [--robot R] [--worlds N] [--seconds T] [--rounds N]
//
// Every world is disturbed by its seed, its servos keep the posture of the start.  Contenders take turns; a ratio is the median over rounds.
// Bit-equal: where each world ends beside its neighbours, and alone in its lane.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/math/random.h"
#include "common/process/arguments.h"
#include "common/process/process.h"
#include "common/time/cpu_time.h"
#include "robot/description/load.h"
#include "sim/engine/make_world.h"
#include "sim/lanes/lane_worlds.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"
#include "sim/sim_adaptor.h"
#include "test/measure.h"

namespace twinbus {
namespace {

struct Start {
  WorldConfig config;
  Configuration configuration;
  Eigen::VectorXd tau;
  std::vector<ServoTarget> servos;
};

Start start_of(const Scene& scene, const Model& model, std::uint64_t seed) {
  Scene drawn = scene;
  apply_seed(drawn, model, seed);
  SimAdaptor sim(drawn);
  if (sim.open(model, {}) != Status::kOk) throw std::runtime_error("the scene does not open");
  Start start{sim.world_config(), sim.world()->configuration(), Eigen::VectorXd(model.joint_count()), {}};
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    start.tau[j] = sim.world()->tau(j);
    start.servos.push_back({.q = sim.world()->encoder(j), .tau = start.tau[j], .kp = joint.kp, .kd = joint.kd});
  }
  Random random(seed);
  for (int k = 0; k < 2; ++k) start.configuration.base_velocity[k] = 0.1 * random.uniform() - 0.05;
  return start;
}

void begin(World& world, const Start& start) {
  if (world.set(start.configuration, &start.tau) != Status::kOk) throw std::runtime_error("bad start");
  for (int i = 0; i < world.loose_count(); ++i) (void)world.set_loose(i, start.config.loose[at(i)].start);
  for (std::size_t j = 0; j < start.servos.size(); ++j) (void)world.set_servo(static_cast<int>(j), start.servos[j]);
}

// All that a world is, as numbers.
std::vector<double> state_of(const World& world) {
  const Configuration& now = world.configuration();
  std::vector<double> state(now.base.data(), now.base.data() + 12);
  const auto keep = [&](const auto& numbers) { state.insert(state.end(), numbers.data(), numbers.data() + numbers.size()); };
  keep(now.base_velocity);
  keep(now.base_angular_velocity);
  keep(now.q);
  keep(now.qd);
  for (int i = 0; i < world.loose_count(); ++i) {
    const LooseState body = world.loose(i);
    keep(body.pose.matrix());
    keep(body.velocity);
    keep(body.angular_velocity);
  }
  return state;
}

// Microseconds of CPU a step of one world.
double single(const Model& model, const std::vector<Start>& starts, Engine engine, long steps) {
  double seconds = 0.0;
  for (const Start& start : starts) {
    WorldConfig config = start.config;
    config.engine = engine;
    const auto world = make_world(model, config);
    begin(*world, start);
    const double begun = thread_cpu_seconds();
    for (long i = 0; i < steps; ++i) {
      if (world->step() != Status::kOk) throw std::runtime_error("diverged");
    }
    seconds += thread_cpu_seconds() - begun;
  }
  return 1e6 * seconds / static_cast<double>(steps) / static_cast<double>(starts.size());
}

struct InLanes {
  double us = 0.0, full = 0.0;  // a step of one world; share of lanes that went together
  std::vector<std::vector<double>> ends;
};

InLanes lanes(const Model& model, const std::vector<Start>& starts, long steps, std::size_t together) {
  InLanes result;
  double seconds = 0.0, all = 0.0, in = 0.0;
  for (std::size_t first = 0; first < starts.size(); first += together) {
    const std::size_t count = std::min(together, starts.size() - first);
    std::vector<std::unique_ptr<World>> each;
    for (std::size_t k = 0; k < count; ++k) each.push_back(make_world(model, starts[first + k].config));
    LaneWorlds worlds(std::vector<const Model*>(count, &model), std::move(each));
    for (std::size_t k = 0; k < count; ++k) begin(worlds.world(static_cast<int>(k)), starts[first + k]);
    std::array<Status, kWorldLanes> status;
    const double begun = thread_cpu_seconds();
    for (long i = 0; i < steps; ++i) worlds.step((1 << count) - 1, status);
    seconds += thread_cpu_seconds() - begun;
    for (std::size_t k = 0; k < count; ++k) {
      if (status[k] != Status::kOk) throw std::runtime_error("diverged");
      result.ends.push_back(state_of(worlds.world(static_cast<int>(k))));
    }
    all += static_cast<double>(worlds.steps());
    in += static_cast<double>(worlds.in_lanes());
  }
  result.us = 1e6 * seconds / static_cast<double>(steps) / static_cast<double>(starts.size());
  result.full = in / all;
  return result;
}

int bench(int argc, char** argv) {
  const Arguments arguments({"bench lanes", 0, 0, R"(
Steps disturbed worlds of a scene four at a time in the lanes of a vector, one by one, and in MuJoCo, all on one core.
  --scene S  default stand
  --robot R  default: the scene's
  --worlds N  default 256
  --seconds T  of each; default 2
  --rounds N  default 5)"}, {argv + 1, argv + argc});
  Scene scene = load_scene(arguments.text("--scene", "stand"));
  const Model model = load_robot(arguments.text("--robot", scene.robot));
  const auto count = static_cast<std::size_t>(arguments.number("--worlds", 256, 1, 1e5));
  const double seconds = arguments.number("--seconds", 2.0, 0.01, 1e4);
  const int rounds = static_cast<int>(arguments.number("--rounds", 5, 1, 1e3));
  std::vector<Start> starts;
  for (std::size_t i = 0; i < count; ++i) starts.push_back(start_of(scene, model, i + 1));
  const long steps = std::lround(seconds / starts[0].config.step);
  std::vector<double> one, four, gains, peers;
  InLanes last;
  std::string without;
  for (int round = 0; round < rounds; ++round) {
    one.push_back(single(model, starts, Engine::kArticulated, steps));
    last = lanes(model, starts, steps, kWorldLanes);
    four.push_back(last.us);
    gains.push_back(one.back() / four.back());
    try {
      if (without.empty()) peers.push_back(single(model, starts, Engine::kMujoco, steps) / four.back());
    } catch (const std::exception& error) {
      without = error.what();
    }
  }
  std::size_t equal = 0;
  const InLanes alone = lanes(model, starts, steps, 1);
  for (std::size_t i = 0; i < count; ++i) equal += alone.ends[i] == last.ends[i] ? 1 : 0;
  std::printf("lanes %s %s: %zu worlds, step %g ms: single %.2f us a step, in lanes %.2f us, %.2f times as many steps a second (lanes full %.1f %%)",
              scene.name.c_str(), model.name.c_str(), count, 1e3 * starts[0].config.step, median(one), median(four), median(gains), 100.0 * last.full);
  if (!peers.empty()) std::printf(", %.2f times MuJoCo's", median(peers));
  std::printf("; bit-equal to alone in the lane: %zu of %zu\n", equal, count);
  if (!without.empty()) std::printf("MuJoCo is left out: %s\n", without.c_str());
  return equal == count ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("bench lanes", &twinbus::bench, argc, argv); }
