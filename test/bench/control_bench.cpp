// `twinbus bench control`: what a tick of the controller costs in each mode, what the guard in it costs, and
// whether anything in the loops of source, controller, guard, planner and gamepad allocates.
//
// Each mode is run once in the simulator; the states recorded are then answered again by a fresh controller with
// nothing in between, as in a process of its own.  "beside the physics" is the first run: the same computation
// after the simulator has emptied the caches.

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/source/source.h"
#include "control/loop/control_loop.h"
#include "control/guard/guard.h"
#include "control/teleop/teleop.h"
#include "planner/arm_path_pieces.h"
#include "planner/arm_planner.h"
#include "robot/estimation/estimator.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "common/time/latency_histogram.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"
#include "test/activate.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

constexpr std::int64_t kRunId = 1;
constexpr int kWarmUp = 100;           // ticks that are not measured
constexpr double kMedianAsked = 60.0;  // [us]
constexpr double kP99Asked = 200.0;

struct Row {
  std::string name;
  RateStats stats;
};

struct Allocations {
  std::int64_t source = 0, controller = 0, guard = 0, planner = 0, gamepad = 0;
  std::int64_t sum() const { return source + controller + guard + planner + gamepad; }
};

struct Case {
  const char* name;
  Mode mode;
  Motion motion = Motion::kNone;
  float amplitude = 0.0F, frequency = 0.0F;
  bool path = false;
  bool guard = true;
  StopKind stop = StopKind::kNone;
};

const Case kCases[] = {
    {"stand", Mode::kBalance},
    {"stand, guard left out", Mode::kBalance, Motion::kNone, 0.0F, 0.0F, false, false},
    {"sway", Mode::kBalance, Motion::kSway, 0.03F, 0.4F},
    {"squat", Mode::kBalance, Motion::kSquat, 0.05F, 0.3F},
    {"arm path", Mode::kBalance, Motion::kNone, 0.0F, 0.0F, true},
    {"hold", Mode::kHold},
    {"idle", Mode::kIdle},
    {"balanced stop in sway", Mode::kBalance, Motion::kSway, 0.03F, 0.4F, false, true,
     StopKind::kBalanced},
};

// What came in before each tick, to be answered again.
struct Heard {
  RobotState state;
  JointCommand command;
  bool stop = false;
};

ControlConfig control_config(const Case& c) {
  ControlConfig config;
  config.guard_in_loop = c.guard;
  return config;
}

ModeRequest mode_request(const Case& c) {
  ModeRequest request;
  request.sender_id = 9;
  request.run_id = kRunId;
  request.sequence = 1;
  request.mode = c.mode;
  request.motion = c.motion;
  request.amplitude = c.amplitude;
  request.frequency = c.frequency;
  return request;
}

std::vector<ArmPathPiece> arm_path(const Model& model, const Scene& scene,
                                   const RobotState& state) {
  Estimator estimator(model);
  estimator.update(state);
  ArmPlanner planner(model);
  planner.set_obstacles(scene.obstacles);
  ArmGoal goal;
  goal.kind = ArmGoalKind::kPosition;
  goal.side = ArmSide::kLeft;
  goal.speed = 0.2F;
  goal.position = {0.30, 0.30, 0.95};
  const ArmPlan plan =
      planner.plan(goal, estimator.configuration(), estimator.ground_in_world(), 1);
  if (plan.status != ArmPathStatus::kOk)
    throw std::runtime_error("no arm path: " + describe(plan));
  return to_pieces(plan, {2, kRunId, 1, 1});
}

// Brings the events of a case to a loop before the answer to its n-th state.
void say(const Case& c, int n, const Heard& heard, const std::vector<ArmPathPiece>& path,
         ControlLoop& loop) {
  if (n == 1) loop.on_mode_request(mode_request(c));
  if (n == kWarmUp) {
    for (const ArmPathPiece& piece : path) loop.on_arm_path(piece);
  }
  if (heard.stop) {
    StopRequest stop;
    stop.kind = c.stop;
    loop.on_stop(stop);
  }
}

