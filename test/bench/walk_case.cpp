// One case of `twinbus bench walk`: a stop, a push or a walk of a robot, or the time of a tick.
//
//     walk_case stop --phase P [--speed V]           a balanced stop at a share P of two steps
//     walk_case push --x DVX --y DVY [--phase P] [--standing]      a push that changes its velocity so [m/s], on the spot
//     walk_case walk [--speed V] [--share S --axis forward|sideways|turn] [--tiles H] [--seed N]     12 s
//     walk_case time [--guard]
//
// Of all: --robot R, --engine E, --guard, --pattern closed_form|preview.  The last line is a JSON object, for campaigns; exit status 1
// when the robot fell, a stop took more than 1.5 steps, or the guard asked for a stop.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "control/walk/walk.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "sim/scene/scene_seed.h"
#include "test/bench/core_alone.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

constexpr float kOffGround = 0.003F;  // of a sole that stands no more [m]

struct Bench {
  Model model;
  std::string engine = "articulated";
  bool guard = false;
  double speed = 0.5;
};

// A rig that walks; the time is that since walking was asked for.
struct Walker : SimRig {
  Walker(const Bench& bench, const Scene& scene, const Settings& settings)
      : SimRig(bench.model, bench.model, scene, settings, config(bench)) {
    (void)run(0.5);
    ask(Mode::kWalk);
  }
  static ControlConfig config(const Bench& bench) {
    ControlConfig control;
    control.guard_in_loop = bench.guard;
    return control;
  }
  bool walk(const Model& model, double vx, double vy, double seconds) {
    WalkCommand command = walk_command(state().run_id, vx, vy, turn);
    const auto count = static_cast<int>(std::lround(seconds / model.period()));
    for (int i = 0; i < count; ++i) {
      if (i % 10 == 0) {
        command.sequence = ++said;
        loop().on_walk_command(command, state().time_ns);
      }
      if (!tick() || record().fell || loop().guard_report().stop_asked) return false;
      watch_feet();
    }
    return true;
  }
  void watch_feet() {
    for (const auto& foot : truth().foot_position) {
      if (foot[2] > kOffGround) last_in_air = static_cast<double>(ticks());
    }
  }
  double turn = 0.0;  // asked [rad/s]
  std::int32_t said = 0;
  double last_in_air = 0.0;  // of a foot [tick]
};

Scene scene_of(const Bench& bench) {
  Scene scene;
  scene.engine = bench.engine;
  return scene;
}

// The last line; true when the robot held.
bool say(bool held, nlohmann::json found) {
  found["held"] = held;
  std::printf("%s\n", found.dump().c_str());
  return held;
}

// A balanced stop: how long until both soles stand for good.
bool stop(const Bench& bench, double phase) {
  const Gait gait = gait_of(bench.model, bench.model.walking, 0.01);
  Walker robot(bench, scene_of(bench), {});
  bool good = robot.walk(bench.model, bench.speed, 0.0, 4.0 + 2.0 * gait.period() * phase);
  const auto asked = static_cast<double>(robot.ticks());
  robot.last_in_air = asked;
  robot.forget();
  robot.state().stop_kind = StopKind::kBalanced;
  good = good && robot.walk(bench.model, bench.speed, 0.0, 5.0);
  const double steps = (robot.last_in_air - asked) * bench.model.period() / gait.period();
  say(good, {{"steps", steps},
             {"late", steps > 1.5},
             {"effort_percent", 1e2 * robot.record().effort_share_max},
             {"zmp_margin_mm", 1e3 * robot.record().zmp_margin_min}});
  return good && steps <= 1.5;
}

bool push(const Bench& bench, double dvx, double dvy, double phase, bool standing) {
  const Gait gait = gait_of(bench.model, bench.model.walking, 0.01);
  Scene scene = scene_of(bench);
  Push push;
  push.link = bench.model.links.front().name;
  push.impulse = bench.model.total_mass() * Eigen::Vector3d(dvx, dvy, 0.0);
  push.at = 4.0 + 2.0 * gait.period() * phase;
  scene.pushes.push_back(push);
  Walker robot(bench, scene, {});
  return say(robot.walk(bench.model, standing ? 0.0 : 1e-4, 0.0, push.at + 4.0), {});
}

