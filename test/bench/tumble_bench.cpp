// What flies off where loose bodies tumble: every seed of a scene with a disturbance, its loose bodies and obstacles
// alone, the robot far away.
//
//     tumble_bench [--scene S] [--seeds N] [--seconds T] [--step H] [--order O] [--engine E] [--away D]
//
// Flung: a body that rises above twice the height from which the highest fell.  Doubted: the engine said of a step that it is not to
// be trusted; silent: flung, and it had said nothing.  Diverged: the engine gave up, and says so.  Away: everything begins so far from
// the origin along x; also said is how far bodies then are from where they would be at the origin, after a tenth of a second, before
// the smallest difference has grown, and at the end.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "sim/engine/energy_balance.h"
#include "sim/engine/make_world.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

// One link on a wall far away.
Model bystander() {
  Model model;
  model.name = "bystander";
  model.floating_base = false;
  Link base, arm;
  base.name = "base";
  base.mass = arm.mass = 1.0;
  base.inertia = arm.inertia = 0.1 * Eigen::Matrix3d::Identity();
  arm.name = "arm";
  arm.parent = 0;
  Joint joint;
  joint.name = "hinge";
  joint.parent = 0;
  joint.child = 1;
  joint.axis = Eigen::Vector3d::UnitY();
  joint.placement.translation() = Eigen::Vector3d(500, 500, 5);
  joint.lower = -3.0;
  joint.upper = 3.0;
  model.links = {base, arm};
  model.joints = {joint};
  return model;
}

// The largest distance of a body from where the other world has it, that is `away` nearer.
double apart(const World& world, const World& near, double away) {
  double most = 0.0;
  for (int b = 0; b < world.loose_count(); ++b) {
    const Eigen::Vector3d here = world.loose(b).pose.translation() - away * Eigen::Vector3d::UnitX();
    most = std::max(most, (here - near.loose(b).pose.translation()).norm());
  }
  return most;
}

int tumble(int argc, char** argv) {
  const Arguments arguments({"bench tumble", 0, 0, R"(
Runs the loose bodies of a scene with a disturbance from many seeds; exit status 0 only if nothing is flung and nothing diverges.
  --scene S  default boxes_tumble
  --seeds N  default 100
  --seconds T  of each; default 2
  --step H  [s]; default 0.001
  --order O  default 1
  --engine E  articulated (default) or ode
  --away D  begun so far from the origin [m]; default 0)"}, {argv + 1, argv + argc});
  const Scene scene = load_scene(arguments.text("--scene", "boxes_tumble"));
  const int seeds = static_cast<int>(arguments.number("--seeds", 100, 1, 1e6));
  const double seconds = arguments.number("--seconds", 2.0, 0.01, 1e4);
  const Model model = bystander();
  WorldConfig config;
  config.step = arguments.number("--step", 1e-3, 1e-6, 0.1);
  config.order = static_cast<int>(arguments.number("--order", 1, 1, 3));
  config.fixed_base = true;
  if (!engine_of(arguments.text("--engine", "articulated"), config.engine))
    throw UsageError("bench tumble: there is no such engine; use articulated or ode");
  const double away = arguments.number("--away", 0.0, 0.0, 0.9 * kMaxDistance);
  double early = 0.0, late = 0.0, worst = 0.0;
  int flung = 0, doubted = 0, silent = 0, gave_up = 0;
  std::string which;  // seeds that were flung or diverged
  double highest = 0.0, gained = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Scene drawn = scene;
    apply_seed(drawn, model, static_cast<std::uint64_t>(seed));
    WorldConfig mine = config;
    mine.ground_friction = drawn.ground_friction;
    mine.obstacles = drawn.obstacles;
    mine.loose = drawn.loose;
    double start = 0.0, top = 0.0;
    for (const LooseBody& body : mine.loose)
      start = std::max(start, body.start.pose.translation().z());
    std::unique_ptr<World> near;
    if (away > 0.0) {
      near = make_world(model, mine);
      for (LooseBody& body : mine.loose) body.start.pose.translation().x() += away;
      for (Obstacle& obstacle : mine.obstacles) obstacle.pose.translation().x() += away;
    }
    const auto world = make_world(model, mine);
    Configuration still(model);
    still.q.setZero();
    still.qd.setZero();
    if (world->set(still) != Status::kOk || (near && near->set(still) != Status::kOk)) throw std::runtime_error("bad start");
    EnergyBalance balance(model, mine);
    balance.begin(*world);
    long doubts = 0;
    bool diverged = false;
    for (long i = 0; i < std::lround(seconds / mine.step) && !diverged; ++i) {
      diverged = world->step() != Status::kOk;
      doubts += balance.add(*world, 0.0) || world->trust().any() ? 1 : 0;
      gained = std::max(gained, balance.gain());
      for (int b = 0; b < world->loose_count(); ++b)
        top = std::max(top, world->loose(b).pose.translation().z());
      if (!near) continue;
      (void)near->step();
      late = apart(*world, *near, away);
      if (static_cast<double>(i) * mine.step < 0.1) early = std::max(early, late);
    }
    worst = std::max(worst, late);
    const bool off = top > 2.0 * start;
    if (off || diverged) which += " " + std::to_string(seed);
    flung += off ? 1 : 0;
    gave_up += diverged ? 1 : 0;
    doubted += doubts > 0 ? 1 : 0;
    silent += off && doubts == 0 ? 1 : 0;
    highest = std::max(highest, top);
  }
  std::printf("%s %s order %d step %g: %d seeds, flung %d, silent %d, diverged %d, doubted %d, highest %.2f m, most energy gained in a step %.3g J\n",
              scene.name.c_str(), kEngineNames[static_cast<std::size_t>(config.engine)], config.order,
              config.step, seeds, flung, silent, gave_up, doubted, highest, gained);
  if (!which.empty()) std::printf("flung or diverged: seeds%s\n", which.c_str());
  if (away > 0.0)
    std::printf("begun %g m away: bodies differ by %.3g m in the first tenth of a second, by %.3g m at the end\n", away, early, worst);
  return flung + gave_up == 0 ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("bench tumble", &twinbus::tumble, argc, argv); }
