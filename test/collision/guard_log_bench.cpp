// `twinbus bench guard_log`: what a guard would have said of a recorded run, and how near the two then came.  Of a run without
// a guard (a stack without that process) this tells which of its stops would have been false.
//
// Each time when it begins to hold joints or to ask for a stop is told: who comes near whom, what it foretells, and the smallest
// distance that the log has of the two within --within.  A stop after which they stay farther apart than the margin was false.
// Exit status 1 when one was.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "common/math/index.h"
#include "common/process/options.h"
#include "control/guard/guard_watch.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "robot/collision/collision.h"
#include "robot/description/load.h"
#include "viewer_log/log/log_reader.h"

using namespace twinbus;

namespace {

constexpr double kAnywhere = 100.0;  // [m]
constexpr std::size_t kQuiet = 25;   // ticks after which an occasion is another one

struct Occasion {
  std::size_t tick = 0;  // of the states
  bool stop = false;
  GuardCause cause;
};

struct Watched {
  std::vector<RobotState> states;  // of the active source
  std::vector<Occasion> occasions;
  long stop_ticks = 0, held_ticks = 0;
};

// As the guard process hears them.
Watched watch(const Model& model, const std::string& log, double margin) {
  Watched result;
  GuardWatch guard(model, {.margin = margin});
  LogReader reader(log);
  std::int64_t run = 0, term = 0, tick = 0;
  std::array<std::size_t, 2> last{};  // of holds and stops
  for (LogEvent event; reader.next(event);) {
    JointCommand command;
    RobotState state;
    if (event.channel == channel::kCommand && decode(event.data, command) == Status::kOk) {
      if (command.run_id == run && command.term == term && command.joint_count == model.bus_count() && command.tick <= tick)
        guard.on_command(command);
    } else if (event.channel == channel::kState && decode(event.data, state) == Status::kOk) {
      if (state.model_hash != model.hash) throw std::runtime_error(log + ": of another robot than " + model.name);
      run = state.run_id, term = state.term, tick = state.tick;
      const GuardReport report = guard.judge(state);
      result.states.push_back(state);
      result.stop_ticks += report.stop_asked ? 1 : 0;
      result.held_ticks += report.hold_mask != 0 ? 1 : 0;
      for (const bool stop : {false, true}) {
        if (!(stop ? report.stop_asked : report.hold_mask != 0)) continue;
        std::size_t& before = last[stop ? 1 : 0];
        if (before == 0 || result.states.size() - before > kQuiet)
          result.occasions.push_back({result.states.size() - 1, stop, guard.cause()});
        before = result.states.size();
      }
    }
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_log_bench", "What a guard would have said of a recorded run, and how near the two then came.");
  std::string robot = "hrp1s", log;
  double margin_mm = 6.0, within = 0.1;
  options.text("--log", "FILE", log, "a run.log");
  options.text("--robot", "NAME", robot, "a name under config/robots, or a folder");
  options.number("--margin-mm", "MM", margin_mm, 0.0, 100.0, "of the guard; that of its process is 6");
  options.number("--within", "S", within, 0.0, 10.0, "time in which it counts how near they come");
  options.parse(argc, argv);

  const Model model = load_robot(robot);
  const Watched run = watch(model, log, 1e-3 * margin_mm);
  Collision collision(model, false);
  Kinematics kinematics(model);
  Configuration now(model);
  const auto ahead = static_cast<std::size_t>(within / model.period());
  int stops = 0, false_stops = 0;
  for (const Occasion& occasion : run.occasions) {
    std::array<char, 200> text{};
    describe(model, {}, occasion.cause, text);
    const double time = static_cast<double>(occasion.tick) * model.period();
    std::printf("%.3f s %s: %s", time, occasion.stop ? "stop" : "hold", text.data());
    double least = kAnywhere;
    const std::size_t end = occasion.cause.link_a >= 0 ? std::min(run.states.size(), occasion.tick + ahead) : 0;
    for (std::size_t n = occasion.tick; n < end; ++n) {
      PairDistance pair;
      set_joints(model, run.states[n], now);
      kinematics.update(now);
      if (collision.pair_nearer_than(kinematics, occasion.cause.link_a, occasion.cause.link_b, kAnywhere, pair))
        least = std::min(least, pair.distance);
    }
    const bool unknown = occasion.cause.link_a < 0 || occasion.tick + ahead > run.states.size();  // no pair, or the log ends before
    const bool apart = !unknown && !(least < occasion.cause.margin);
    if (unknown) std::printf("; how near they came is not known\n");
    else std::printf("; they came to %.1f mm%s\n", 1e3 * least, occasion.stop && apart ? ": FALSE" : "");
    stops += occasion.stop ? 1 : 0;
    false_stops += occasion.stop && apart ? 1 : 0;
  }
  std::printf("%zu ticks: stops asked for %d times (%ld ticks), of them %d false; joints held in %ld ticks\n",
              run.states.size(), stops, run.stop_ticks, false_stops, run.held_ticks);
  return run.states.empty() || false_stops > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_log_bench: %s\n", error.what());
  return 1;
}