// velocity: forward, left [m/s], turn [rad/s]; tiles: their height [m].
bool walk(const Bench& bench, const Eigen::Vector3d& velocity, double tiles, std::uint64_t seed) {
  Scene scene = scene_of(bench);
  scene.terrain.height = tiles;
  scene.terrain.length = tiles > 0.0 ? 6.0 : 0.0;
  scene.terrain.width = 2.4;
  apply_seed(scene, bench.model, seed);
  Walker robot(bench, scene, {});
  robot.turn = velocity.z();
  const bool held = robot.walk(bench.model, velocity.x(), velocity.y(), 12.0);
  return say(held,
             {{"guard_stops", robot.loop().guard_report().stop_asked},
              {"tilt_deg", 57.29578 * robot.record().base_tilt_max},
              {"zmp_margin_mm", 1e3 * robot.record().zmp_margin_min}});
}

constexpr int kTimedTicks = 4000;
constexpr int kWalks = 9;

// Of every tick of all walks.
struct Times {
  test::SharedTimes control, engine, pattern, same;
  test::SharedTimes loop;  // control and engine together
};

double us_since(std::int64_t then) { return 1e-3 * static_cast<double>(monotonic_ns() - then); }

// One tick of the control loop while the simulated robot walks at a physics step of 1 ms, what the engine takes, the
// pattern generator alone, and work that is the same every time.  False when the robot fell.
bool walk_timed(const Bench& bench, int same_rounds, test::CoreAlone& core, Times& times) {
  Scene scene = scene_of(bench);
  scene.step = 0.001;
  Walker robot(bench, scene, {});
  if (!robot.walk(bench.model, bench.speed, 0.0, 3.0)) return false;
  WalkPattern pattern(gait_of(bench.model, bench.model.walking, 0.01));
  pattern.start({pattern.foot(0), pattern.foot(1)});
  pattern.want({bench.speed, 0.0, 0.0});
  RobotState& state = robot.state();
  JointCommand answer;
  WalkCommand command;
  command.run_id = state.run_id;
  command.vx = static_cast<float>(bench.speed);
  command.timeout = 0.1F;
  for (std::int64_t i = robot.ticks(); i < robot.ticks() + kTimedTicks; ++i) {
    std::array<bool, 6> alone{core.alone()};
    std::int64_t then = monotonic_ns();
    const Status read = robot.sim().read(state, 0.0);
    const double reading = us_since(then);
    state.tick = i;
    state.time_ns = i * bench.model.period_ns;
    if (i % 10 == 0) robot.loop().on_walk_command(command, state.time_ns);
    alone[1] = core.alone();
    then = monotonic_ns();
    robot.loop().on_state(state, state.time_ns);
    (void)robot.loop().step(state.time_ns, answer);
    const double control = us_since(then);
    alone[2] = core.alone();
    then = monotonic_ns();
    const Status written = robot.sim().write(answer);
    const double engine = reading + us_since(then);
    alone[3] = core.alone();
    if (read != Status::kOk || written != Status::kOk) return false;
    then = monotonic_ns();
    pattern.advance({true, true}, {pattern.foot(0), pattern.foot(1)}, bench.model.period());
    pattern.plan(pattern.dcm(), 3.7);
    const double planning = us_since(then);
    alone[4] = core.alone();
    then = monotonic_ns();
    test::CoreAlone::burst(same_rounds);
    const double same = us_since(then);
    alone[5] = core.alone();

    const bool all = alone[0] && alone[1] && alone[2] && alone[3];
    times.control.add(control, alone[1] && alone[2]);
    times.engine.add(engine, all);
    times.loop.add(control + engine, all);
    times.pattern.add(planning, alone[3] && alone[4]);
    times.same.add(same, alone[4] && alone[5]);
  }
  return true;
}

void print_times(const char* name, const test::SharedTimes& times) {
  const double median = times.all(0.5), tail = times.all(0.99);
  const double walks = times.repeated(0.5, kTimedTicks);
  const double walks_tail = times.repeated(0.99, kTimedTicks);
  const double own = times.alone(0.5), own_tail = times.alone(0.99);
  std::printf(
      "  %-38s %6.1f %6.1f (%.2fx) %8.1f   %6.1f %6.1f (%.2fx)   %6.1f %6.1f (%.2fx) %5.0f %%\n",
      name, median, tail, tail / median, times.all(1.0), walks, walks_tail, walks_tail / walks, own,
      own_tail, own_tail / own, 100.0 * times.share_alone());
}