// Simulator and controller; fills what was heard.
std::vector<Heard> record(const Model& model, const Scene& scene, const Case& c, int ticks,
                          RateStats& beside, std::vector<ArmPathPiece>& path,
                          Allocations& allocations) {
  SimAdaptor sim(scene);
  if (sim.open(model, {}) != Status::kOk) throw std::runtime_error("the simulator does not open");
  SourceConfig config;
  config.run_id = kRunId;
  config.pace = Pace::kFreeRun;
  Source source(model, sim, config);
  ControlLoop loop(model, control_config(c));
  std::int64_t now_ns = 0;
  test::activate(source, kRunId, model.period_ns, now_ns);
  std::vector<Heard> all(static_cast<std::size_t>(ticks));
  for (int n = 0; n < ticks; ++n) {
    Heard& heard = all[static_cast<std::size_t>(n)];
    if (n == kWarmUp - 1 && c.path) path = arm_path(model, scene, source.state());
    heard.stop = c.stop != StopKind::kNone && n == ticks / 2;
    NoAlloc in_source;
    if (n > 0) {
      now_ns += model.period_ns;
      source.begin_tick(now_ns);
    }
    heard.state = source.state();
    if (heard.stop) {
      StopRequest stop;
      stop.kind = c.stop;
      stop.sequence = 1;
      source.on_stop(stop, now_ns);
    }
    if (n >= kWarmUp) allocations.source += in_source.count();
    NoAlloc in_controller;
    const std::int64_t begin = monotonic_ns();
    loop.on_state(heard.state, now_ns);
    say(c, n, heard, path, loop);
    (void)loop.step(now_ns, heard.command);
    const std::int64_t end = monotonic_ns();
    (void)loop.take_sentence();
    if (n >= kWarmUp) {
      beside.add(end - begin);
      allocations.controller += in_controller.count();
    }
    NoAlloc at_the_end;
    source.on_command(heard.command, now_ns);
    source.end_tick(now_ns);
    if (n >= kWarmUp) allocations.source += at_the_end.count();
  }
  return all;
}

void answer_again(const Model& model, const Case& c, const std::vector<Heard>& all,
                  const std::vector<ArmPathPiece>& path, RateStats& stats,
                  Allocations& allocations) {
  ControlLoop loop(model, control_config(c));
  JointCommand command;
  for (std::size_t n = 0; n < all.size(); ++n) {
    NoAlloc no_alloc;
    const std::int64_t begin = monotonic_ns();
    loop.on_state(all[n].state, all[n].state.time_ns);
    say(c, static_cast<int>(n), all[n], path, loop);
    (void)loop.step(all[n].state.time_ns, command);
    const std::int64_t end = monotonic_ns();
    (void)loop.take_sentence();
    if (n < kWarmUp) continue;
    stats.add(end - begin);
    allocations.controller += no_alloc.count();
  }
}

// The guard's process and the planner's loop on the same states.
void check_again(const Model& model, const std::vector<Heard>& all, RateStats& stats,
                 RateStats& estimate, Allocations& allocations) {
  Guard guard(model, {});
  Estimator estimator(model);
  for (std::size_t n = 0; n < all.size(); ++n) {
    NoAlloc in_planner;
    const std::int64_t begin = monotonic_ns();
    estimator.update(all[n].state);
    const std::int64_t middle = monotonic_ns();
    const std::int64_t planner = in_planner.count();
    NoAlloc in_guard;
    (void)guard.check(all[n].state, &all[n].command, estimator);
    const std::int64_t end = monotonic_ns();
    if (n < kWarmUp) continue;
    estimate.add(middle - begin);
    stats.add(end - middle);
    allocations.planner += planner;
    allocations.guard += in_guard.count();
  }
}

void drive_teleop(Allocations& allocations) {
  for (const bool keyboard : {false, true}) {
    Teleop teleop(5, keyboard);
    teleop.on_source(kRunId, false);
    NoAlloc no_alloc;
    for (int n = 0; n < 1000; ++n) {
      PadInput input;
      input.connected = true;
      input.buttons = n > 100 ? kPadLeftShoulder : 0;
      input.axes[0] = static_cast<std::int16_t>(20 * n);
      if (!keyboard) teleop.on_pad(input);
      if (keyboard && n % 50 == 0) teleop.on_key(kKeyUp, 10'000'000LL * n);
      (void)teleop.message(n, 10'000'000LL * n);
      while (teleop.take_action() != TeleopAction::kNone) {
      }
    }
    allocations.gamepad += no_alloc.count();
  }
}

