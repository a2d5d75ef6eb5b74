// Inside of OdeWorld, shared by sim/ode*.cpp and nobody else.

#pragma once

#include <ode/ode.h>

#include <deque>

#include "sim/ode_geom.h"
#include "sim/ode_mesh.h"
#include "sim/ode_world.h"

namespace twinbus {

// One moving joint and the rows that act on it.
//
// All rows have the same axis.  Revolute: an angular motor with axis 0 = servo, 1 = rotor inertia,
// damping and friction, 2 = stop (its angle is ours, so that ranges beyond half a turn work).
// Prismatic: a linear motor with axis 0 and 1 likewise; the stop is the slider's own.
struct OdeJoint {
  dJointID joint = nullptr;
  dJointID motor = nullptr;
  bool prismatic = false;
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
};

struct OdeGeom {
  dGeomID geom = nullptr;
  int link = -1;
};

struct SavedBody {
  dVector3 position, linear, angular;
  dQuaternion attitude;
};

inline constexpr int kMaxContacts = 96;
// Rigid contacts: what is no deeper stays, so that a resting point goes on touching [m].
inline constexpr double kRigidLayer = 1e-4;
// What is deeper comes out no faster than this [m/s].
inline constexpr double kRigidReturn = 0.01;
// For whoever asks how far a corner sinks in under its load [N/m].
inline constexpr double kRigidStiffness = 1e8;

inline Eigen::Vector3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

struct OdeWorld::Impl {
  Impl(const Model& model, const WorldConfig& config);
  ~Impl();

  // ode_world.cpp
  void read_state() noexcept;
  bool state_is_sane() const noexcept;
  void save() noexcept;
  void restore() noexcept;

  // ode_servo.cpp
  void add_joint(int joint, const Kinematics& kinematics);
  void prepare_stop(const OdeJoint& joint, double q, double qd) noexcept;
  void prepare_rows(OdeJoint& joint, double q, double qd) noexcept;
  // Servo torques of the step just made; true if a joint without a bounded row went beyond its
  // limit.
  bool read_torques() noexcept;
  double flank(
      const OdeJoint& joint) const noexcept;  // where the play settles under the joint's torque
  void update_play() noexcept;

  // ode_loose.cpp
  struct LooseSide {  // what a loose body meets
    dBodyID body;     // null: fixed
    int link;         // of the robot, -1
    double stiffness, damping, friction;
  };
  void add_loose();
  dGeomID add_mesh(const ContactMesh& mesh);
  void set_loose(std::size_t index, const LooseState& state) noexcept;
  LooseState loose_state(std::size_t index) const noexcept;
  void find_loose_contacts() noexcept;
  void meet_loose(std::size_t index, dGeomID geom, const LooseSide& side) noexcept;
  void create_loose_joints() noexcept;
  void read_loose_forces() noexcept;

  // ode_ties.cpp
  void add_ties(const std::vector<Tie>& tied);
  Eigen::Vector3d place_of(const TieEnd& end) const noexcept;  // world
  void join(std::size_t tie) noexcept;                         // where its points are
  Status hold(int tie, bool holds) noexcept;
  void read_tie_forces() noexcept;

  // ode_contact.cpp
  void add_geoms();
  void read_hulls();
  void add_solid(const Obstacle& obstacle, std::vector<dGeomID>& geoms);
  // The sole that a point of a link is of, -1: none.
  int sole_at(int link, const Eigen::Vector3d& point) const noexcept;
  void find_contacts() noexcept;
  void find_sole_contacts() noexcept;
  void find_link_contacts() noexcept;
  void add_contact(const dContactGeom& geom, int link, int sole, double k, double c,
                   double mu) noexcept;
  // Of a point so deep, as the contact model has it.
  double damping_at(double k, double c, double depth) const noexcept;
  // A spring and damper; the first friction axis along the slip, or along an axis of turn.
  dContact soft_row(const dContactGeom& geom, const Eigen::Vector3d& velocity,
                    const Eigen::Matrix3d& turn, double k, double c, double mu) const noexcept;
  void create_contact_joints() noexcept;
  void read_contact_forces() noexcept;
  void forget_open() noexcept;
  void estimate_contact_forces() noexcept;

  dBodyID body(int link) const { return bodies[static_cast<std::size_t>(link)]; }
  // Null: the world, or a fixed base.
  dBodyID body_of(const TieEnd& end) const {
    return end.loose >= 0  ? loose[static_cast<std::size_t>(end.loose)].body
           : end.link >= 0 ? body(end.link)
                           : nullptr;
  }

  const Model& model;
  WorldConfig config;
  double h;
  dWorldID world = nullptr;
  dJointGroupID contact_group = nullptr;
  std::vector<dBodyID> bodies;  // by link; null for a fixed base
  std::vector<Eigen::Vector3d> com_in_link;
  std::vector<double> link_mass;
  double total_mass = 0.0;
  std::vector<OdeJoint> joints;
  std::vector<OdeGeom> link_geoms;
  std::vector<dGeomID> obstacle_geoms, tile_geoms;
  std::deque<OdeMesh> hulls;   // of the links, in the order of links and shapes
  std::deque<OdeMesh> meshes;  // of the loose bodies
  struct Loose {
    dBodyID body;
    dGeomID geom;
  };
  struct LooseRow {
    dContact contact;
    dBodyID own, other;
    int reported;  // index in contacts, -1
  };
  std::vector<Loose> loose;
  std::vector<LooseRow> loose_rows;
  std::vector<dJointFeedback> loose_feedback;
  struct TieJoint {
    Tie tie;
    dJointID joint;
  };
  std::vector<TieJoint> ties;
  std::vector<dJointFeedback> tie_feedback;
  dGeomID plane = nullptr;
  std::array<std::array<double, kSoleCorners>, 2> offset{};

  Configuration configuration;
  Configuration start_of_step;
  Kinematics kinematics;
  std::vector<dBodyID> moving;  // all that move, the robot's and the loose
  std::vector<SavedBody> saved;
  std::vector<ContactPoint> contacts;
  std::vector<dContact> contact_rows;
  std::vector<dJointFeedback> feedback;
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  std::vector<Push> pushes;
  bool frozen = false;
};

}  // namespace twinbus
