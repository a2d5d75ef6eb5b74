// Accelerations from torques by the articulated-body algorithm (Featherstone 2008, section 7.3), and
// how a push at a contact moves the robot.
//
//     H v' = (0, tau) + J' f - bias        without forming H
//
// Accelerations are split: what velocities and gravity cause with the joints at constant speed is
// known beforehand, so its force on each link is one rigid body's, and the recursion carries only
// the rest.

#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "robot/dynamics/spatial_force.h"

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
  // The inverse of J H^-1 J' + damping: the mass that the contacts feel together [kg].  Points
  // that cannot move apart (two on one link) make it singular; damping [1/kg] > 0 keeps it finite.
  // inertia [3 count x 3 count], sized by the caller.  False: not positive, and inertia is garbage.
  [[nodiscard]] bool contact_inertia(const ContactPoint* contacts, int count, double damping,
                                     Eigen::MatrixXd& inertia) noexcept;

 private:
  struct alignas(64) Part {  // a link and the joint that moves it
    // Articulated inertia of what hangs on the link, in columns: forces that accelerations cause.
    PaddedVector aa[3], la[3], al[3], ll[3];  // moment by angular, force by angular, ...
    StoredSpatial bias;                       // force at no further acceleration
    StoredSpatial motion, column;             // of the joint, and inertia times it
    StoredSpatial acceleration;               // beyond that of constant joint speeds
    PaddedVector drift,
        spin;  // acceleration of the origin and of the link at constant joint speeds
    double d_inverse = 0.0, u = 0.0, rotor = 0.0;
    int parent = -1;
    bool slides = false;
  };

  void outward_drift(const Kinematics& kinematics, const double* qd) noexcept;
  void inward(const double* tau) noexcept;
  void outward(double* qdd) noexcept;
  void base_solve(const StoredSpatial& bias) noexcept;

  const Model* model_;
  std::vector<Part> parts_;
  Eigen::LLT<Eigen::Matrix<double, 6, 6>> base_;
  Eigen::Vector3d origin_, base_acceleration_, base_spin_;
  Eigen::LLT<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                           3 * kMaxContacts, 3 * kMaxContacts>>
      contact_factor_;
};

}  // namespace twinbus