void time_ticks(const Bench& given, bool guard) {
  Bench bench = given;
  bench.guard = guard;
  test::CoreAlone core;
  Times first, times;
  constexpr int kFirstRounds = 1000;
  if (!walk_timed(bench, kFirstRounds, core, first)) return;
  const int same_rounds = static_cast<int>(
      std::lround(kFirstRounds * first.control.all(0.5) / std::max(0.1, first.same.all(0.5))));
  for (int walk = 0; walk < kWalks; ++walk) {
    if (!walk_timed(bench, same_rounds, core, times)) return;
  }
  std::printf("walking %s guard, %d ticks, %d walks alike [us]\n  %-38s %-31s   %-22s   %s\n",
              guard ? "with" : "without", kTimedTicks, kWalks, "", "all: median   99 %    worst",
              "each tick's median of all walks", "core alone: median   99 %, share");
  print_times("control tick", times.control);
  print_times("as many additions in registers", times.same);
  if (!guard) print_times("pattern generator alone", times.pattern);
  print_times("engine and sensors, two steps of 1 ms", times.engine);
  const double tick_us = 1e6 * bench.model.period();
  std::printf("  whole loop: %.0f times real time, core alone %.0f\n", tick_us / times.loop.mean(),
              tick_us / times.loop.mean_alone());
}

int run(int argc, char** argv) {
  Bench bench;
  std::string word, robot = "hrp1s", pattern = "own", axis = "forward";
  double phase = 0.0, x = 0.0, y = 0.0, share = 0.0, tiles = 0.0;
  bool standing = false;
  std::int64_t seed = 1;
  Options options("walk_case", "One case of bench walk.");
  options.positional("CASE", word, true, "stop, push, walk or time");
  options.text("--robot", "R", robot, "a name of config/robots, or a folder");
  options.choice("--engine", {"articulated", "ode"}, bench.engine, "that simulates");
  options.flag("--guard", bench.guard, "in the loop");
  options.choice("--pattern", {"own", "closed_form", "preview"}, pattern, "of the reference that it walks by");
  options.number("--speed", "V", bench.speed, -2.0, 2.0, "[m/s]");
  options.number("--phase", "SHARE", phase, 0.0, 1.0, "of two steps");
  options.number("--x", "DV", x, -10.0, 10.0, "change of velocity by the push, forward [m/s]");
  options.number("--y", "DV", y, -10.0, 10.0, "to the left [m/s]");
  options.flag("--standing", standing, "pushed while it stands ready to walk");
  options.number("--share", "S", share, 0.0, 1.0, "of the fastest walk along --axis, instead of --speed");
  options.choice("--axis", {"forward", "sideways", "turn"}, axis, "of the walk");
  options.number("--tiles", "H", tiles, 0.0, 0.1, "height of the tiles it walks over [m]");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the tiles");
  options.parse(argc, argv);
  bench.model = load_robot(robot);
  if (pattern != "own") bench.model.walking.preview = pattern == "preview";
  if (word == "time") {
    time_ticks(bench, bench.guard);
    return 0;
  }
  if (word == "stop") return stop(bench, phase) ? 0 : 1;
  if (word == "push") return push(bench, x, y, phase, standing) ? 0 : 1;
  if (word != "walk") {
    std::fprintf(stderr, "walk_case: no case '%s'; use stop, push, walk or time\n", word.c_str());
    return 2;
  }
  Eigen::Vector3d velocity(bench.speed, 0.0, 0.0);
  if (share > 0.0) {
    const Eigen::Vector3d most = gait_of(bench.model, bench.model.walking, 0.01).most_velocity;
    const int k = axis == "forward" ? 0 : axis == "sideways" ? 1 : 2;
    velocity.setZero();
    velocity[k] = share * most[k];
  }
  return walk(bench, velocity, tiles, static_cast<std::uint64_t>(seed)) ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_case", twinbus::run, argc, argv);
}
