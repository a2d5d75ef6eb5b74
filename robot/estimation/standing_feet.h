// Which feet carry the robot, where, and how surely: 0 to 6 of them, with or without force sensors.
//
// The feet are the soles of the model, then every last link of a limb that reaches as low as they do.  Load comes from a
// foot's force sensor; where there is none, from the torques of the joints before it, which with the weight of the limb must
// balance the force F and the moment M of the ground at the point p,
//     axis_j . ((p - o_j) x F + M) = axis_j . sum (c_k - o_j) x m_k f - tau_j,     f what the accelerometer feels;
// where there are no torques either, the lowest feet stand.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

constexpr double kSameHeight = 0.005;  // of feet that stand, without forces and torques [m]

class StandingFeet {
 public:
  explicit StandingFeet(const Model& model);

  void reset() noexcept;

  // kinematics: in the axes of the base, its origin at rest.  base: its axes in a frame with z up.  felt: specific force of the
  // base, its axes [m/s^2].  dt: since the last call [s].
  void update(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base, const Eigen::Vector3d& felt,
              double dt) noexcept;

  // Points and heights alone, of any posture and any placing of the base; loads stay as they are.
  void place(const Kinematics& kinematics, const Eigen::Matrix3d& base) noexcept;

  int count() const noexcept { return static_cast<int>(feet_.size()); }
  int link(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].link; }
  // Index on the bus of the last joint before the foot; -1 none.
  int bus_joint(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].bus_joint; }
  // Where the ground presses, axes of the base, from its origin [m].
  const Eigen::Vector3d& point(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].point; }
  // Of the ball that touches there, 0: a corner [m].  The ball rolls: its centre, as much above the point, stays in the link.
  double radius(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].radius; }
  // Of that ball in the posture nearest to zero, in its link.
  const Eigen::Vector3d& centre(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].centre; }
  // Joints between the base and the foot, the last first.
  const std::vector<int>& chain(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].chain; }
  double load(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].load; }  // share of the weight
  double certainty(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].certainty; }
  bool stands(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)].stands; }
  LoadFrom load_from() const noexcept { return from_; }
  const std::vector<int>& joints() const noexcept { return joints_; }  // before any foot, parents first

 private:
  struct Ball {
    Eigen::Vector3d centre;  // in the link
    double radius;
  };
  struct Foot {
    int link = -1;
    int limb = -1;  // of the force sensor; -1 none
    int bus_joint = -1;
    const Sole* sole = nullptr;
    std::vector<Ball> balls;  // what can touch the ground
    std::vector<int> chain;   // joints before it, the last first
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double radius = 0.0;  // of the lowest ball [m]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double lowest = 0.0;  // of it, in the frame with z up [m]
    double load = 0.0, certainty = 0.0;
    bool stands = false;
  };

  void add_foot(const Model& model, int link, int limb);
  static void add_corners(const Shape& shape, Foot& foot);
  void find_point(const Kinematics& kinematics, const Eigen::Matrix3d& base, Foot& foot) const noexcept;
  bool measure(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base, Foot& foot) const noexcept;
  void weigh(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base, const Eigen::Vector3d& felt,
             double dt, Foot& foot) const noexcept;

  const Model* model_;
  double weight_force_;  // of the whole robot [N]
  std::vector<Foot> feet_;
  std::vector<int> joints_;
  LoadFrom from_ = LoadFrom::kUnknown;
};

}  // namespace twinbus::robot
