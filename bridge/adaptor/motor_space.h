// Between the joints of the bus and the motors of a robot whose driver speaks of these: `parallel_joints` with `driver: motors`.
//
// Where two motors turn two joints over rods, the places of the joints in the arrays of such a driver are the motors', in the order
// of robot.yaml: angle, speed and torque of the crank [rad, rad/s, N m], and gains per crank. On the bus they are the joints' always.
// Angles go by the closed form and its inverse, speeds and torques by the Jacobian at the measured posture, servos as
// robot/parallel/drive_torque.h says. Allocates in the constructor only.

#pragma once

#include <vector>

#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/description/parallel_joints.h"

namespace twinbus::inline bridge {

class MotorSpace {
 public:
  MotorSpace() = default;
  explicit MotorSpace(const Model& model);

  bool empty() const noexcept { return pairs_.empty(); }
  // Motors' q, qd, tau become the joints'.  False: no posture of the joints has these motor angles; state is then as it was.
  [[nodiscard]] bool to_joints(RobotState& state) noexcept;
  // Joints' q, qd, tau become the motors'.  False: the rods do not reach that posture.
  [[nodiscard]] bool to_motors(RobotState& state) noexcept;
  // Servos, at the posture and speed that the last call of the two above found.  False: the target is none that the rods reach.
  [[nodiscard]] bool to_motors(JointCommand& command) const noexcept;
  [[nodiscard]] bool to_joints(JointCommand& command) const noexcept;

  // For people, of the first pair whose posture was not found.
  const std::string& where() const noexcept { return where_; }

 private:
  struct Pair {
    ParallelJoints of;
    std::array<std::size_t, 2> bus{};
    Eigen::Vector2d q = Eigen::Vector2d::Zero(), qd = Eigen::Vector2d::Zero();  // of the joints, measured last
    RodPosture posture;
  };
  std::vector<Pair> pairs_;
  std::string where_;
};

}  // namespace twinbus::bridge
