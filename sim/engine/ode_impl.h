// Inside of OdeWorld, shared by sim/ode*.cpp and nobody else.

#pragma once

#include <ode/ode.h>

#include <deque>

#include "sim/engine/ode_geom.h"
#include "sim/engine/ode_mesh.h"
#include "sim/engine/ode_robot.h"
#include "sim/engine/ode_world.h"

namespace twinbus {

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

struct OdeWorld::Impl {
  Impl(const Model& model, const WorldConfig& config);
  ~Impl();

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
  void set_loose(std::size_t index, const LooseState& state) noexcept;
  LooseState loose_state(std::size_t index) const noexcept;
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
  Status hold(int tie, bool holds) noexcept;
  void read_tie_forces() noexcept;

  // ode_contact.cpp
  void add_geoms();
  void add_solid(const Obstacle& obstacle, std::vector<dGeomID>& geoms);
  void find_contacts() noexcept;
  void find_sole_contacts(std::size_t robot) noexcept;
  void press_sole(std::size_t robot, int side) noexcept;
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
  bool has_room() const noexcept { return rows.size() < feedback.size(); }
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
  void estimate_contact_forces() noexcept;

  // ode_trust.cpp
  void doubt_rows() noexcept;
  void doubt_speeds() noexcept;
  double elastic_energy() const noexcept;

  // Null: the world, or a fixed base.
  dBodyID body_of(const TieEnd& end) const {
    return end.loose >= 0  ? loose[static_cast<std::size_t>(end.loose)].body
           : end.link >= 0 ? robot_of(end).body(end.link)
                           : nullptr;
  }
  const OdeRobot& robot_of(const TieEnd& end) const {
    return robots[static_cast<std::size_t>(end.robot + 1)];
  }

  WorldConfig config;
  double h;
  dWorldID world = nullptr;
  dJointGroupID contact_group = nullptr;
  std::deque<OdeRobot> robots;  // the commanded one, then the further ones
  OdeRobot& commanded;
  std::vector<dGeomID> obstacle_geoms, tile_geoms;
  std::deque<OdeMesh> meshes;  // of the loose bodies
  struct Loose {
    dBodyID body;
    dGeomID geom;
  };
  std::vector<Loose> loose;
  struct TieJoint {
    Tie tie;
    dJointID joint;
  };
  std::vector<TieJoint> ties;
  std::vector<dJointFeedback> tie_feedback;
  dGeomID plane = nullptr;
  ContactParams ground;  // and all else that is fixed

  std::vector<dBodyID> moving;  // all that move, the robots' and the loose
  std::vector<SavedBody> saved;
  std::vector<ContactPoint> contacts;  // of the commanded robot
  std::vector<Row> rows;
  std::vector<dJointFeedback> feedback;  // of the rows
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  std::vector<Push> pushes;
  bool frozen = false;
  StepTrust trust;  // of the step that is being made
  struct DeepPair {
    dBodyID own, other;
    double depth;  // [m]
  };
  std::vector<DeepPair> deep;  // before the last step
  bool placed = true;          // since then somebody has placed something
};

}  // namespace twinbus
