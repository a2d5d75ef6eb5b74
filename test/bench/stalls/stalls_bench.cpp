// A walking robot whose controller falls silent: how often the stop plan keeps it on its feet, or walking.
//
//   stalls_bench SCENE SEED COUNT WHAT...      e.g. stalls_bench walk_forward 1 40 kill 100 other
//
// WHAT: kill; a number of milliseconds that the controller stands still; other: another controller 1 s after the kill,
// other500: after 500 ms; own: the controller lives and makes its shortest stop.  At COUNT random instants of the walk the run is forked, and each WHAT goes on
// from the same state.  Good: it did not fall, is upright and, where it is to stand, at rest with at least 15 % of its weight on
// each foot; the count by the rule of 100 N a foot, which does not know how heavy a robot is, stands beside.  Environment: VX walks at another speed [m/s], ROBOT another robot, SET=key=value a setting of the
// simulator, FROM and UNTIL bound the instants [s].

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "launcher/run/local_stack.h"
#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"

using namespace twinbus;

namespace {

constexpr double kAfter = 4.5;         // watched after the instant [s]
constexpr double kWithinPlan = 1.5;    // a push so soon after the instant is one within the plan [s]
constexpr double kFallen = 0.5;        // [rad]
constexpr double kStandsUpright = 0.15;  // [rad]
constexpr double kStands = 0.03;       // of the centre of mass [m/s]
constexpr float kCarries = 0.15F;        // a foot, of the robot's weight
constexpr float kCarriedOnce = 100.0F;   // the rule before, which light robots miss [N]

double number_of(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atof(text) : otherwise;
}

struct Result {
  bool fell = true, good = false, latched = false;
  bool good_by_newtons = false;  // by the rule before
  double lighter = 0.0;          // foot at the end, of the weight
  double tilt = 0.0, torque_step = 0.0;  // [rad]; largest of the effort limit, at the first tick that is led
  int stop_kind = 0, stop_reason = 0;
  double pushed_at = -1.0;  // first, after the instant [s]; < 0: not pushed
};

double tilt_of(const SimTruth& t) {
  const double x = t.base_attitude[1], y = t.base_attitude[2];
  return std::acos(std::clamp(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0));
}

// What the servos are asked for, of the effort limit, for one measured state; the set-point's own way is no step.
double law_step(const Model& m, const JointCommand& a, const JointCommand& b, const RobotState& s) {
  double most = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.bus_count()); ++i) {
    const auto law = [&](const JointCommand& c) {
      return static_cast<double>(c.tau[i]) + static_cast<double>(c.kp[i]) * (c.q[i] - s.q[i]) +
             static_cast<double>(c.kd[i] * (c.qd[i] - s.qd[i]));
    };
    const double goes_on = static_cast<double>(b.kp[i] * b.qd[i]) * m.period();
    most = std::max(most, std::abs(law(a) - law(b) - goes_on) /
                              m.joints[static_cast<std::size_t>(m.bus_joints[i])].effort);
  }
  return most;
}

Result watch(const Model& model, OneProcess& run, const std::string& what) {
  Result r;
  const bool kill = what == "kill", other = what.rfind("other", 0) == 0, own = what == "own";
  const auto ticks = [&](double seconds) { return static_cast<std::int64_t>(seconds / model.period()); };
  const double later = other && what.size() > 5 ? 1e-3 * std::atof(what.c_str() + 5) : 1.0;
  const std::int64_t begin = run.ticks();
  if (own) {
    ModeRequest request;
    request.mode = Mode::kStop;
    run.say(request);
  } else {
    run.stall_controller(kill || other ? -1.0 : 1e-3 * std::atof(what.c_str()));
  }
  const JointCommand before = run.source().effective_command();
  bool fell = false;
  for (std::int64_t i = 0; run.ticks() < begin + ticks(kAfter) && !fell; ++i) {
    if (!run.tick()) break;
    if (i == 0) r.torque_step = law_step(model, run.source().effective_command(), before, run.state());
    if (other && i == ticks(later)) run.restart_controller(77);
    const SimTruth& t = run.truth();
    if (std::getenv("TRACE") != nullptr && i % std::atoi(std::getenv("TRACE")) == 0) {
      double jump = 0.0;
      for (std::size_t j = 0; j < 12; ++j)
        jump = std::max(jump, std::abs(run.source().effective_command().q[j] - run.state().q[j]));
      std::printf("%lld plan %d mode %d tilt %.2f com %.3f %.3f v %.3f %.3f F %.0f %.0f q-gap %.4f zmp margin %.3f\n",
                  static_cast<long long>(i), run.state().plan_number, static_cast<int>(run.loop().status().mode),
                  57.3 * tilt_of(t), static_cast<double>(t.com[0]), static_cast<double>(t.com[1]),
                  static_cast<double>(t.com_velocity[0]), static_cast<double>(t.com_velocity[1]),
                  static_cast<double>(t.foot_force[0][2]), static_cast<double>(t.foot_force[1][2]), jump,
                  static_cast<double>(t.zmp_margin));
    }
    const bool pushed = t.push_force != decltype(t.push_force){};
    if (pushed && r.pushed_at < 0.0) r.pushed_at = static_cast<double>(run.ticks() - begin) * model.period();
    r.tilt = std::max(r.tilt, tilt_of(t));
    fell = t.fell || tilt_of(t) > kFallen;
  }
  if (std::getenv("VERBOSE") != nullptr && !run.stop_cause().empty()) std::printf("  %s\n", run.stop_cause().c_str());
  const SimTruth& t = run.truth();
  const float lighter = std::min(t.foot_force[0][2], t.foot_force[1][2]);
  r.lighter = static_cast<double>(lighter) / (kGravity * model.total_mass());
  const double speed = std::hypot(static_cast<double>(t.com_velocity[0]), static_cast<double>(t.com_velocity[1]));
  r.fell = fell;
  r.stop_kind = static_cast<int>(run.source().status().stop_kind);
  r.stop_reason = static_cast<int>(run.source().status().stop_reason);
  r.latched = run.state().stop_kind != StopKind::kNone;
  r.good = !fell && tilt_of(t) < kStandsUpright;
  if (kill || own || other) r.good = r.good && speed < kStands;
  if (kill) r.good = r.good && r.latched;
  if (!kill && !own) r.good = r.good && !r.latched;
  r.good_by_newtons = r.good;
  if (kill || own || other) {
    r.good = r.good && r.lighter > static_cast<double>(kCarries);
    r.good_by_newtons = r.good_by_newtons && lighter > kCarriedOnce;
  }
  return r;
}

