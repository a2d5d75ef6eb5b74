// Timing of paths: cost, limits kept at 1 kHz, and how much longer than without any smoothing.
//
//   planner_timing ROBOTS < PATHS    PATHS as planner_cases prints them
//
// Prints one line: paths, median [us], paths over a limit, worst use of velocity and acceleration,
// median and largest duration against the same path timed without smoothing.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "planner/path_timing.h"
#include "robot/index.h"
#include "robot/load.h"

namespace twinbus {
namespace {

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
  TimingLimits sharp = limits;
  sharp.smoothing = 1e-3;
  std::vector<double> us, longer;
  double velocity = 0.0, acceleration = 0.0;
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
    const TimedPath timed = time_path(parts, limits, 0.04, 360);
    us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - t0).count());
    const TimedPath optimum = time_path(parts, sharp, 0.04, 360);
    if (timed.empty() || optimum.empty()) continue;
    longer.push_back(timed.back().time / optimum.back().time);
    double most_velocity = 0.0, most_acceleration = 0.0;
    JointPoint q, qd, qdd;
    for (double t = 0.0; t <= timed.back().time; t += 1e-3) {
      sample(timed, t, q, qd, qdd);
      most_velocity =
          std::max(most_velocity, qd.cwiseAbs().cwiseQuotient(limits.velocity).maxCoeff());
      most_acceleration =
          std::max(most_acceleration, qdd.cwiseAbs().cwiseQuotient(limits.acceleration).maxCoeff());
    }
    over += most_velocity > 1.0 + 1e-9 || most_acceleration > 1.0 + 1e-9 ? 1 : 0;
    velocity = std::max(velocity, most_velocity);
    acceleration = std::max(acceleration, most_acceleration);
  }
  if (us.empty()) return 1;
  std::sort(us.begin(), us.end());
  std::sort(longer.begin(), longer.end());
  std::printf(
      "paths %zu median_us %.1f p99_us %.1f over_limits %d velocity %.4f acceleration %.4f "
      "longer_median %.4f longer_most %.4f\n",
      us.size(), us[us.size() / 2], us[us.size() * 99 / 100], over, velocity, acceleration,
      longer[longer.size() / 2], longer.back());
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