void print(const Row& row) {
  const RateStats& s = row.stats;
  std::printf("%-44s %9.2f %9.2f %9.2f %9.2f\n", row.name.c_str(), 1e-3 * s.median_ns(),
              1e-3 * s.p99_ns(), 1e-3 * s.p999_ns(), 1e-3 * static_cast<double>(s.max_ns()));
}

void write_csv(const std::string& file, const std::vector<Row>& rows,
               const Allocations& allocations) {
  std::FILE* csv = std::fopen(file.c_str(), "a");
  if (csv == nullptr) throw std::runtime_error(file + " cannot be written");
  for (const Row& row : rows) {
    const RateStats& s = row.stats;
    std::fprintf(csv, "control,\"%s\",cost,us,%.3f,%.3f,%.3f,%.3f,,,\n", row.name.c_str(),
                 1e-3 * s.median_ns(), 1e-3 * s.p99_ns(), 1e-3 * s.p999_ns(),
                 1e-3 * static_cast<double>(s.max_ns()));
  }
  std::fprintf(csv, "control,all loops,allocations,count,%lld,,,,,,\n",
               static_cast<long long>(allocations.sum()));
  if (std::fclose(csv) != 0) throw std::runtime_error(file + " cannot be written");
}

int run(int argc, char** argv) {
  Options options("control_bench",
                  "Costs of a controller tick in each mode, and allocations of every loop.");
  std::string csv, robot = "hrp1s", scene_name = "stand";
  std::int64_t ticks = 4000;
  options.text("--robot", "NAME_OR_DIR", robot, "a robot that can balance");
  options.text("--scene", "NAME_OR_FILE", scene_name, "whose ground and obstacles");
  options.integer("--ticks", "N", ticks, 2 * kWarmUp, 1'000'000, "per mode");
  options.text("--csv", "FILE", csv, "also as rows");
  options.parse(argc, argv);
  const Model model = load_robot(robot);
  const Scene scene = load_scene(scene_name);

  std::vector<Row> rows;
  Allocations allocations;
  Row guard{"guard check, all modes", {}}, estimate{"estimate alone, all modes", {}};
  Row all_modes{"all modes", {}}, all_beside{"all modes, beside the physics", {}};
  for (const Case& c : kCases) {
    Row again{c.name, {}};
    RateStats beside;
    std::vector<ArmPathPiece> path;
    const std::vector<Heard> all =
        record(model, scene, c, static_cast<int>(ticks), beside, path, allocations);
    answer_again(model, c, all, path, again.stats, allocations);
    check_again(model, all, guard.stats, estimate.stats, allocations);
    all_modes.stats.merge(again.stats);
    all_beside.stats.merge(beside);
    rows.push_back(again);
  }
  drive_teleop(allocations);
  for (const Row& row : {all_modes, all_beside, guard, estimate}) rows.push_back(row);

  std::printf("%-44s %9s %9s %9s %9s\n", "microseconds per tick", "median", "p99", "p99.9",
              "worst");
  for (const Row& row : rows) print(row);
  std::printf(
      "allocations: source %lld, controller %lld, guard %lld, planner %lld, gamepad %lld%s\n",
      static_cast<long long>(allocations.source), static_cast<long long>(allocations.controller),
      static_cast<long long>(allocations.guard), static_cast<long long>(allocations.planner),
      static_cast<long long>(allocations.gamepad),
      allocations_counted() ? "" : " (not counted in this build)");
  std::printf("asked: median <= %.0f us, p99 <= %.0f us, no allocation\n", kMedianAsked, kP99Asked);
  if (!csv.empty()) write_csv(csv, rows, allocations);
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("control_bench", twinbus::run, argc, argv);
}
