// The simulated world of one robot, whichever engine integrates it.
//
// Servo, joint friction, stops and contacts are part of the engine's implicit solve, never forces
// applied from outside: set_servo() says what law holds, step() solves it at the end of the step.
// No engine is handed a number that is not finite, and none ends the process: what goes wrong freezes the world (kDiverged).

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/status.h"
#include "sim/world/other_robot.h"
#include "sim/world/servo_target.h"
#include "sim/world/solid.h"
#include "sim/world/step_trust.h"
#include "sim/world/constraint.h"

namespace twinbus::inline geometry {
class ContactMesh;
}  // namespace twinbus::geometry

namespace twinbus::inline sim {

enum class Engine {
  kArticulated, kOde, kMujoco  // sim/engine/articulated_world.h, ode_world.h, sim/mujoco/mujoco_world.h
};
inline constexpr const char* kEngineNames[] = {"articulated", "ode", "mujoco"};

// False: there is no such engine.
bool engine_of(const std::string& name, Engine& engine);

// How what touches pushes back.
enum class ContactModel {
  kSpringDamper,  // a spring and damper at each point
  kHuntCrossley,  // a spring, and a damper that grows with the depth: section 3.3.2 of the paper
  kRigid,         // no way in: the LCP of engine ode, which alone has it, for comparison
  kPatch,         // of the area that presses, with a damper as kHuntCrossley: section 3.3 of the paper
  kSoft,          // MuJoCo's, which creeps, of the robot on what is fixed: sim/contact/soft_contact.h
};
inline constexpr const char* kContactNames[] = {"spring_damper", "hunt_crossley", "rigid", "patch", "soft"};

// False: there is no such contact.
bool contact_of(const std::string& name, ContactModel& contact);

// How engine articulated moves what touches nothing, has no servo too stiff for it and no friction.
enum class Flight {
  kImplicit,  // like everything else
  kAb4,       // Adams-Bashforth: one evaluation a step, order 4
  kRk4,       // four evaluations, order 4
  kRkf78,     // thirteen evaluations, order 8
  kGauss8,    // implicit, symplectic, order 8: a few times four evaluations side by side
};

// Of a loose body: its middle and its axes.
struct LooseState {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();      // in world
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // world [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // world [rad/s]
};

// A homogeneous body that nothing holds.
struct LooseBody {
  std::string name;
  Solid solid;
  std::shared_ptr<const ContactMesh> mesh;  // instead of the solid, which then is the box around it
  Eigen::Isometry3d solid_pose = Eigen::Isometry3d::Identity();  // of that box, in the body's axes
  double mass = 1.0;                                             // [kg]
  LooseState start;
  double friction = 0.6;
  double stiffness = 1e5;  // of a point that touches [N/m]
  double damping = 150.0;  // [N s/m]
};

// Shells of links other than soles: what a fallen robot lies on.
inline constexpr double kLinkStiffness = 2e5;  // of a point [N/m]
inline constexpr double kLinkDamping = 1e3;    // [N s/m]
inline constexpr double kLinkFriction = 0.6;

struct WorldConfig {
  Engine engine = Engine::kArticulated;
  ContactModel contact = ContactModel::kSpringDamper;
  double step = 0.002;  // [s]
  int order = 1;        // of accuracy in the step; 2, 3: engine articulated only, 3, 6 solves
  Flight flight = Flight::kImplicit;
  double flight_error = 0.0, local_error = 0.0;  // of speeds after a part of a step of kGauss8 [rad/s]; in each second of one of order 2, 3 [m/s^2]; 0: whole
  bool fixed_base = false;
  double mass_scale = 1.0;                        // of every link, inertia too
  double friction_scale = 1.0;                    // of the joints' Coulomb friction and damping
  double joint_friction = 0.0, joint_friction_share = 1.0;  // added to every joint (coulomb_friction.h)
  double backlash = 0.0;                          // full play between servo and link [rad]
  double ground_friction = 0.8;                   // combined with the sole's as geometric mean
  double stiffness_scale = 1.0, damping_scale = 1.0;  // of the soles' springs and dampers
  double dissipation = 2.0, rolling_friction = 0.0, torsional_friction = 0.0;  // of laws that damp by depth [s/m]; of all [m]
  std::array<double, 2> ground_height{0.0, 0.0};  // under left and right sole [m]
  double servo_kp_scale = 1.0, servo_kd_scale = 1.0;
  std::vector<Obstacle> obstacles;
  std::vector<Obstacle> tiles;  // ground that is not flat: to the soles' corners what the ground is
  std::vector<LooseBody> loose;
  std::vector<OtherRobot> robots;           // further ones, beside the one commanded
  bool self_contact = false;                // links of a robot touch one another; the same
  bool asleep = false;                      // loose bodies that lie still: sim/objects/rigid_object_sleep.cpp
  bool continuous = false, twin = false;    // sim/objects/entry_faces.h; sim/engine/twinned_world.h
  double accuracy = 2e-3;                   // steps that are off by more are doubted: sim/engine/local_error.h [m]
  TrustBands bands;                         // of a run whose error was measured: doubted beyond them
  double shell_stiffness = kLinkStiffness;  // of a point of a link that is no sole [N/m]
  std::vector<Tie> ties;
  std::vector<bool> held, rigid_robots;  // joints, further robots: sim/engine/welded_world.h
  std::vector<std::array<int, 2>> aloft;      // by ground and obstacles: link and collision shape
  std::vector<std::array<int, 2>> untouched;  // by anything loose or a further robot: link and collision shape; a side and -1: that sole
};

struct ContactPoint {
  int link = -1, sole = -1;                         // sole: 0 left, 1 right, -1 not a corner of one
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // world [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the robot, world [N]
  double depth = 0.0;                               // [m]
  bool tie = false;                                 // holds something: felt, but no touch
  Eigen::Vector3d moment = Eigen::Vector3d::Zero(); // of rolling and torsional friction, on the robot [N m]
};

inline constexpr int kSoleCorners = 4;
// Corner of a sole in its sole frame: front left, front right, back left, back right.
Eigen::Vector3d sole_corner(const Sole& sole, int corner) noexcept;

// Bounds of what an engine takes and of what it calls a sane result.
inline constexpr double kMaxSpeed = 1e3;     // [m/s] and [rad/s]; beyond it the run has diverged
inline constexpr double kMaxDistance = 1e6;  // [m]
inline constexpr double kMaxPush = 1e6;      // [N]

// Whether a world may be set to this: kWrongSize, kNotFinite, kOutOfRange.
Status check_configuration(std::size_t joints, const Configuration& configuration) noexcept;

// Whether a loose body may be set to this: kNotFinite, kOutOfRange.
Status check_loose(const LooseState& state) noexcept;
inline constexpr int kMostLooseContacts = 40;  // of a body, that an engine has room for

// Joints: below this speed Coulomb friction creeps [rad/s or m/s].
inline constexpr double kStickSpeed = 0.01;
// Play is crossed as the torque changes sign; the sign is smoothed over this torque so that the
// crossing takes time, and the play follows by this share per step.
inline constexpr double kPlayTorque = 2.0;  // [N m]
inline constexpr double kPlayRate = 0.2;

// Points of a foot this near its sole are the corners' business [m].
inline constexpr double kSoleSkin = 0.02;

class World {
 public:
  World() = default;
  virtual ~World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // Puts the robot there, at those speeds, thaws a frozen world and forgets contacts.  tau: of the servos until now, which
  // says on which flank of their play they are; null: none.  An error changes nothing.
  virtual Status set(const Configuration& configuration,
                     const Eigen::VectorXd* tau = nullptr) noexcept = 0;

