// What a walk looks like tick by tick: foot forces measured and asked, where the base is, what the guard took.
//
//     walk_trace_bench [--robot R] [--speed V] [--engine E] [--set KEY=VALUE]... [--guard] [--for S]
//
// Prints CSV: time [s], force and asked of the left and right foot [N], base x, y [m], roll, pitch [rad], guard [us of CPU].

#include <cstdio>
#include <ctime>
#include <string>

#include "control/guard/guard.h"
#include "robot/estimation/estimator.h"
#include "robot/description/load.h"
#include "common/math/pose_math.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

// Without what preempts the thread.
std::int64_t thread_cpu_ns() {
  timespec now{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1'000'000'000 * std::int64_t{now.tv_sec} + now.tv_nsec;
}

constexpr double kStands = 0.5,
                 kStarts = 3.0;  // before walking is asked for, before it is drawn [s]

int run(int argc, char** argv) {
  std::string robot = "hrp1s";
  double speed = 0.55, seconds = 3.0;
  Scene scene;
  Settings settings;
  ControlConfig control;
  control.guard_in_loop = false;
  bool guarded = false;
  Options options("walk_trace_bench", "A walk tick by tick.");
  options.text("--robot", "R", robot, "name or folder");
  options.number("--speed", "V", speed, -2.0, 2.0, "[m/s]");
  options.text("--engine", "E", scene.engine, "articulated, ode or mujoco");
  options.settings("--set", settings, "of the simulator");
  options.flag("--guard", guarded, "times the guard too");
  options.number("--for", "S", seconds, 0.0, 3600.0, "of walking");
  options.parse(argc, argv);
  const Model model = load_robot(robot);
  SimRig rig(model, scene, settings, control);
  if (!rig.run(kStands)) return 1;
  rig.ask(Mode::kWalk);
  WalkCommand walk;
  walk.run_id = rig.state().run_id;
  walk.vx = static_cast<float>(speed);
  walk.timeout = 0.1F;
  Guard guard(model, GuardConfig{});
  Estimator estimator(model);
  std::printf("time,left,left_asked,right,right_asked,x,y,roll,pitch,guard_us\n");
  const auto first = static_cast<std::int64_t>((kStands + kStarts) / model.period());
  const auto last = first + static_cast<std::int64_t>(seconds / model.period());
  while (rig.ticks() < last) {
    if (rig.ticks() % 10 == 0) {
      ++walk.sequence;
      rig.loop().on_walk_command(walk, rig.state().time_ns);
    }
    if (!rig.tick() || rig.record().fell) {
      std::fprintf(stderr, "walk_trace_bench: the walk ended\n");
      return 1;
    }
    double guard_us = 0.0;
    if (guarded) {
      estimator.update(rig.state());
      const std::int64_t start = thread_cpu_ns();
      (void)guard.check(rig.state(), &rig.command(), estimator);
      guard_us = 1e-3 * static_cast<double>(thread_cpu_ns() - start);
    }
    if (rig.ticks() < first) continue;
    const SimTruth& t = rig.truth();
    const std::array<double, 2> asked = rig.loop().foot_forces();
    const Eigen::Vector3d rpy =
        rpy_from_rotation(quaternion_from_array(t.base_attitude).toRotationMatrix());
    std::printf("%.3f,%.1f,%.1f,%.1f,%.1f,%.4f,%.4f,%.5f,%.5f,%.2f\n",
                model.period() * static_cast<double>(rig.ticks() - first),
                static_cast<double>(t.foot_force[0][2]), asked[0],
                static_cast<double>(t.foot_force[1][2]), asked[1],
                static_cast<double>(t.base_position[0]), static_cast<double>(t.base_position[1]),
                rpy.x(), rpy.y(), guard_us);
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_trace_bench", twinbus::run, argc, argv);
}
