// Sees that a robot has fallen, in any mode and with any controller or none, and what led to it.
//
// From the tilt of the IMU's link alone: a robot that was upright once, tilts farther than any robot that is still caught, and
// lies.  A robot that begins on the ground has not fallen.

#pragma once

#include <Eigen/Core>
#include <array>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

// What a source knows while its robot begins to tilt.
struct FallContext {
  Mode mode = Mode::kNone;      // of the controller; kNone: not heard
  double mode_age = 0.0;        // since it changed [s]
  StopKind stop = StopKind::kNone;
  StopReason reason = StopReason::kNone;  // of the stop that is latched
  bool plan_runs = false;       // a stop plan leads the robot
  double silent = 0.0;          // the longest time without a command, lately [s]
  double slept = 0.0;           // the longest time without a tick of this source, lately [s]
};

class FallWatch {
 public:
  // Watches robots with a free base only.
  explicit FallWatch(const Model& model);

  // Once per tick that was measured.  True once per fall: at rest on the ground, or a few seconds after it began; as soon as
  // it is seen in a hold and in a stop plan, which nobody steers.
  bool look(const RobotState& state, const FallContext& context) noexcept;
  // Once per tick, before look(): what a simulator knows of pushes; null: nothing is known.
  void see_push(const SimTruth* truth) noexcept;
  // The robot is another's now, or somebody else's to watch.
  void forget() noexcept { upright_ = tilts_ = false; }
  // What led to the fall that look() has told; zero-terminated, at most 199 bytes.
  std::array<char, 200> cause() const noexcept;

 private:
  bool watches_ = false;
  double period_;
  Eigen::Vector3d up_;     // of the IMU's link, in the frame of the IMU
  bool upright_ = false;   // was, and has not fallen since
  bool tilts_ = false;     // farther than it stands
  double lies_ = 0.0, quiet_ = 0.0;  // [s]
  FallContext context_;    // when it began to tilt
  struct Push {
    double force = 0.0;    // the strongest [N]
    double impulse = 0.0;  // [N s]
    double age = 0.0;      // since it ended [s]
  };
  double mass_;            // [kg]
  Push push_, led_;        // the last one; the last one when it began to tilt
};

}  // namespace twinbus::bridge
