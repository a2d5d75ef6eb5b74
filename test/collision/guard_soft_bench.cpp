// `twinbus bench guard_soft`: the guard against clients that swing an arm into the robot with gains of their own, from 5 to
// 3500, in the simulator.  Every swing is one that touches when nothing guards it (test/collision/soft_swings.h).
//
// Exit status 1 when one of them touches with the guard on.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "common/process/options.h"
#include "robot/description/load.h"
#include "test/collision/soft_swings.h"

using namespace twinbus;

namespace {

const Model* told = nullptr;

void story(std::int64_t tick, const RobotState& state, const JointCommand& command, const JointCommand& effective,
           const GuardReport& report, const GuardCause& cause) {
  if (report.pairs_near == 0) return;
  std::printf("tick %lld, nearest %.2f mm (%s, %s), mask %llx%s\n", static_cast<long long>(tick),
              1e3 * static_cast<double>(report.distance[0]), told->links[at(report.link_a[0])].name.c_str(),
              told->links[at(report.link_b[0])].name.c_str(), static_cast<unsigned long long>(report.hold_mask),
              report.stop_asked ? ", asks for a stop" : "");
  if (report.hold_mask != 0 && cause.link_a >= 0) {
    std::array<char, 200> text{};
    describe(*told, {}, cause, text);
    std::printf("  %s\n", text.data());
  }
  for (int k = 0; k < told->bus_count(); ++k) {
    const auto i = at(k);
    if (command.kp[i] == static_cast<float>(told->joints[at(told->bus_joints[i])].kp)) continue;
    std::printf("  %-28s q %7.3f qd %7.2f tau %7.1f asked %7.3f kp %6.0f | written %7.3f kp %6.0f\n",
                told->joints[at(told->bus_joints[i])].name.c_str(), state.q[i], static_cast<double>(state.qd[i]),
                static_cast<double>(state.tau[i]), command.q[i], static_cast<double>(command.kp[i]), effective.q[i],
                static_cast<double>(effective.kp[i]));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_soft_bench", "The guard against clients that swing an arm into the robot, stiffly or softly.");
  std::string robot = "hrp1s";
  std::int64_t swings = 200, first = 0, only = -1, seed = 1;
  double margin_mm = 6.0;
  options.text("--robot", "NAME", robot, "a name under config/robots, or a folder");
  options.integer("--swings", "N", swings, 1, 10'000'000, "that touch without a guard");
  options.integer("--first", "N", first, 0, 10'000'000, "number of the first");
  options.integer("--only", "N", only, -1, 10'000'000, "this one alone, tick by tick");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the swings");
  options.number("--margin-mm", "MM", margin_mm, 0.0, 100.0, "of the guard; that of its process is 6");
  options.parse(argc, argv);

  const Model model = load_robot(robot);
  told = &model;
  SoftSwings clients(model, seed);
  const GuardConfig config{.margin = 1e-3 * margin_mm};
  const std::int64_t begin = only >= 0 ? only : first, end = only >= 0 ? only + 1 : first + swings;
  long braked = 0, fallen = 0;
  std::vector<double> nearest;
  for (std::int64_t n = begin; n < end; ++n) {
    const SoftSwing swing = clients.draw(n);
    if (only >= 0) clients.tell = story;
    const SwingResult result = clients.run(swing, &config);
    if (!result.touched) ++braked;
    if (result.fell) ++fallen;
    nearest.push_back(result.nearest);
    if (!result.touched && only < 0) continue;
    const std::size_t k = swing.moved.front();
    std::printf("swing %lld %s%s: %s, %s, kp %.0f kd %.1f, speed %.1f, begins %.2f s, %s, mask %d ticks late%s\n",
                static_cast<long long>(n), result.touched ? "touches" : "does not touch", result.held ? "" : ", never held",
                swing.stands ? "stands" : "hangs", std::array{"step", "ramp", "to and fro"}[at(swing.way)],
                static_cast<double>(swing.kp[k]), static_cast<double>(swing.kd[k]), swing.speed, swing.begins,
                swing.no_fade ? "no fade" : "faded in", swing.guard_delay, swing.late_command ? ", command a tick late" : "");
    if (result.touched) std::printf("  after %.3f s\n", result.touched_at);
  }
  std::sort(nearest.begin(), nearest.end());
  std::sort(clients.costs.begin(), clients.costs.end());
  const auto share = [](const auto& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
  };
  std::printf("%s: %ld of %lld swings into the robot braked before touch (%ld drawn); they came to %.1f mm, median %.1f mm\n",
              model.name.c_str(), braked, static_cast<long long>(end - begin), clients.drawn, 1e3 * nearest.front(),
              1e3 * share(nearest, 0.5));
  if (fallen > 0) std::printf("%ld of them ended by a fall of the robot, untouched until then\n", fallen);
  std::printf("guard per tick: median %.1f us, p99 %.1f us, worst %.1f us\n",
              1e-3 * static_cast<double>(share(clients.costs, 0.5)), 1e-3 * static_cast<double>(share(clients.costs, 0.99)),
              1e-3 * static_cast<double>(clients.costs.back()));
  return braked == end - begin ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_soft_bench: %s\n", error.what());
  return 1;
}
