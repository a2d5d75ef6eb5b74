// The simulated world, integrated by Open Dynamics Engine.
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

#include <ode/ode.h>
#include <ode/threading_impl.h>

#include <deque>
#include <vector>

#include "sim/engine/ode_geom.h"
#include "sim/engine/ode_mesh.h"
#include "sim/engine/ode_robot.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct SavedBody {
  dVector3 position, linear, angular;
  dQuaternion attitude;
};

inline constexpr int kMaxContacts = 96;   // of a robot
inline constexpr int kPointsPerPair = 4;  // of a shape of a robot with another or with what is fixed
// Rigid contacts: what is no deeper stays, so that a resting point goes on touching [m].
inline constexpr double kRigidLayer = 1e-4;
// What is deeper comes out no faster than this [m/s].
inline constexpr double kRigidReturn = 0.01;
// For whoever asks how far a corner sinks in under its load [N/m].
inline constexpr double kRigidStiffness = 1e8;

// Its parts are in sim/engine/ode_*.cpp, as named below.
class OdeWorld final : public World {
 public:
  // Throws std::runtime_error as make_world() says.
  OdeWorld(const Model& model, const WorldConfig& config);
  ~OdeWorld() override;

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  double corner_offset(int sole, int corner) const noexcept override {
    return commanded_.offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)];
  }
  void estimate_contact_forces() noexcept override;
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override { return commanded_.configuration; }
  double encoder(int joint) const noexcept override { return configuration().q[joint] + own(joint).play; }
  double tau(int joint) const noexcept override { return own(joint).tau; }
  Eigen::Isometry3d link_in_world(int link) const noexcept override { return commanded_.link_in_world(link); }
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override;
  Eigen::Vector3d angular_velocity(int link) const noexcept override;
  double mass() const noexcept override { return commanded_.total_mass; }
  Eigen::Vector3d com() const noexcept override;
  Eigen::Vector3d com_velocity() const noexcept override;
  const std::vector<ContactPoint>& contacts() const noexcept override { return contacts_; }
  int loose_count() const noexcept override { return static_cast<int>(loose_.size()); }
  LooseState loose(int body) const noexcept override;
  Status set_loose(int body, const LooseState& state) noexcept override;
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override {
    return robots_[static_cast<std::size_t>(robot + 1)].link_in_world(link);
  }
  Status hold(int tie, bool holds) noexcept override;
  double corner_stiffness(int sole) const noexcept override;
  double corner_damping(int sole, double force) const noexcept override;
  double elastic_energy() const noexcept override;

  // Complaints of ODE since the program started, of all worlds.
  static long engine_messages() noexcept;

 private:
  const OdeJoint& own(int joint) const noexcept { return commanded_.joints[static_cast<std::size_t>(joint)]; }

  // ode_world.cpp
  void create_robots();
  void save() noexcept;
  void restore() noexcept;
  bool state_is_sane() const noexcept;
  void prepare_step() noexcept;
  bool read_step() noexcept;  // false: no sane result

  // ode_loose.cpp
  void add_loose();
  dGeomID add_mesh(const ContactMesh& mesh);
  void place_loose(std::size_t index, const LooseState& state) noexcept;
  ContactParams surface(const LooseBody& body) const noexcept;
  void find_loose_contacts() noexcept;
  void meet_fixed(std::size_t index, dGeomID geom) noexcept;
  void meet_loose(std::size_t index, std::size_t other) noexcept;
  void meet_link(std::size_t index, std::size_t robot, const OdeGeom& geom) noexcept;
  // As damped as that, but for contacts hunt_crossley and patch.
  void add_loose_row(const dContactGeom& geom, dBodyID own, dBodyID other,
                     const ContactParams& params, int felt_by_other) noexcept;

  // ode_meeting.cpp
  void find_meetings() noexcept;  // of robots with one another, of links of one robot
  void find_meetings(std::size_t robot, std::size_t other) noexcept;
  void meet(std::size_t robot, const OdeGeom& geom, std::size_t other,
            const OdeGeom& other_geom) noexcept;

  // ode_ties.cpp
  void add_ties(const std::vector<Tie>& tied);
  Eigen::Vector3d place_of(const TieEnd& end) const noexcept;  // world
  void join(std::size_t tie) noexcept;                         // where its points are
  void read_tie_forces() noexcept;

  // ode_contact.cpp
  void add_geoms();
  void add_solid(const Obstacle& obstacle, std::vector<dGeomID>& geoms);
  void find_contacts() noexcept;
  void find_sole_contacts(std::size_t robot) noexcept;
  void press_sole(std::size_t robot, int side) noexcept;
  void press_link(std::size_t robot, const OdeGeom& part, std::size_t surface) noexcept;
  void find_link_contacts(std::size_t robot) noexcept;
  // Of a robot with what is fixed.
  void add_contact(const dContactGeom& geom, std::size_t robot, int link, int sole) noexcept;
  // Of a point of a link: where it is in contacts, -1: nobody asks.
  int feel(std::size_t robot, int link, int sole, const dContactGeom& geom) noexcept;
  // Null: fixed.  The normal is towards own.
  struct Row {
    dContact contact;
    dBodyID own, other;
    int felt, felt_by_other;  // index in contacts, -1
  };
  bool has_room() const noexcept { return rows_.size() < feedback_.size(); }
  // A spring and damper at a point of a robot, by its depth at the end of the step.
  void add_row(const dContactGeom& geom, dBodyID own, dBodyID other, const ContactParams& params,
               int felt, int felt_by_other) noexcept;
  Eigen::Vector3d velocity_between(const dContactGeom& geom, dBodyID own,
                                   dBodyID other) const noexcept;
  // The first friction axis along the slip, or along an axis of the body.
  dContact soft_row(const dContactGeom& geom, const Eigen::Vector3d& velocity, dBodyID body,
                    double k, double c, double mu) const noexcept;
  void create_contact_joints() noexcept;
  void read_contact_forces() noexcept;
  void forget_open() noexcept;

  // ode_trust.cpp
  void doubt_rows() noexcept;
  void doubt_speeds() noexcept;

  // Null: the world, or a fixed base.
  dBodyID body_of(const TieEnd& end) const {
    return end.loose >= 0  ? loose_[static_cast<std::size_t>(end.loose)].body
           : end.link >= 0 ? robot_of(end).body(end.link)
                           : nullptr;
  }
  const OdeRobot& robot_of(const TieEnd& end) const {
    return robots_[static_cast<std::size_t>(end.robot + 1)];
  }

  WorldConfig config_;
  double h_;
  dWorldID world_ = nullptr;
  dThreadingImplementationID queue_ = nullptr;  // of the jobs of a step: that which worlds share is for one thread alone
  dJointGroupID contact_group_ = nullptr;
  std::deque<OdeRobot> robots_;  // the commanded one, then the further ones
  OdeRobot& commanded_;
  std::vector<dGeomID> obstacle_geoms_, tile_geoms_;
  std::deque<OdeMesh> meshes_;  // of the loose bodies
  struct Loose {
    dBodyID body;
    dGeomID geom;
  };
  std::vector<Loose> loose_;
  struct TieJoint {
    Tie tie;
    dJointID joint;
  };
  std::vector<TieJoint> ties_;
  std::vector<dJointFeedback> tie_feedback_;
  dGeomID plane_ = nullptr;
  ContactParams ground_;  // and all else that is fixed

  std::vector<dBodyID> moving_;  // all that move, the robots' and the loose
  std::vector<SavedBody> saved_;
  std::vector<ContactPoint> contacts_;  // of the commanded robot
  std::vector<Row> rows_;
  std::vector<dJointFeedback> feedback_;  // of the rows
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  std::vector<Push> pushes_;
  bool frozen_ = false;
  struct DeepPair {
    dBodyID own, other;
    double depth;  // [m]
  };
  std::vector<DeepPair> deep_;  // before the last step
  bool placed_ = true;          // since then somebody has placed something
};

}  // namespace twinbus::sim
