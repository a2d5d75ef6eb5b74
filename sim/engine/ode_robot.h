// One robot in the ODE world: a body for each link, a hinge or slider with its rows for each joint,
// geoms for its shapes.  What it touches is the world's business.

#pragma once

#include <ode/ode.h>

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "robot/description/parallel_joints.h"
#include "robot/kinematics/kinematics.h"
#include "sim/contact/contact_law.h"
#include "sim/contact/link_patches.h"
#include "sim/contact/sole_patches.h"
#include "sim/engine/ode_mesh.h"
#include "sim/motors/pair_solve.h"
#include "sim/world/link_pairs.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// One moving joint and the rows that act on it.
//
// All rows have the same axis.  Revolute: an angular motor with axis 0 = servo, 1 = rotor inertia,
// damping and friction, 2 = stop (its angle is ours, so that ranges beyond half a turn work).
// Prismatic: a linear motor with axis 0 and 1 likewise; the stop is the slider's own.
struct OdeJoint {
  dJointID joint = nullptr;
  dJointID motor = nullptr;
  bool prismatic = false;
  bool passive = false;  // its target is a spring
  double middle = 0.0;                           // q at ODE's zero
  double lower = -dInfinity, upper = dInfinity;  // stops
  double limit = 0.0;                            // effort
  double rotor = 0.0;                            // reflected inertia
  double damping = 0.0;
  double friction = 0.0;
  ServoTarget target;
  bool bounded = false;  // servo and rotor in separate rows, the servo's with its limit
  double play = 0.0;     // servo side minus link side [rad], backlash
  double tau = 0.0;
  bool taken = false;  // the torque that is given instead of the servo's own: of joints that share motors
  double given = 0.0;
};

struct OdeGeom {
  dGeomID geom = nullptr;
  int link = -1;
  int area = -1;  // of link_patches; -1: ODE's own points touch
};

struct OdeRobot {
  // Before there is anything of ODE: throws std::runtime_error for a link that cannot be simulated,
  // a mesh that cannot be read.  The model must outlive it.
  OdeRobot(const Model& model, const WorldConfig& config);
  ~OdeRobot();
  OdeRobot(const OdeRobot&) = delete;
  OdeRobot& operator=(const OdeRobot&) = delete;

  // ode_robot.cpp
  void create(dWorldID world);  // once
  void place(const Configuration& to) noexcept;
  // From ODE's bodies; kinematics stay as they are.
  void read_state() noexcept;
  Eigen::Isometry3d link_in_world(int link) const noexcept;
  bool has_sole(int link) const noexcept {
    return link == model.soles[0].link || link == model.soles[1].link;
  }
  // The sole that a point of a link is of, -1: none.
  int sole_at(int link, const Eigen::Vector3d& point) const noexcept;
  // Of a point of a link, or of one of its soles, not yet with what it touches.
  ContactParams surface(int sole) const noexcept;
  dBodyID body(int link) const { return bodies[static_cast<std::size_t>(link)]; }

  // ode_servo.cpp
  void set_servo(int joint, const ServoTarget& target) noexcept;
  // Of the servo until now, which says on which flank of its play it is.
  void set_tau(int joint, double tau) noexcept;
  void prepare_rows() noexcept;  // of a step from start_of_step
  // Servo torques of the step just made; true if a joint without a bounded row went beyond its
  // limit.
  bool read_torques() noexcept;
  // Of joints that two motors turn over rods, limited at the motors as sim/motors/motor_limits.h does; true if another pass is needed.
  bool limit_pairs() noexcept;
  void update_play() noexcept;

  const Model& model;
  WorldConfig config;
  std::vector<dBodyID> bodies;  // by link; null for a fixed base
  std::vector<Eigen::Vector3d> com_in_link;
  std::vector<double> link_mass;
  double total_mass = 0.0;
  std::vector<OdeJoint> joints;
  std::vector<ParallelJoints> pairs;  // of joints that share motors
  std::vector<OdeGeom> geoms;
  std::array<std::array<double, kSoleCorners>, 2> offset{};
  LinkPairs never;  // touch one another
  std::optional<SolePatches> patches;  // of contact patch, on ground and tiles
  std::optional<LinkPatches> link_patches;  // of it too, on ground and obstacles

  Configuration configuration;
  Configuration start_of_step;
  Kinematics kinematics;

 private:
  std::vector<PairSolve> solves_;  // of the pairs
  int pair_passes_ = 0;            // of the step
  void read_hulls();
  void create_bodies(dWorldID world);
  void create_geoms();
  void place_fixed_base() noexcept;  // its geoms have no body that carries them
  void follow_base() noexcept;       // joints that hold on to the world do so where the base is
  void add_joint(int joint, dWorldID world);
  void anchor_joint(int joint) noexcept;  // as kinematics has it and its bodies are placed
  void prepare_stop(const OdeJoint& joint, double q, double qd) noexcept;
  void prepare_joint(OdeJoint& joint, double q, double qd) noexcept;
  // Where the play settles under the joint's torque.
  double flank(const OdeJoint& joint) const noexcept;

  std::deque<OdeMesh> hulls_;  // of the links, in the order of links and shapes
  struct FixedGeom {
    dGeomID geom;
    Eigen::Isometry3d in_base;
  };
  std::vector<FixedGeom> fixed_geoms_;
  Eigen::Isometry3d attached_at_ = Eigen::Isometry3d::Identity();  // of the base, for those joints
};

inline Eigen::Vector3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

inline Eigen::Matrix3d matrix(const dReal* m) {
  Eigen::Matrix3d result;
  result << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
  return result;
}

}  // namespace twinbus::sim
