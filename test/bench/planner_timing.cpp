// Timing of paths: cost, limits kept at 1 kHz, and how much longer than the fastest motion without
// a limit of jerk.
//
//   planner_timing ROBOTS < PATHS    PATHS as planner_cases prints them
//
// The unlimited optimum is found on strides of 1 mrad. A limit of jerk costs at least the time to
// full push for every part from rest to rest; what is left of a motion beyond that is compared with
// the optimum. Prints one line: paths, median [us], paths over a limit, worst use of velocity,
// acceleration and jerk, median and largest (duration - cost of jerk) / optimum and duration /
// optimum.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "planner/timing/motion_effort.h"
#include "planner/timing/path_timing.h"
#include "common/math/index.h"
#include "robot/description/load.h"

namespace twinbus {
namespace {

constexpr double kFullPush = 0.1;  // from rest to the limit of acceleration, as ArmPlanner [s]

// Corners may be rounded: timing is what is measured.
class Open : public FreeSpace {
 public:
  bool point_free(const JointPoint&) override { return true; }
  bool line_free(const JointPoint&, const JointPoint&) override { return true; }
};

int run(const std::string& robots) {
  const std::string folder = robots + "/panda";
  const Model model = load_urdf(folder + "/panda.urdf", {{"panda", folder}}, false);
  TimingLimits limits;
  limits.velocity.resize(7);
  for (int j = 0; j < 7; ++j) limits.velocity[j] = model.joints[at(j)].velocity;
  limits.acceleration = 2.0 * limits.velocity;  // full speed in half a second, as ArmPlanner
  limits.jerk = limits.acceleration / kFullPush;
  MotionEffort effort(model, Configuration(model), {0, 1, 2, 3, 4, 5, 6});
  double torque = 0.0;
  std::vector<double> us, longer, whole;
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
  int over = 0;
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string skip;
    std::size_t points = 0;
    for (int i = 0; i < 5; ++i) words >> skip;
    words >> points;
    JointPath path(points, JointPoint(7));
    for (JointPoint& q : path) {
      for (int j = 0; j < 7; ++j) words >> q[j];
    }
    if (words.fail() || points < 2) continue;
    Open open;
    const std::vector<RoundedPath> parts = RoundedPath::parts(open, path, 0.4);
    const auto t0 = std::chrono::steady_clock::now();
    TimedPath timed = time_path(parts, limits, 0.025, 360);
    const double slower = effort.slower(timed);
    if (slower > 1.0) slow_down(timed, slower);
    us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - t0).count());
    if (timed.empty()) continue;
    const double optimum = fastest_time(parts, limits, 1e-3);
    longer.push_back((timed.back().time - kFullPush * static_cast<double>(parts.size())) / optimum);
    whole.push_back(timed.back().time / optimum);
    double most_velocity = 0.0, most_acceleration = 0.0, most_jerk = 0.0;
    JointPoint q, qd, qdd, before = JointPoint::Zero(7);
    for (double t = 0.0; t <= timed.back().time; t += 1e-3) {
      sample(timed, t, q, qd, qdd);
      most_velocity =
          std::max(most_velocity, qd.cwiseAbs().cwiseQuotient(limits.velocity).maxCoeff());
      most_acceleration =
          std::max(most_acceleration, qdd.cwiseAbs().cwiseQuotient(limits.acceleration).maxCoeff());
      most_jerk = std::max(most_jerk,
                           (qdd - before).cwiseAbs().cwiseQuotient(limits.jerk).maxCoeff() / 1e-3);
      before = qdd;
    }
    TimedPath dense;
    for (double t = 0.0; t <= timed.back().time; t += 1e-3) {
      sample(timed, t, q, qd, qdd);
      dense.push_back({t, q, qd});
    }
    effort.slower(dense);
    torque = std::max(torque, effort.largest());
    over += std::max({most_velocity, most_acceleration, most_jerk, effort.largest()}) > 1.0 + 1e-9
                ? 1
                : 0;
    jerk = std::max(jerk, most_jerk);
    velocity = std::max(velocity, most_velocity);
    acceleration = std::max(acceleration, most_acceleration);
  }
  if (us.empty()) return 1;
  std::sort(us.begin(), us.end());
  std::sort(longer.begin(), longer.end());
  std::sort(whole.begin(), whole.end());
  std::printf(
      "paths %zu median_us %.1f p99_us %.1f over_limits %d velocity %.4f acceleration %.4f jerk "
      "%.4f torque %.4f longer_median %.4f longer_p99 %.4f longer_most %.4f whole_median %.4f "
      "whole_most %.4f\n",
      us.size(), us[us.size() / 2], us[us.size() * 99 / 100], over, velocity, acceleration, jerk,
      torque, longer[longer.size() / 2], longer[longer.size() * 99 / 100], longer.back(),
      whole[whole.size() / 2], whole.back());
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  return twinbus::run(argv[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "planner_timing: %s\n", error.what());
  return 1;
}
