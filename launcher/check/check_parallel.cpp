#include "launcher/check/check_parallel.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "common/math/index.h"
#include "robot/description/parallel_joints.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline launcher {

namespace {

struct HeldPosture {
  std::string pose;
  Eigen::Vector2d q;
  RodPosture posture;
};

// half_sitting where the robot has it and the rods reach it, else all joints at 0.
HeldPosture held_posture(const Model& model, const ParallelJoints& pair) {
  HeldPosture out{.pose = "the zero posture", .q = middle_of(pair.box), .posture{}};
  if (model.find_pose("half_sitting") >= 0) {
    const Eigen::Vector2d q = pair.of(Configuration(model, "half_sitting").q);
    if (pair.drive.at(q, out.posture)) out = {.pose = "half_sitting", .q = q, .posture{}};
  }
  (void)pair.drive.at(out.q, out.posture);
  return out;
}

}  // namespace

void print_parallel_joints(const Model& model) {
  for (const ParallelJoints& pair : parallel_joints_of(model)) {
    const Joint& first = model.joints[at(pair.joints[0])];
    const Joint& second = model.joints[at(pair.joints[1])];
    const HeldPosture held = held_posture(model, pair);
    const Eigen::Vector2d alone = torque_alone(pair.drive, held.posture), both = torque_box(pair.drive, held.posture);
    const DriveMargins margins = margins_in(pair.drive, pair.box);
    std::printf("%s and %s are turned by motors %s and %s over rods of %.0f and %.0f mm%s\n", first.name.c_str(), second.name.c_str(),
                pair.drive.motor(0).name.c_str(), pair.drive.motor(1).name.c_str(), 1e3 * pair.drive.rod_length(0),
                1e3 * pair.drive.rod_length(1), pair.driver_of_motors ? "; the robot's driver speaks of the motors" : "");
    std::printf("  range %.3f to %.3f and %.3f to %.3f rad, in which the motors turn %.3f to %.3f and %.3f to %.3f rad\n",
                pair.box.lower[0], pair.box.upper[0], pair.box.lower[1], pair.box.upper[1], margins.lower[0], margins.upper[0],
                margins.lower[1], margins.upper[1]);
    std::printf("  torque in %s: %.1f N m in %s alone, %.1f in %s alone, %.1f and %.1f both at once\n", held.pose.c_str(), alone[0],
                first.name.c_str(), alone[1], second.name.c_str(), both[0], both[1]);
    std::printf("  nearest to singular in its range: sine between crank and rod %.2f (at least %.2f), levers %.2f (at least %.2f)\n",
                margins.crank_sine, kLeastCrankSine, margins.foot_share, kLeastFootShare);
  }
}

nlohmann::json parallel_joints_json(const Model& model) {
  nlohmann::json list = nlohmann::json::array();
  for (const ParallelJoints& pair : parallel_joints_of(model)) {
    const HeldPosture held = held_posture(model, pair);
    const Eigen::Vector2d alone = torque_alone(pair.drive, held.posture), both = torque_box(pair.drive, held.posture);
    const DriveMargins margins = margins_in(pair.drive, pair.box);
    nlohmann::json entry = {{"posture", held.pose},
                            {"torque_both_at_once", {both[0], both[1]}},
                            {"crank_sine", margins.crank_sine},
                            {"levers", margins.foot_share},
                            {"driver", pair.driver_of_motors ? "motors" : "joints"}};
    for (const int i : {0, 1}) {
      const RodMotor& motor = pair.drive.motor(i);
      entry["joints"].push_back({{"name", model.joints[at(pair.joints[at(i)])].name},
                                 {"lower", pair.box.lower[i]},
                                 {"upper", pair.box.upper[i]},
                                 {"torque_alone", alone[i]}});
      entry["motors"].push_back({{"name", motor.name},
                                 {"rod_m", pair.drive.rod_length(i)},
                                 {"torque", motor.torque},
                                 {"speed", motor.speed},
                                 {"lower", margins.lower[i]},
                                 {"upper", margins.upper[i]}});
    }
    list.push_back(entry);
  }
  return list;
}

}  // namespace twinbus::launcher
