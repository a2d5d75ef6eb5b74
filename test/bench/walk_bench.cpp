// How walking holds: stops in every phase, pushes by direction and phase, a robot that is not the nominal one, what every
// robot must do, time of a tick.
//
//     walk_bench [stop|push|pattern|everyday|time]... [--robot R] [--phases N] [--speed V] [--push V] [--guard]
//                [--engine E]
//
// --push: the same change of velocity [m/s] in every direction.  Without words: all of it.  Exit status 1 when a robot
// fell, a stop took more than 1.5 steps or the guard (--guard) asked for a stop.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "control/walk/walk.h"
#include "robot/description/load.h"
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
  int phases = 100;
  bool guard = false;
  double speed = 0.5;
  double push = 0.0;  // instead of those of each direction [m/s]
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
    WalkCommand command;
    command.run_id = state().run_id;
    command.vx = static_cast<float>(vx);
    command.vy = static_cast<float>(vy);
    command.wz = static_cast<float>(turn);
    command.timeout = 0.1F;
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

// A balanced stop in each phase of the gait: how long until both soles stand for good.
int stops(const Bench& bench) {
  const Gait gait = gait_of(bench.model, walking_of(bench.model), 0.01);
  double worst = 0.0, sum = 0.0, effort = 0.0, least_margin = 1.0;
  int fell = 0, late = 0;
  for (int phase = 0; phase < bench.phases; ++phase) {
    Walker robot(bench, scene_of(bench), {});
    const double time = 4.0 + 2.0 * gait.period() * phase / bench.phases;
    bool good = robot.walk(bench.model, bench.speed, 0.0, time);
    const auto asked = static_cast<double>(robot.ticks());
    robot.last_in_air = asked;
    robot.forget();
    robot.state().stop_kind = StopKind::kBalanced;
    good = good && robot.walk(bench.model, bench.speed, 0.0, 5.0);
    const double steps = (robot.last_in_air - asked) * bench.model.period() / gait.period();
    fell += good ? 0 : 1;
    late += steps > 1.5 ? 1 : 0;
    worst = std::max(worst, steps);
    sum += steps;
    effort = std::max(effort, robot.record().effort_share_max);
    least_margin = std::min(least_margin, robot.record().zmp_margin_min);
  }
  std::printf(
      "stop at %.2f m/s in %d phases: %d falls, %d took more than 1.5 steps, mean %.2f, "
      "most %.2f steps; effort %.0f %% of the limits, ZMP margin %.1f mm\n",
      bench.speed, bench.phases, fell, late, sum / bench.phases, worst, 1e2 * effort,
      1e3 * least_margin);
  return fell + late;
}

bool survives(const Bench& bench, double dvx, double dvy, double phase, bool standing,
              const Settings& settings) {
  const Gait gait = gait_of(bench.model, walking_of(bench.model), 0.01);
  Scene scene = scene_of(bench);
  Push push;
  push.link = bench.model.links.front().name;
  push.impulse = bench.model.total_mass() * Eigen::Vector3d(dvx, dvy, 0.0);
  push.at = 4.0 + 2.0 * gait.period() * phase;
  scene.pushes.push_back(push);
  Walker robot(bench, scene, settings);
  return robot.walk(bench.model, standing ? 0.0 : 1e-4, 0.0, push.at + 4.0);
}

int pushes(const Bench& bench, const Settings& settings, const char* name, int count) {
  struct Direction {
    const char* name;
    double x, y, walking, standing;
  };
  int fell = 0;
  std::printf("%-22s", name);
  for (const Direction& d :
       {Direction{"forward", 1, 0, 0.6, 0.8}, Direction{"left", 0, 1, 0.4, 0.6},
        Direction{"back", -1, 0, 0.6, 0.7}, Direction{"right", 0, -1, 0.4, 0.6}}) {
    const double walking = bench.push > 0.0 ? bench.push : d.walking;
    const double standing = bench.push > 0.0 ? bench.push : d.standing;
    int held = 0;
    std::string map;
    for (int p = 0; p < count; ++p) {
      const bool good = survives(bench, d.x * walking, d.y * walking,
                                 static_cast<double>(p) / count, false, settings);
      held += good ? 1 : 0;
      map += good ? '.' : 'x';
    }
    const bool stood = survives(bench, d.x * standing, d.y * standing, 0.0, true, settings);
    std::printf("  %s %.2f: %d of %d %s standing %.2f: %s", d.name, walking, held, count,
                map.c_str(), standing, stood ? "holds" : "FALLS");
    fell += count - held + (stood ? 0 : 1);
  }
  std::printf("\n");
  return fell;
}

