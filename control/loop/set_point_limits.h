// Nothing leaves the controller that is not finite and within the robot's limits; the gate of the
// source finds nothing left to clamp.

#pragma once

#include "control/joint/set_point.h"
#include "robot/description/model.h"
#include "robot/dynamics/pair_torque.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline control {

class SetPointLimits {
 public:
  explicit SetPointLimits(const Model& model);  // must outlive this

  // A joint with a number that is not one stays where it was put last (last, else measured), with its
  // default gains.  Then position, way since last, velocity, torque and its change since last are clamped to the joint's limits, and the
  // torques of joints that two motors turn to what these give where the joints are.
  // last: put out dt > 0 seconds ago; null at the beginning.
  void apply(const RobotState& state, const SetPoint* last, double dt,
             SetPoint& set_point) const noexcept;

 private:
  PairTorque pairs_;  // of joints that share motors
  std::size_t count_;
  PerJoint<double> lower_, upper_, rate_, velocity_,
      effort_;                // bus order; +-inf where there is none
  PerJoint<double> kp_, kd_;  // defaults
};

}  // namespace twinbus::control
