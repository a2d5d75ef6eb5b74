// The contract for being a robot: four calls, as in section 3.2 of the OpenHRP paper, with errors instead of bool.
//
// A simulator and a motor driver implement the same class.  Pace is not the adaptor's business: bridge/source
// calls read() once per tick, when the tick is due.

#pragma once

#include <Eigen/Geometry>

#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline bridge {

// key=value pairs, given by `--set key=value` and by the stack file.
struct AdaptorConfig {
  std::vector<std::pair<std::string, std::string>> settings;
};

// What a simulator can be set to: everything that moves.
struct ImposedState {
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();   // link 0 in world
  Eigen::Vector3d base_velocity = Eigen::Vector3d::Zero();  // of the link 0 origin, world [m/s]
  Eigen::Vector3d base_angular_velocity = Eigen::Vector3d::Zero();  // world [rad/s]
  PerJoint<double> q{};
  PerJoint<double> qd{};
  // As in the state that is continued: contact and servo then go on from these forces instead of jumping.  Not known: a
  // robot standing still is assumed.
  bool forces_known = false;
  std::array<std::array<float, 6>, 2>
      foot_wrench{};      // left, right: force [N], torque [N m], sensor frame
  PerJoint<float> tau{};  // [N m or N]
};

// Never throws.  Joint arrays are in bus order (Model::bus_joints).
class RobotAdaptor {
 public:
  virtual ~RobotAdaptor() = default;
  // May allocate, may take time.
  virtual Status open(const Model&, const AdaptorConfig&) = 0;
  // Fills what the robot measures now: q, qd, tau, attitude, gyro, accel, wrench, wrench_kind, sensor_flags, enabled,
  // source_time_ns.  A simulator has advanced by one period with the last written command; it may compute that period
  // already in write(), so that a read() that is due does not wait for it.  May block for timeout_s.
  virtual Status read(RobotState& state, double timeout_s) = 0;
  // The last gate has passed this command: it is finite and within limits.
  virtual Status write(const JointCommand& command) = 0;
  virtual void close() = 0;
  // The controller died while the robot may be walking: bend the knees and damp, or whatever is least bad.
  virtual Status fall_safe() { return Status::kUnsupported; }
  // Simulators: a state can be imposed.
  virtual bool can_be_set() const { return false; }
  virtual Status set_state(const ImposedState&) { return Status::kUnsupported; }
  // Simulators: what only they know, valid after read().  Null for hardware.
  virtual const SimTruth* truth() const { return nullptr; }
  // Simulators: bodies that nothing holds, where they are now, world.  How many pieces there are; fills one of them.
  virtual int loose(int /*piece*/, ObstaclesPiece&) const { return 0; }
  // Simulators: what the hand of that number (0 left, 1 right, then the further arms) grips now, as on HELD; scene_id is another whenever that changes.  False:
  // its scene has that hand grip nothing at any time.
  virtual bool held(int /*hand*/, ObstaclesPiece&) const { return false; }
  // Simulators: a force on a link for a while from now on; force: world [N], point: in the frame of the link [m].
  virtual Status push(int /*link*/, const Eigen::Vector3d& /*force*/,
                      const Eigen::Vector3d& /*point*/, double /*seconds*/) {
    return Status::kUnsupported;
  }
  virtual bool is_hardware() const { return true; }
};

}  // namespace twinbus::bridge
