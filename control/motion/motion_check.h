// What is wrong with a motion before it plays: limits of the joints, links that touch, balance, efforts.
//
// Looked at is what the robot would do: joints of no leg as the motion has them, legs as balance moves them over soles that
// stand (whole-body inverse kinematics), or every joint as the file has it, for whoever plays it by a policy of his own.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/description/model.h"
#include "robot/motion/motion_clip.h"

namespace twinbus::inline control {

enum class FaultKind : std::int8_t { kPosition, kSpeed, kEffort, kTouch, kBalance, kReach };

const char* label(FaultKind kind) noexcept;

// A stretch of ticks in which one thing is wrong; the worst of it.
struct MotionFault {
  FaultKind kind = FaultKind::kPosition;
  std::int64_t tick = 0, last_tick = 0;  // of the robot's period, from the begin of the motion
  std::int64_t worst_tick = 0;
  std::string what;  // joint, two links, or soles
  double value =
      0.0;  // at the worst tick: rad or m, per second, N m or N; m from each other; m inside the soles
  double limit = 0.0;
};

struct MotionVerdict {
  std::vector<MotionFault> faults;  // by tick
  std::int64_t ticks = 0;
  // The nearest to its limit, whether wrong or not.
  double speed_share = 0.0, effort_share = 0.0;  // of a limit
  std::string speed_joint, effort_joint;
  double nearest = 0.0;  // two links, if any came within 50 mm [m]
  std::string nearest_pair;
  double least_margin = 0.0;  // of the zero-moment point inside the soles [m]
  bool balance_known = false;
  // The way from standing to the first frame and back has faults, which are listed with tick -1.
  bool passed() const { return faults.empty(); }
};

struct MotionCheckConfig {
  bool as_recorded = false;
  double link_margin = 0.010;  // that links keep, as in the controller's guard [m]
  double zmp_margin = 0.010;   // that the zero-moment point keeps from the edge of the soles [m]
  double every =
      0.01;  // links, balance and efforts are looked at so often; limits at every tick [s]
};

// Throws std::runtime_error when a mesh of the robot cannot be read.
MotionVerdict check_motion(const Model& model, const MotionClip& motion,
                           const MotionCheckConfig& config);

}  // namespace twinbus::control
