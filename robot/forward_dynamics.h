// Accelerations from torques by the articulated-body algorithm (Featherstone 2008, section 7.3), and
// how a push at a contact moves the robot.
//
//     H v' = (0, tau) + J' f - bias        without forming H

#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "robot/dynamics.h"
#include "robot/kinematics.h"
#include "robot/model.h"
#include "robot/spatial_force.h"

namespace twinbus {

// A point of a link that may be pushed.
struct ContactPoint {
  int link = -1;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // world [m]
};

class ForwardDynamics {
 public:
  static constexpr int kMaxContacts = 16;

  explicit ForwardDynamics(const Model& model);

  // kinematics: updated for the configuration.  tau [joint_count]: on the joints, friction taken
  // off by the caller.  qdd [joint_count]: sized by the caller.  With a fixed base (the model says
  // which) the base stays.  Mimic joints are joints of their own.
  void solve(const Kinematics& kinematics, const Configuration& configuration,
             const Eigen::VectorXd& tau, const std::vector<ExternalWrench>& external,
             Eigen::VectorXd& qdd) noexcept;
  // Of link 0's origin and of link 0, world; of the last solve.
  const Eigen::Vector3d& base_acceleration() const noexcept { return base_acceleration_; }
  const Eigen::Vector3d& base_angular_acceleration() const noexcept { return base_spin_; }

  // J H^-1 J' of contact points at the configuration of the last solve: acceleration [m/s^2] of
  // point a along x, y, z per force [N] on point b.  Its inverse is the contact-space inertia.
  // mobility [3 count x 3 count], sized by the caller; count at most kMaxContacts.
  void contact_mobility(const ContactPoint* contacts, int count,
                        Eigen::MatrixXd& mobility) noexcept;

 private:
  struct Part {             // a link and the joint that moves it
    SpatialMatrix inertia;  // articulated
    Spatial bias, velocity, motion, drift, u_column, acceleration;
    double d_inverse = 0.0, u = 0.0;
    int parent = -1;
  };

  const Model* model_;
  std::vector<Part> parts_;
  Eigen::LLT<SpatialMatrix> base_;
  Eigen::Vector3d origin_, base_acceleration_, base_spin_;
};

}  // namespace twinbus
