// Inverse dynamics by the recursive Newton-Euler algorithm (Featherstone 2008, table 5.1), floating
// base, with external wrenches and rotor inertia.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

inline constexpr double kGravity = 9.81;  // [m/s^2], the same everywhere

struct ExternalWrench {  // on the robot
  int link = -1;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // world [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // world [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  // about point, world [N m]
};

class InverseDynamics {
 public:
  explicit InverseDynamics(const Model& model);

  // kinematics: updated for the configuration.  Base and joint accelerations: qdd [joint_count],
  // base_acceleration of link 0's origin and base_angular_acceleration, world.  tau: [joint_count],
  // rotor inertia included, no friction. Returns the wrench that would have to act on the base
  // besides the external ones (zero if they are consistent): force, then torque about link 0's
  // origin, world.
  Eigen::Matrix<double, 6, 1> solve(const Kinematics& kinematics,
                                    const Configuration& configuration, const Eigen::VectorXd& qdd,
                                    const Eigen::Vector3d& base_acceleration,
                                    const Eigen::Vector3d& base_angular_acceleration,
                                    const std::vector<ExternalWrench>& external,
                                    Eigen::VectorXd& tau) noexcept;

 private:
  struct alignas(64) Part {           // a link and the joint that moves it, world axes
    PaddedVector acceleration, spin;  // of the origin, gravity as one upwards; of the link
    PaddedVector force, torque;       // torque about the link's origin
    double rotor = 0.0;
    int parent = -1;
    bool slides = false;
  };

  void outward(const Kinematics& kinematics, const double* qd, const double* qdd) noexcept;
  void inward(const Kinematics& kinematics, const double* qdd, double* tau) noexcept;

  std::vector<Part> parts_;
};

}  // namespace twinbus::robot
