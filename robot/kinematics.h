// Poses, velocities and Jacobians of every link.
//
// One Kinematics object holds the result for one robot; update() allocates nothing.  Frames:
// "world" is whatever frame the base pose was given in.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robot/model.h"

namespace twinbus {

// Configuration of the whole robot, in model joint order (mimic joints included).
struct Configuration {
  explicit Configuration(const Model& model);
  Configuration() = default;
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();   // link 0 in world
  Eigen::Vector3d base_velocity = Eigen::Vector3d::Zero();  // of link 0's origin, in world [m/s]
  Eigen::Vector3d base_angular_velocity = Eigen::Vector3d::Zero();  // in world [rad/s]
  Eigen::VectorXd q;                                                // [joint_count]
  Eigen::VectorXd qd;                                               // [joint_count]
};

// Fills q and qd from bus arrays, mimic joints from the joints they follow.  The base is left
// alone.
void set_joints(const Model& model, const RobotState& state, Configuration& configuration) noexcept;

class Kinematics {
 public:
  explicit Kinematics(const Model& model);

  void update(const Configuration& configuration) noexcept;

  const Eigen::Isometry3d& link_in_world(int link) const noexcept {
    return pose_[static_cast<std::size_t>(link)];
  }
  const Eigen::Vector3d& angular_velocity(int link) const noexcept {
    return omega_[static_cast<std::size_t>(link)];
  }
  const Eigen::Vector3d& origin_velocity(int link) const noexcept {
    return velocity_[static_cast<std::size_t>(link)];
  }
  const Eigen::Vector3d& axis_in_world(int joint) const noexcept {
    return axis_[static_cast<std::size_t>(joint)];
  }
  // Velocity of the material point of a link that is at `point` (world) [m/s].
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept;

  // Centre of mass of one link, world [m].
  const Eigen::Vector3d& com_of_link(int link) const noexcept {
    return com_of_link_[static_cast<std::size_t>(link)];
  }
  const Eigen::Vector3d& com() const noexcept { return com_; }                    // world [m]
  const Eigen::Vector3d& com_velocity() const noexcept { return com_velocity_; }  // world [m/s]
  const Eigen::Vector3d& angular_momentum() const noexcept {
    return angular_momentum_;
  }  // about the com, world
  double mass() const noexcept { return mass_; }

  // jacobian [6 x (6 + joint_count)], rows: linear then angular velocity of `point` fixed to
  // `link`, in world; columns: base linear, base angular, joints.  Must be sized by the caller.
  void point_jacobian(int link, const Eigen::Vector3d& point,
                      Eigen::MatrixXd& jacobian) const noexcept;
  // [3 x (6 + joint_count)]
  void com_jacobian(Eigen::MatrixXd& jacobian) const noexcept;

 private:
  void update_com() noexcept;

  const Model* model_;
  std::vector<Eigen::Isometry3d> pose_;
  std::vector<Eigen::Vector3d> omega_, velocity_, axis_;
  std::vector<Eigen::Vector3d> com_of_link_;     // world
  std::vector<double> subtree_mass_;             // of a link and everything behind it
  std::vector<Eigen::Vector3d> subtree_moment_;  // mass times centre of mass of it, world
  Eigen::Vector3d com_, com_velocity_, angular_momentum_;
  double mass_ = 0.0;
};

}  // namespace twinbus
