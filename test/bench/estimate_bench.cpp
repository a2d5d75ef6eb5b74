// How far the velocity of the base that ESTIMATE says is from TRUTH, over the STATE of a log.
//
//   estimate_bench ROBOT LOG [--no-forces] [--from S] [--to S] [--most M]
//
// Prints the root of the mean square, and the largest, of the error of the origin of the base in the heading frame of the base
// [m/s]: forward, left, up; of robot/estimation/inertial_leg_odometry.h run over the STATE of the log, of the controller's
// own estimator, and of ESTIMATE as it was logged, if it was.  --no-forces: the robot has no force sensors at its feet.
// --most: exit status 1 when the odometry, or ESTIMATE, is off by more forward.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "common/math/pose_math.h"
#include "common/process/arguments.h"
#include "common/process/process.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/messages.h"
#include "robot/description/load.h"
#include "robot/estimation/estimator.h"
#include "robot/estimation/inertial_leg_odometry.h"
#include "viewer_log/log/log_reader.h"

using namespace twinbus;

namespace {

struct Error {
  Eigen::Array3d square = Eigen::Array3d::Zero(), worst = Eigen::Array3d::Zero(), mean = Eigen::Array3d::Zero();
  Eigen::Array3d expected = Eigen::Array3d::Zero();  // variance that was said
  int count = 0;
  void add(const Eigen::Vector3d& found, const Eigen::Vector3d& truth, const Eigen::Vector3d& deviation) {
    const Eigen::Array3d off = (found - truth).array();
    square += off.square();
    mean += off;
    worst = worst.max(off.abs());
    expected += deviation.array().square();
    ++count;
  }
  double forward() const { return std::sqrt(square[0] / count); }  // root of the mean square [m/s]
  void print(const char* name) const {
    if (count == 0) return;
    const Eigen::Array3d rms = (square / count).sqrt(), said = (expected / count).sqrt();
    std::printf("%-22s rms %.4f %.4f %.4f  worst %.3f %.3f %.3f  mean %+.4f %+.4f  said %.3f  of %d ticks\n", name, rms[0], rms[1], rms[2],
                worst[0], worst[1], worst[2], mean[0] / count, mean[1] / count, said[0], count);
  }
};

Eigen::Vector3d in_heading(const Eigen::Matrix3d& base, const Eigen::Vector3d& velocity) {
  return rotation_z(-yaw_of(base)) * velocity;
}

Eigen::Matrix3d base_of(const Estimate& e) { return quaternion_from_array(e.base_attitude).toRotationMatrix(); }

int run(const std::string& robot, const std::string& file, bool forces, double from, double to, double most) {
  const Model model = load_robot(robot);
  InertialLegOdometry odometry(model);
  Estimator estimator(model);
  std::map<std::int64_t, std::pair<Eigen::Vector3d, Eigen::Vector3d>> found;  // tick: odometry, estimator; heading frames
  std::map<std::int64_t, Eigen::Vector3d> logged, deviation;
  Error of_odometry, of_estimator, of_logged;
  LogReader log(file);
  LogEvent event;
  std::int64_t first = -1, last = -1;
  double spent = 0.0, speed = 0.0, height_error = 0.0;
  std::map<std::int64_t, double> height;
  int states = 0, stands = 0, feet = 0;
  LoadFrom source = LoadFrom::kUnknown;
  while (log.next(event)) {
    if (event.channel == channel::kState) {
      RobotState state;
      if (decode(event.data, state) != Status::kOk || state.tick == last) continue;
      last = state.tick;
      if (first < 0) first = state.tick;
      if (!forces) state.wrench_kind.fill(WrenchKind::kAbsent);
      const auto begin = std::chrono::steady_clock::now();
      odometry.update(state);
      spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      estimator.update(state);
      const Estimate& e = odometry.estimate();
      found[state.tick] = {in_heading(base_of(e), vector_from_array(e.base_velocity)),
                           in_heading(estimator.configuration().base.linear(), estimator.configuration().base_velocity)};
      deviation[state.tick] = vector_from_array(e.velocity_deviation);
      height[state.tick] = e.base_position[2];
      feet = e.foot_count;
      source = e.load_from;
      for (const bool one : e.foot_stands) stands += one ? 1 : 0;
      ++states;
    } else if (event.channel == channel::kEstimate) {
      Estimate e;
      if (decode(event.data, e) == Status::kOk) logged[e.tick] = in_heading(base_of(e), vector_from_array(e.base_velocity));
    } else if (event.channel == channel::kTruth) {
      SimTruth truth;
      if (decode(event.data, truth) != Status::kOk || !found.contains(truth.tick)) continue;
      const double time = model.period() * static_cast<double>(truth.tick - first);
      const auto [a, b] = found[truth.tick];
      if (!(time >= from && time <= to)) continue;
      const Eigen::Vector3d velocity =
          in_heading(quaternion_from_array(truth.base_attitude).toRotationMatrix(), vector_from_array(truth.base_velocity));
      speed += velocity.x();
      height_error += std::pow(height[truth.tick] - truth.base_position[2], 2);
      of_odometry.add(a, velocity, deviation[truth.tick]);
      of_estimator.add(b, velocity, Eigen::Vector3d::Zero());
      if (logged.contains(truth.tick)) of_logged.add(logged[truth.tick], velocity, Eigen::Vector3d::Zero());
      found.erase(found.begin(), found.find(truth.tick));
    }
  }
  if (of_odometry.count == 0) {
    std::fprintf(stderr, "estimate_bench: %s: no STATE with a TRUTH of the same tick: record a simulator\n", file.c_str());
    return 1;
  }
  std::printf("%s, %s: %.3f m/s forward; %d feet, %.2f stand; load from %d; %.1f us a tick; height rms %.4f m\n", file.c_str(),
              forces ? "with what it measures" : "without foot forces", speed / of_odometry.count, feet,
              static_cast<double>(stands) / std::max(1, states), static_cast<int>(source), 1e6 * spent / std::max(1, states),
              std::sqrt(height_error / of_odometry.count));
  of_odometry.print("accelerometer and feet");
  of_estimator.print("estimator");
  of_logged.print("ESTIMATE");
  return of_odometry.forward() <= most && (of_logged.count == 0 || of_logged.forward() <= most) ? 0 : 1;
}

int estimate(int argc, char** argv) {
  const Arguments arguments({"bench estimate", 2, 2, R"(ROBOT LOG
Holds the velocity of the base that ESTIMATE says against TRUTH of a log: root of the mean square and largest
error [m/s], forward, left, up, beside the controller's own estimator.
  --no-forces  the robot has no force sensors at its feet
  --from S  of the log; default 1
  --to S  of the log; default its end
  --most M  exit status 1 when an error of ours forward is more, root of the mean square [m/s])"},
                            std::vector<std::string>(argv + 1, argv + argc));
  return run(arguments.word(0), arguments.word(1), !arguments.has("--no-forces"), arguments.number("--from", 1.0, 0.0, 1e9),
             arguments.number("--to", 1e9, 0.0, 1e9), arguments.number("--most", 1e9, 0.0, 1e9));
}

}  // namespace

int main(int argc, char** argv) {
  return twinbus::run_process("bench estimate", &estimate, argc, argv);
}