  // Remembered until changed.  An error changes nothing.
  virtual Status set_servo(int joint, const ServoTarget& target) noexcept = 0;

  // Force on a point of a link during the next step only; both in world.
  virtual Status push(int link, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& force) noexcept = 0;

  // Lowers the ground under one sole corner by offset [m], to continue the foot forces of another source.
  virtual void set_corner_offset(int sole, int corner, double offset) noexcept = 0;
  virtual double corner_offset(int sole, int corner) const noexcept = 0;

  // Fills contacts() for the present state, before any step: normal forces of springs and dampers only.
  virtual void estimate_contact_forces() noexcept = 0;

  // One step of config.step.  kDiverged: the world is frozen as it last was.
  virtual Status step() noexcept = 0;

  // As of the last step.  q and qd are the link side; encoder() is the servo side, which differs by backlash.
  virtual const Configuration& configuration() const noexcept = 0;
  virtual double encoder(int joint) const noexcept = 0;
  virtual double tau(int joint) const noexcept = 0;  // of the servo, no friction or rotor inertia
  virtual double servo_work() const noexcept { return kUnknown; }  // in the last step [J]
  virtual double work() const noexcept { return kUnknown; }        // done since it was made, in solves: no clock is in it
  virtual Eigen::Isometry3d link_in_world(int link) const noexcept = 0;
  virtual Eigen::Vector3d point_velocity(int link,
                                         const Eigen::Vector3d& point) const noexcept = 0;  // world
  virtual Eigen::Vector3d angular_velocity(int link) const noexcept = 0;
  virtual double mass() const noexcept = 0;
  virtual Eigen::Vector3d com() const noexcept = 0;
  virtual Eigen::Vector3d com_velocity() const noexcept = 0;
  virtual const std::vector<ContactPoint>& contacts() const noexcept = 0;
  // Loose bodies, as of the last step.  set() leaves them where they are.
  virtual int loose_count() const noexcept = 0;
  virtual LooseState loose(int body) const noexcept = 0;
  virtual bool asleep(int) const noexcept { return false; }  // whether that loose body is not modelled now
  // kWrongSize, kNotFinite, kOutOfRange: changes nothing.
  virtual Status set_loose(int body, const LooseState& state) noexcept = 0;
  // Of a further robot, as of the last step.
  virtual Eigen::Isometry3d robot_link(int robot, int link) const noexcept = 0;
  // Of config.ties: from now on its ends are to stay together as they are, or are let go.
  virtual Status hold(int tie, bool holds) noexcept = 0;
  virtual double corner_stiffness(int sole) const noexcept = 0;  // [N/m]; of one that carries the force [N s/m]:
  virtual double corner_damping(int sole, double force) const noexcept = 0;
  virtual double elastic_energy() const noexcept = 0;  // of the springs of contacts and ties [J]
  // Of the last step, but for its energy: sim/engine/energy_balance.h.
  const StepTrust& trust() const noexcept { return trust_; }

 protected:
  StepTrust trust_;
};

// Throws std::runtime_error, naming the link, for one that is to move without a positive mass and inertia.
void check_links(const Model& model, bool fixed_base);

}  // namespace twinbus::sim
