// What `reach` is asked for, in any frame and for any tool, and the goal of the hand that brings the tool there.
//
// The wire knows one frame only: ARM_GOAL is of the hand's frame in the ground frame.  All else is converted here, by who sends.

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline launcher {

// In which frame a goal is said.
struct ReachFrame {
  enum class Kind { kGround, kBase, kWorld, kLink };
  Kind kind = Kind::kGround;
  int frame = -1;  // kLink: index in model.frames
};
// ground, base, world or a link of the URDF.  Throws std::runtime_error with one sentence.
ReachFrame reach_frame(const Model& model, const std::string& name);

// Where that frame is, in the ground frame, as the robot is now.  Empty: the frame is world, and no source has told where the
// base is in it.  base_in_world: as ESTIMATE tells.
std::optional<Eigen::Isometry3d> frame_in_ground(const ReachFrame& frame, const Model& model, const Estimator& estimator,
                                                 const std::optional<Eigen::Isometry3d>& base_in_world);
// Whether it stands still though the robot moves by balancing: such a goal is converted anew with each correction.
inline bool stands_still(const ReachFrame& frame) { return frame.kind == ReachFrame::Kind::kWorld; }

// The place of the tool, in the ground frame, as a goal of the hand.  oriented: the tool's turn counts; else that of the hand is
// the planner's where the tool is the hand's own frame, and stays what it is now where it is not.
void aim_hand(const Eigen::Isometry3d& tool_in_ground, bool oriented, const Eigen::Isometry3d& tool_in_hand,
              const Eigen::Isometry3d& hand_in_ground, ArmGoal& goal);

}  // namespace twinbus::launcher
