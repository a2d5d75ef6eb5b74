// What every joint's set-point is and where it would come to rest, as the guard sees it.
//
// A set-point follows its command, at most at the joint's rate.  While a mask holds it, it is
// braked to rest; when it is let go far from its command it may run after it at full rate.  What a
// set-point with speed v still moves when a brake reaches it after the delay is
//
//     look_ahead(v) = v delay + v |v| / (2 deceleration)
//
// and running after a command never leads past where the command itself would stop.

#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/model.h"
#include "robot/robot_io.h"

namespace twinbus {

class SetPointTrack {
 public:
  // delay: from a look to the brake that answers it [s].
  SetPointTrack(const Model& model, double delay);

  void reset() noexcept { started_ = false; }
  // One tick: the set-points move on towards command.  mask: bit per joint that is held.
  void follow(const RobotState& state, const JointCommand& command, std::int64_t mask) noexcept;

  // Where the set-point of joint k on the bus comes to rest if its command is obeyed until a brake
  // comes [rad or m].
  double rest_if_obeyed(std::size_t k) const noexcept { return rest_[k]; }
  // Where it comes to rest if it is held from now on.
  double rest_if_held(std::size_t k) const noexcept { return q_[k] + look_ahead(k, v_[k]); }
  // Where a joint at position q with velocity qd comes to rest when a brake comes.
  double rest_if_braked(std::size_t k, double q, double qd) const noexcept {
    return q + look_ahead(k, qd);
  }

 private:
  double look_ahead(std::size_t k, double speed) const noexcept;
  void start(const RobotState& state, const JointCommand& command) noexcept;
  void move(std::size_t k, double measured, double asked, bool held) noexcept;

  double delay_;   // [s]
  double period_;  // [s]
  std::size_t count_;
  bool started_ = false;
  PerJoint<double> limit_{};    // fastest set-point [rad/s or m/s]
  PerJoint<double> brake_{};    // deceleration [rad/s^2 or m/s^2]
  PerJoint<double> q_{}, v_{};  // set-point
  PerJoint<double> rest_{};
  PerJoint<double> asked_{};  // last command
};

}  // namespace twinbus
