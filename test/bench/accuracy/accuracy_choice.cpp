// What the ladder of `accuracy` chooses for a scene of physics_scenes.h that no controller drives.
//
//     accuracy_choice SCENE ERROR     prints order, step [s] and distance from the yardstick [m], or why nothing holds the error
//
// The ladder divides a control period; here that is the longest step tried, and where the links are is looked at once in each.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "common/process/process.h"
#include "launcher/run/ladder.h"
#include "sim/engine/make_world.h"
#include "test/bench/physics_scenes.h"

namespace twinbus {
namespace {

constexpr std::int64_t kLongest = 100'000'000;  // [ns]

Track follow_alone(const PhysicsScene& scene, const Scene& asked) {
  WorldConfig config;
  config.step = asked.step;
  config.fixed_base = scene.fixed_base;
  for (const auto& [key, value] : asked.settings) config.order = key == "solver.order" ? std::atoi(value.c_str()) : config.order;
  const auto world = make_world(scene.model, config);
  if (world->set(scene.start, &scene.tau) != Status::kOk) throw std::runtime_error("bad start");
  for (std::size_t j = 0; j < scene.servos.size(); ++j) (void)world->set_servo(static_cast<int>(j), scene.servos[j]);
  Track track;
  for (const Link& link : scene.model.links) track.names.push_back("link " + link.name);
  const long steps = std::lround(scene.duration / asked.step), each = std::lround(1e-9 * static_cast<double>(kLongest) / asked.step);
  for (long i = 1; i <= steps && track.whole; ++i) {
    track.whole = world->step() == Status::kOk;
    if (i % each != 0) continue;
    track.at.emplace_back();
    for (int l = 0; l < scene.model.link_count(); ++l) track.at.back().push_back(world->link_in_world(l).translation());
  }
  track.work = world->work();
  return track;
}

int choose(int argc, char** argv) {
  if (argc != 3) throw std::runtime_error("SCENE ERROR are wanted; see the head of accuracy_choice.cpp");
  PhysicsScene scene = physics_scene(argv[1]);
  scene.model.period_ns = kLongest;
  LadderRequest request;
  request.duration = scene.duration;
  request.error = std::atof(argv[2]);
  request.follow = [&](const Scene& asked) { return follow_alone(scene, asked); };
  const Ladder ladder = climb(scene.model, Scene{}, {}, request);
  const int chosen = ladder.choose(request.error);
  if (chosen < 0) {
    std::printf("none %s\n", ladder.why_none_holds(request.error).c_str());
    return 0;
  }
  const Rung& rung = ladder.rungs[static_cast<std::size_t>(chosen)];
  std::printf("chosen %d %.17g %.6g of %zu runs\n", rung.order, rung.step, rung.apart, ladder.rungs.size());
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("accuracy_choice", &twinbus::choose, argc, argv); }
