#include "bridge/unitree/motor_table.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {

// "A or B" of ankle and waist are pitch and roll in mode_pr 0.
constexpr const char* kG1[] = {
    "left_hip_pitch_joint",       "left_hip_roll_joint",       "left_hip_yaw_joint",         "left_knee_joint",
    "left_ankle_pitch_joint",     "left_ankle_roll_joint",     "right_hip_pitch_joint",      "right_hip_roll_joint",
    "right_hip_yaw_joint",        "right_knee_joint",          "right_ankle_pitch_joint",    "right_ankle_roll_joint",
    "waist_yaw_joint",            "waist_roll_joint",          "waist_pitch_joint",          "left_shoulder_pitch_joint",
    "left_shoulder_roll_joint",   "left_shoulder_yaw_joint",   "left_elbow_joint",           "left_wrist_roll_joint",
    "left_wrist_pitch_joint",     "left_wrist_yaw_joint",      "right_shoulder_pitch_joint", "right_shoulder_roll_joint",
    "right_shoulder_yaw_joint",   "right_elbow_joint",         "right_wrist_roll_joint",     "right_wrist_pitch_joint",
    "right_wrist_yaw_joint"};
constexpr const char* kGo2[] = {"FR_hip_joint",   "FR_thigh_joint", "FR_calf_joint", "FL_hip_joint",
                                "FL_thigh_joint", "FL_calf_joint",  "RR_hip_joint",  "RR_thigh_joint",
                                "RR_calf_joint",  "RL_hip_joint",   "RL_thigh_joint", "RL_calf_joint"};
constexpr const char* kGo1[] = {"FR_hip_joint",   "FR_thigh_joint", "FR_calf_joint", "FL_hip_joint",
                                "FL_thigh_joint", "FL_calf_joint",  "RR_hip_joint",  "RR_thigh_joint",
                                "RR_calf_joint",  "RL_hip_joint",   "RL_thigh_joint", "RL_calf_joint"};

// A build of the robot that lacks motors and is called by another mode_machine.
struct Build {
  std::span<const int> absent;
  int mode_machine;
};
constexpr int kWaistLocked[] = {13, 14};
constexpr int kTwentyThree[] = {13, 14, 20, 21, 27, 28};  // waist locked, wrists that roll only
constexpr Build kG1Builds[] = {{kWaistLocked, 6}, {kTwentyThree, 4}};

struct MotorTable {
  const char* robot;
  UnitreeFamily family;
  int mode_machine;
  std::span<const char* const> joints;
  std::span<const Build> builds;
};
// Go1 speaks another wire format than Go2 itself; its motors have the same order, so programs for Go2 drive its model.
constexpr MotorTable kTables[] = {{"G1", UnitreeFamily::kHg, 5, kG1, kG1Builds},
                                  {"Go2", UnitreeFamily::kGo, 0, kGo2, {}},
                                  {"Go1", UnitreeFamily::kGo, 0, kGo1, {}}};
constexpr std::size_t kNamed = 6;  // joints in an error

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return text;
}

std::vector<std::string> not_in(const Model& model, const MotorTable& table) {
  std::vector<std::string> strangers;
  for (const int joint : model.bus_joints) {
    const std::string& name = model.joints[at(joint)].name;
    if (std::find(table.joints.begin(), table.joints.end(), name) == table.joints.end()) strangers.push_back(name);
  }
  return strangers;
}

}  // namespace

const char* family_name(UnitreeFamily family) noexcept {
  return family == UnitreeFamily::kHg ? "unitree_hg" : "unitree_go";
}

MotorOrder motor_order(const Model& model, UnitreeFamily family) {
  const MotorTable* best = nullptr;
  std::vector<std::string> strangers;
  bool named = false;
  for (const MotorTable& table : kTables) {
    if (table.family != family) continue;
    std::vector<std::string> left = not_in(model, table);
    // Two robots may name their joints alike: the name of the model says which it is.
    const bool name_fits = lower(model.name).find(lower(table.robot)) != std::string::npos;
    const bool as_good = left.size() == strangers.size();
    if (best != nullptr && (left.size() > strangers.size() || (as_good && (named || !name_fits)))) continue;
    best = &table;
    strangers = std::move(left);
    named = name_fits;
  }
  if (!strangers.empty()) {
    std::string list;
    for (std::size_t k = 0; k < std::min(kNamed, strangers.size()); ++k) list += (k > 0 ? ", " : "") + strangers[k];
    if (strangers.size() > kNamed) list += " and " + std::to_string(strangers.size() - kNamed) + " more";
    throw std::runtime_error("robot " + model.name + ": " + list + ": no motor of " + best->robot + ", the nearest " +
                             family_name(family) +
                             " robot, is called so; joints that have no motor go under fixed_joints: of robot.yaml, other names into "
                             "bridge/unitree/motor_table.cpp");
  }
  MotorOrder order;
  order.robot = best->robot;
  order.mode_machine = best->mode_machine;
  order.bus_index.fill(-1);
  for (std::size_t m = 0; m < best->joints.size(); ++m) {
    const int joint = model.find_joint(best->joints[m]);
    order.bus_index[m] = joint < 0 ? -1 : model.bus_index[at(joint)];
    if (order.bus_index[m] < 0) order.absent.push_back(static_cast<int>(m));
  }
  for (const Build& build : best->builds) {
    if (std::ranges::equal(build.absent, order.absent)) order.mode_machine = build.mode_machine;
  }
  if (order.absent.size() == best->joints.size()) {
    throw std::runtime_error("robot " + model.name + " has no joint of a " + family_name(family) + " robot");
  }
  return order;
}

}  // namespace twinbus::bridge
