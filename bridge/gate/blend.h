// Fades one set-point into another without a jump: what is left of the difference decays per joint
// over a fixed time.
//
// At the start e = own - client, in position and velocity.  The offset added to the client's position is the quintic of
// common/math/quintic_fade.h: position and velocity go on as they were and end at the client's.
// Torque and gains fade with h0, torque in a time of its own where that is said.  A joint may start again at any instant,
// in the middle of a fade too, because the own set-point already contains what is left of the last
// fade.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

struct OffsetBlend {
  // Joints of the mask (bit per joint) start to fade from own, which was in force dt seconds [s]
  // ago, to client. duration [s]; 0 takes the client at once.  torque_duration [s]: of torques alone; 0: as duration.
  void start(const JointCommand& own, const JointCommand& client, std::int64_t mask, double dt,
             double duration, double torque_duration = 0.0) noexcept;

  // Forgets every offset.
  void clear() noexcept { active = 0; }

  // Share of the client's position in the set-point, of the joint where it is least: 1 once nothing fades.
  float share_of_client() const noexcept;

  // dt seconds [s] pass; then what is left is added to the first joint_count joints of command.
  void advance_and_apply(double dt, int joint_count, JointCommand& command) noexcept;

  std::int64_t active = 0;       // bit per joint that still fades
  PerJoint<float> elapsed{};     // [s]
  PerJoint<float> duration_s{};  // [s]
  PerJoint<float> torque_s{};    // [s]
  PerJoint<double> q{};          // e at the start [rad or m]
  PerJoint<double> qd{};         // [rad/s or m/s]
  PerJoint<float> tau{};         // [N m or N]
  PerJoint<float> kp{};
  PerJoint<float> kd{};
};

}  // namespace twinbus::bridge