double part_of(std::vector<double> x, double q) {
  if (x.empty()) return 0.0;
  std::sort(x.begin(), x.end());
  return x[static_cast<std::size_t>(q * static_cast<double>(x.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "stalls_bench SCENE SEED COUNT WHAT...; WHAT is kill, own, other or milliseconds\n");
    return 2;
  }
  const auto seed = std::strtoull(argv[2], nullptr, 10);
  const int count = std::atoi(argv[3]);
  Scene scene = load_scene(argv[1]);
  const double vx = number_of("VX", 0.0);
  for (TimedWalk& walk : scene.walks) {
    if (vx > 0.0) walk.request.vx = static_cast<float>(vx);
  }
  const char* robot = std::getenv("ROBOT");
  const Model model = load_robot(robot != nullptr ? robot : scene.robot.empty() ? "hrp1s" : scene.robot);
  resolve_poses(scene, model);
  apply_seed(scene, model, seed);
  OneProcessConfig config;
  config.seed = seed;
  if (const char* set = std::getenv("SET")) {
    const std::string word = set;
    config.settings.emplace_back(word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
  }
  OneProcess run(model, scene, config);
  double until = 0.0;
  for (const TimedWalk& walk : scene.walks) until = std::max(until, walk.at + walk.duration);
  until = number_of("UNTIL", std::min(until, scene.duration - 0.1));
  const double from = number_of("FROM", 2.0);
  std::mt19937_64 random(seed * 104729 + 5);
  std::vector<std::int64_t> instants;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(random() % 1000003) / 1000003.0;
    instants.push_back(static_cast<std::int64_t>((from + (until - from) * share) / model.period()));
  }
  std::sort(instants.begin(), instants.end());
  std::map<std::string, std::vector<Result>> results;
  for (const std::int64_t instant : instants) {
    while (run.ticks() < instant && run.tick()) {
    }
    for (int i = 4; i < argc; ++i) {
      int fd[2];
      if (pipe(fd) != 0) return 1;
      std::fflush(stdout);
      const pid_t child = fork();
      if (child == 0) {
        const Result r = watch(model, run, argv[i]);
        std::fflush(stdout);
        _exit(write(fd[1], &r, sizeof r) == sizeof r ? 0 : 1);
      }
      close(fd[1]);
      Result r;
      const bool got = read(fd[0], &r, sizeof r) == sizeof r;
      close(fd[0]);
      waitpid(child, nullptr, 0);
      if (!got) std::fprintf(stderr, "a run ended early: %s at tick %lld\n", argv[i], static_cast<long long>(instant));
      results[argv[i]].push_back(r);
      if (std::getenv("VERBOSE") != nullptr && !r.good) {
        std::printf("  %s at %.3f s: fell %d stop %d reason %d tilt %.1f\n", argv[i],
                    static_cast<double>(instant) * model.period(), r.fell, r.stop_kind, r.stop_reason, 57.3 * r.tilt);
      }
    }
  }
  for (int i = 4; i < argc; ++i) {
    int good = 0, fell = 0, latched = 0, by_newtons = 0;
    double lighter = 1.0;  // foot of those that stand
    std::array<int, 3> pushed{}, pushed_good{};  // within the plan, later, never
    std::vector<double> step, tilt;
    for (const Result& r : results[argv[i]]) {
      good += r.good;
      by_newtons += r.good_by_newtons;
      if (!r.fell) lighter = std::min(lighter, r.lighter);
      fell += r.fell;
      latched += r.latched;
      const std::size_t when = r.pushed_at < 0.0 ? 2 : r.pushed_at <= kWithinPlan ? 0 : 1;
      ++pushed[when];
      pushed_good[when] += r.good;
      step.push_back(r.torque_step);
      if (r.good) tilt.push_back(57.3 * r.tilt);
    }
    std::printf("%s seed %llu %s: good %d of %zu (%d if a foot is to carry 100 N), fell %d, latched %d, lightest foot %.2f of the weight; torque step %.3f p95 %.3f max %.3f; tilt %.1f max %.1f",
                argv[1], seed, argv[i], good, step.size(), by_newtons, fell, latched, lighter, part_of(step, 0.5), part_of(step, 0.95),
                part_of(step, 1.0), part_of(tilt, 0.5), part_of(tilt, 1.0));
    if (pushed[2] < static_cast<int>(step.size())) {
      std::printf("; pushed within the plan: good %d of %d, later %d of %d, not pushed %d of %d", pushed_good[0], pushed[0],
                  pushed_good[1], pushed[1], pushed_good[2], pushed[2]);
    }
    std::printf("\n");
  }
  return 0;
}
