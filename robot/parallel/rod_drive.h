// Two serial joints, pitch and roll of an ankle say, that two motors turn together by a crank and a rod each: a parallel mechanism.
//
// A motor turns its crank about an axis on the parent link (the shank); a rod with a ball at either end leads from the end of the
// crank to the link behind both joints (the foot).  With p(q) the rod's end on the foot and c(theta) that on the crank, the loop of
// each rod is closed by its length (Merlet, Parallel Robots, 2006, section 3.1: inverse kinematics of a chain with a crank):
//
//     |p(q) - c(theta)|^2 = l^2      A cos(theta) + B sin(theta) = C,  theta = atan2(B, A) +- acos(C / sqrt(A^2 + B^2))
//
// of which the branch is that of q = 0, theta = 0.  The derivative of the loop is the Jacobian J = d theta / d q:
//
//     s . dp = s . (a x r) dtheta,  s = p - c: along the rod, a: axis, r: crank
//
// Speeds of the motors are J qd, and torques of the joints are J^T those of the motors (virtual work).

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace twinbus::inline robot {

// The joints in the parent's frame, in which all points and directions are [m].
struct SerialJoints {
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity();   // frame of the first joint at q = 0, in the parent
  Eigen::Isometry3d second = Eigen::Isometry3d::Identity();  // of the second, in the link between them
  Eigen::Vector3d first_axis = Eigen::Vector3d::UnitY();     // unit, in the frame of the joint
  Eigen::Vector3d second_axis = Eigen::Vector3d::UnitX();
};

struct RodMotor {
  std::string name;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // of the crank, on the axis; parent
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();    // unit; parent
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();      // end of the crank at motor angle 0; parent
  Eigen::Vector3d rod = Eigen::Vector3d::Zero();      // end of the rod; in the frame of the link behind the second joint
  double torque = 0.0, speed = 0.0;                   // limits at the crank [N m], [rad/s]
  double lower = 0.0, upper = 0.0;                    // range of the crank [rad], within +-pi
  double rotor_inertia = 0.0;                         // at the crank [kg m^2]
};

// One posture of the pair.
struct RodPosture {
  Eigen::Vector2d motors = Eigen::Vector2d::Zero();        // theta [rad]
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();  // d theta / d q
  // How far from singular: sine between crank and rod, 0 at the dead centre; and least over largest lever that the rods have about
  // any axis of the joints, 0: there is a motion of the foot that no motor feels.
  Eigen::Vector2d crank_sine = Eigen::Vector2d::Ones();
  double foot_share = 1.0;
};

class RodDrive {
 public:
  RodDrive() = default;
  RodDrive(const SerialJoints& joints, const std::array<RodMotor, 2>& motors);

  // Closed form.  q: first and second joint [rad].  False: a rod is too short or too long, or a lever is lost altogether; posture
  // is then not to be used.
  [[nodiscard]] bool at(const Eigen::Vector2d& q, RodPosture& posture) const noexcept;
  // The joints of these motor angles, by Newton's method from `q`, which should be near.  False: none was found, or a motor
  // angle is no number; q and posture are as they were.
  [[nodiscard]] bool joints(const Eigen::Vector2d& motors, Eigen::Vector2d& q, RodPosture& posture) const noexcept;

  const RodMotor& motor(int which) const noexcept { return motors_[static_cast<std::size_t>(which)]; }
  double rod_length(int which) const noexcept { return loops_[static_cast<std::size_t>(which)].length; }
  Eigen::Vector2d torque_limits() const noexcept { return {motors_[0].torque, motors_[1].torque}; }

 private:
  struct Loop {
    Eigen::Vector3d along = Eigen::Vector3d::Zero();   // of the crank, along its axis
    Eigen::Vector3d across = Eigen::Vector3d::Zero();  // and across it
    Eigen::Vector3d ahead = Eigen::Vector3d::Zero();   // axis x across
    double length = 0.0, branch = 1.0, zero = 0.0;     // of the rod [m]; sign of the acos; rounding of the angle at q = 0 [rad]
  };
  // Before its rounding is taken off.
  bool crank_angle(std::size_t motor, const Eigen::Vector3d& rod_end, double& angle) const noexcept;
  struct Reached {
    Eigen::Vector3d first_at, first_axis, second_at, second_axis;
    Eigen::Isometry3d child;
  };
  Reached reach(const Eigen::Vector2d& q) const noexcept;

  SerialJoints joints_;
  std::array<RodMotor, 2> motors_;
  std::array<Loop, 2> loops_;
};

}  // namespace twinbus::robot
