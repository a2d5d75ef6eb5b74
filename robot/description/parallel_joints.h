// Two joints that two motors turn together by cranks and rods, as the ankles of many humanoids: the list `parallel_joints` of
// robot.yaml.
//
//   - joints: [l_ankle_pitch, l_ankle_roll]   # in series, from the parent on
//     parent: l_shank                         # link of the URDF; its frame has crank, axis and arm
//     child: l_foot                           # of the URDF too; its frame has rod
//     motors:                                 # two
//       - {name: l_ankle_out, crank: [0, 0.04, -0.1], axis: [0, 1, 0], arm: [-0.05, 0.04, -0.1], rod: [-0.05, 0.04, 0],
//          torque: 50, speed: 20, range: [-1, 1], rotor_inertia: 0.01}
//       - ...
//     driver: motors                          # what the robot's own driver speaks of; joints if it does that itself
//
// crank: a point on the motor's axis; arm: the end of the crank at motor angle 0; rod: the end of the rod on the child [m]. The rod's
// length is the distance of arm and rod with both joints at 0, where the motors' angles are 0 too. torque [N m], speed [rad/s] and
// rotor_inertia [kg m^2] are those of the crank; with `reduction`, of the motor before it. range [rad] is of the crank.
//
// The bus and everybody who computes with the tree keep the two joints. Their limits come of the motors: position, the box of joint
// angles inside the ranges and away from singular postures; speed, the box inside the motors' speeds at 0; effort, what the motors
// give one joint at 0 while the other has none. Who knows the pair limits torque at the motors, posture by posture (a
// parallelogram), the gate speed too.

#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/parallel/drive_range.h"

namespace twinbus::inline common {
class ConfigNode;
}  // namespace twinbus::common

namespace twinbus::inline robot {

struct Model;

struct ParallelJoints {
  std::array<int, 2> joints{-1, -1};  // of the model
  RodDrive drive;
  JointBox box;        // where the joints may be
  bool driver_of_motors = false;
  std::string where;   // file, line and key

  Eigen::Vector2d of(const Eigen::VectorXd& joint_values) const noexcept {
    return {joint_values[joints[0]], joint_values[joints[1]]};
  }
};

// As robot.yaml says it.
struct ParallelEntry {
  std::array<std::string, 2> joints;
  std::string parent, child;
  std::array<RodMotor, 2> motors;  // center, axis, arm in the frame of `parent`; rod in that of `child`
  bool driver_of_motors = false;
  std::string where;  // file, line and key
};

// Throws std::runtime_error naming file, line and key.
ParallelEntry read_parallel_joints(const ConfigNode& node);
// The limits of those joints, into a model whose joints, links and frames are known.  Throws as above when joints or links are not
// what they should be, or the geometry is singular or out of range at rest.
void apply_parallel_joints(const std::vector<ParallelEntry>& entries, Model& model);

// The pairs of a loaded model, by its own text of robot.yaml, without those of which somebody has welded a joint.  Allocates: who
// needs them in a loop keeps them.
std::vector<ParallelJoints> parallel_joints_of(const Model& model);
// The one that a joint belongs to, or null.
inline const ParallelJoints* pair_with(const std::vector<ParallelJoints>& pairs, int joint) noexcept {
  for (const ParallelJoints& pair : pairs) {
    if (pair.joints[0] == joint || pair.joints[1] == joint) return &pair;
  }
  return nullptr;
}

}  // namespace twinbus::robot