// What any robot that walks must do: forward, sideways, turn, tiles of 20 mm, pushes of 0.25 m/s in every phase.
int everyday(const Bench& given) {
  constexpr double kShare = 0.7;  // of the fastest walk
  constexpr double kPushed = 0.25;
  Bench bench = given;
  bench.guard = true;
  const Eigen::Vector3d most =
      kShare * gait_of(bench.model, walking_of(bench.model), 0.01).most_velocity;
  struct Row {
    const char* name;
    Eigen::Vector3d velocity;
    double tiles;  // [m]
  };
  int fell = 0;
  for (const Row& row :
       {Row{"forward", {most.x(), 0.0, 0.0}, 0.0}, Row{"sideways", {0.0, most.y(), 0.0}, 0.0},
        Row{"turn", {0.0, 0.0, most.z()}, 0.0},
        Row{"tiles of 20 mm", {0.5 * most.x(), 0.0, 0.0}, 0.02}}) {
    for (std::uint64_t seed = 1; seed <= (row.tiles > 0.0 ? 3U : 1U); ++seed) {
      Scene scene = scene_of(bench);
      scene.terrain.height = row.tiles;
      scene.terrain.length = row.tiles > 0.0 ? 6.0 : 0.0;
      scene.terrain.width = 2.4;
      apply_seed(scene, bench.model, seed);
      Walker robot(bench, scene, {});
      robot.turn = row.velocity.z();
      const bool good = robot.walk(bench.model, row.velocity.x(), row.velocity.y(), 12.0);
      fell += good ? 0 : 1;
      std::printf("%s, guard on, %s: %s, tilt %.2f degrees, ZMP margin %.1f mm\n",
                  bench.model.name.c_str(), row.name,
                  good                                     ? "holds"
                  : robot.loop().guard_report().stop_asked ? "the guard STOPS it"
                                                           : "FALLS",
                  57.29578 * robot.record().base_tilt_max, 1e3 * robot.record().zmp_margin_min);
    }
  }
  int held = 0, count = 0;
  for (const auto& [x, y] :
       {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{-1.0, 0.0}, std::pair{0.0, -1.0}}) {
    for (int phase = 0; phase < 6; ++phase, ++count)
      held += survives(bench, kPushed * x, kPushed * y, phase / 6.0, false, {}) ? 1 : 0;
  }
  std::printf("%s, guard on, pushes of %.2f m/s: %d of %d held\n", bench.model.name.c_str(),
              kPushed, held, count);
  return fell + count - held;
}

// The reference in closed form and that of preview control.
int patterns(const Bench& given) {
  int fell = 0;
  for (const char* name : {"closed_form", "preview"}) {
    Bench bench = given;
    bench.model = test::say_walking(given.model, std::string("pattern: ") + name);
    Walker robot(bench, scene_of(bench), {});
    const bool good = robot.walk(bench.model, bench.speed, 0.0, 12.0);
    fell += good ? 0 : 1;
    std::printf("pattern %-11s walks %.2f m/s: %s, tilt %.2f degrees, ZMP margin %.1f mm\n", name,
                bench.speed, good ? "holds" : "FALLS", 57.29578 * robot.record().base_tilt_max,
                1e3 * robot.record().zmp_margin_min);
    fell += pushes(bench, {}, name, 6);
  }
  return fell;
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
  WalkPattern pattern(gait_of(bench.model, walking_of(bench.model), 0.01));
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
  std::string robot = "hrp1s";
  std::vector<std::string> words;
  bool phases_given = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--robot" && has_value) {
      robot = argv[++i];
    } else if (word == "--engine" && has_value) {
      bench.engine = argv[++i];
    } else if (word == "--phases" && has_value) {
      bench.phases = std::max(1, std::atoi(argv[++i]));
      phases_given = true;
    } else if (word == "--guard") {
      bench.guard = true;
    } else if (word == "--push" && has_value) {
      bench.push = std::atof(argv[++i]);
    } else if (word == "--speed" && has_value) {
      bench.speed = std::atof(argv[++i]);
    } else if (word == "stop" || word == "push" || word == "time" || word == "everyday" ||
               word == "pattern") {
      words.push_back(word);
    } else {
      std::fprintf(stderr,
                   "walk_bench [stop|push|pattern|everyday|time]... [--robot R] [--phases N] "
                   "[--speed V] [--push V] [--guard] [--engine E]\n");
      return word == "--help" ? 0 : 2;
    }
  }
  bench.model = load_robot(robot);
  const auto asked = [&](const char* name) {
    return words.empty() || std::find(words.begin(), words.end(), name) != words.end();
  };
  int bad = 0;
  if (asked("stop")) bad += stops(bench);
  if (asked("push")) bad += pushes(bench, {}, "nominal", phases_given ? bench.phases : 12);
  if (asked("pattern")) bad += patterns(bench);
  if (asked("everyday")) bad += everyday(bench);
  for (const bool guard : {false, true}) {
    if (asked("time")) time_ticks(bench, guard);
  }
  return bad > 0 ? 1 : 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_bench", twinbus::run, argc, argv);
}
