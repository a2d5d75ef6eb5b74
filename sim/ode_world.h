// The simulated world of one robot, integrated by Open Dynamics Engine.
//
// Nothing stiff is applied as a force: servo, rotor inertia and ground are rows of ODE's own solve,
// which makes each of them exactly backward Euler.  With A the solved system, a row with
// constraint-force mixing c and target v obeys
//
//     J qd+ + c lambda = v ,  |lambda| <= limit
//
// so c = 1 / (h kp + kd) and v = c (kp (q_ref - q) + kd qd_ref + tau_ff) give
//
//     lambda = kp (q_ref - q - h qd+) + kd (qd_ref - qd+) + tau_ff          the servo at the end of
//     the step
//
// and c = h / J, v = qd gives lambda = -J (qd+ - qd) / h, the reflected rotor inertia J (exact too,
// and added to the same row while the servo is below its limit).  The mechanical stop keeps a row
// of its own.
//
// The world never hands ODE a number that is not finite, and never lets ODE end the process: what
// goes wrong freezes the world and is returned as Status::kDiverged.

#pragma once

#include <array>
#include <memory>
#include <vector>

#include "robot/collision.h"
#include "robot/kinematics.h"
#include "robot/model.h"
#include "robot/status.h"

namespace twinbus {

struct WorldConfig {
  double step = 0.002;  // [s]
  bool fixed_base = false;
  double mass_scale = 1.0;                        // of every link, inertia too
  double friction_scale = 1.0;                    // of the joints' Coulomb friction and damping
  double joint_friction = 0.0;                    // Coulomb, added to every joint [N m]
  double backlash = 0.0;                          // full play between servo and link [rad]
  double ground_friction = 0.8;                   // combined with the sole's as geometric mean
  double stiffness_scale = 1.0;                   // of the soles' springs
  double damping_scale = 1.0;                     // of the soles' dampers
  std::array<double, 2> ground_height{0.0, 0.0};  // under left and right sole [m]
  double servo_kp_scale = 1.0;
  double servo_kd_scale = 1.0;
  std::vector<Obstacle> obstacles;
};

// What the servo of one joint is asked for: torque = tau + kp (q - q_now) + kd (qd - qd_now),
// within the effort limit.
struct ServoTarget {
  double q = 0.0;    // [rad or m]
  double qd = 0.0;   // [rad/s or m/s]
  double tau = 0.0;  // [N m or N]
  double kp = 0.0;   // >= 0
  double kd = 0.0;   // >= 0
};

struct ContactPoint {
  int link = -1;
  int sole = -1;                                    // 0 left, 1 right, -1 not a corner of a sole
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // world [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the robot, world [N]
  double depth = 0.0;                               // [m]
};

// Whether a contact is beyond the force sensor of that foot.
inline bool of_foot(const Model& model, const ContactPoint& contact, std::size_t side) noexcept {
  if (contact.sole >= 0) return contact.sole == static_cast<int>(side);
  return contact.link == model.soles[side].link;
}

inline constexpr int kSoleCorners = 4;
// Corner of a sole in its sole frame: front left, front right, back left, back right.
Eigen::Vector3d sole_corner(const Sole& sole, int corner) noexcept;

class OdeWorld {
 public:
  // Throws std::runtime_error when the model cannot be simulated (a massless link, an indefinite
  // inertia), naming it.
  OdeWorld(const Model& model, const WorldConfig& config);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  // Puts the robot there, at those speeds, thaws a frozen world and forgets contacts.  tau: of the
  // servos until now, which says on which flank of their play they are; null: none.  kNotFinite
  // changes nothing.
  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept;

  // Remembered until changed.  kNotFinite and kOutOfRange (negative gain, absurd size) change
  // nothing.
  Status set_servo(int joint, const ServoTarget& target) noexcept;

  // Force on a point of a link during the next step only; both in world.
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept;

  // Lowers the ground under one sole corner by offset [m], to continue the foot forces of another
  // source.
  void set_corner_offset(int sole, int corner, double offset) noexcept;
  double corner_offset(int sole, int corner) const noexcept;

  // Fills contacts() for the present state, before any step: normal forces of springs and dampers
  // only.
  void estimate_contact_forces() noexcept;

  // One step of config.step.  kDiverged: the world is frozen as it last was.
  Status step() noexcept;

  // As of the last step.  q and qd are the link side; encoder() is the servo side, which differs by
  // backlash.
  const Configuration& configuration() const noexcept;
  double encoder(int joint) const noexcept;
  double tau(int joint) const noexcept;  // of the servo, without friction and rotor inertia
  Eigen::Isometry3d link_in_world(int link) const noexcept;
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept;  // world
  Eigen::Vector3d angular_velocity(int link) const noexcept;
  double mass() const noexcept;
  Eigen::Vector3d com() const noexcept;
  Eigen::Vector3d com_velocity() const noexcept;
  const std::vector<ContactPoint>& contacts() const noexcept;
  double corner_stiffness(int sole) const noexcept;  // [N/m]
  double corner_damping(int sole) const noexcept;    // [N s/m]

  // Complaints of ODE since the program started, of all worlds.
  static long engine_messages() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
