// The simulated world of one robot and loose bodies in one implicit solve: the default engine.
//
// A step of backward Euler: sim/articulated_body moves the links in reduced coordinates (joints
// cannot come apart), sim/joint_law acts in each joint, sim/ground_contacts and sim/contact_solve
// at each touching point, all with the velocities of the end of the step.  So no stiffness of servo
// or ground limits the step; it is first order in it.  Gyroscopic forces are those of its start.
// In flight momentum is kept to rounding besides.
//
// A pass of the solve is exact for the pieces of the joint laws it assumes; a step whose result
// lies on other pieces (a servo reaches its limit, a joint its stop) takes another pass.  A step
// whose contacts do not settle is taken in parts, ever smaller ones.

// Order 2 or 3 (config.order): such a step, two half ones and three thirds from the same start are
// extrapolated (sim/articulated/richardson.h).  Where they disagree on what touches, slips or is limited, or
// something comes to touch or to part, an event lies within: the step is taken in parts, down to a
// sixteenth, of which the one with the event is left at order 1.  They grow again as it gets calm.
// With config.local_error a step is also taken in parts, down to a 128th, until the last correction changes the
// speed of no body by more than that times the part: what falls is stepped coarsely, its impact finely.  While nothing loose
// is near the robot, it and the loose bodies have parts of their own (articulated_apart.cpp).
//
// With config.flight an explicit method of high order (sim/articulated/free_flight.h) takes the steps in which
// nothing can touch and no servo is too stiff for it.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/articulated/aba.h"
#include "sim/contact/contact_solve.h"
#include "sim/articulated/free_flight.h"
#include "sim/contact/ground_contacts.h"
#include "sim/contact/soft_contact.h"
#include "sim/articulated/joint_law.h"
#include "sim/motors/motor_limits.h"
#include "sim/objects/rigid_objects.h"
#include "sim/contact/ties.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

constexpr double kGrows = 0.25;  // of the local error asked for: a part twice as long will hold it too

class ArticulatedWorld final : public World {
 public:
  // Throws std::runtime_error as make_world() says.
  ArticulatedWorld(const Model& model, const WorldConfig& config);

  Status set(const Configuration& configuration,
             const Eigen::VectorXd* tau = nullptr) noexcept override;
  // Goes on as another world of the same model and config would, bit for bit: where its robot is and
  // all that joints and contacts remember.  False: there are loose bodies, ties or other robots;
  // nothing has changed.
  [[nodiscard]] bool resume(const ArticulatedWorld& other) noexcept;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point,
              const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  double corner_offset(int sole, int corner) const noexcept override;
  void estimate_contact_forces() noexcept override;
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override { return configuration_; }
  double encoder(int joint) const noexcept override;
  double tau(int joint) const noexcept override;
  double servo_work() const noexcept override { return work_; }
  double work() const noexcept override;
  Eigen::Isometry3d link_in_world(int link) const noexcept override;
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override;
  Eigen::Vector3d angular_velocity(int link) const noexcept override;
  // Of all links at once: body_.energy().
  BodyEnergy energy(Eigen::Vector3d* world, Eigen::Vector3d* own) const noexcept { return body_.energy(world, own); }
  double mass() const noexcept override { return body_.mass(); }
  Eigen::Vector3d com() const noexcept override;
  Eigen::Vector3d com_velocity() const noexcept override;
  const std::vector<ContactPoint>& contacts() const noexcept override { return reported_; }
  int loose_count() const noexcept override { return loose_.count(); }
  LooseState loose(int body) const noexcept override { return loose_.state(body); }
  bool asleep(int body) const noexcept override { return loose_.asleep(at(body)); }
  Status set_loose(int body, const LooseState& state) noexcept override;
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override {
    return loose_.robots().link_in_world(robot, link);
  }
  Status hold(int tie, bool holds) noexcept override;
  double corner_stiffness(int sole) const noexcept override;
  double corner_damping(int sole, double force) const noexcept override;
  double elastic_energy() const noexcept override;

  const SolveCounters& counters() const noexcept { return solve_.counters(); }
  const std::vector<Contact>& solved() const noexcept { return contacts_; }  // of the last step
  long joint_passes() const noexcept { return joint_passes_; }  // beyond the first of each step
  // Steps that ended with a joint on a wrong piece of its law.
  long unsettled() const noexcept { return unsettled_; }
  // Solves of contacts that did not settle even in the smallest part of a step.
  long unconverged() const noexcept { return unconverged_; }
  // Parts of steps of order 2 or 3 that were left at order 1.
  long events() const noexcept { return events_; }
  // Steps that an explicit method took.
  long flown() const noexcept { return flown_; }

  // For sim/lanes, which steps the robot: the loose bodies one step on, while all of the robot is in that box and none of them near it.
  // False: one is, or their contacts do not settle; nothing has changed.
  [[nodiscard]] bool step_loose(const Eigen::AlignedBox3d& robot) noexcept;

 private:
  friend class LaneWorlds;
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };

  bool fly() noexcept;
  static constexpr int kEventParts = 16, kLocalParts = 128;  // of a step, at most
  int most_parts() const noexcept { return config_.local_error > 0.0 ? kLocalParts : kEventParts; }
  enum class Outcome { kTaken, kEvent, kFailed };
  Outcome advance(double h, bool may_reject, bool goes_on = true) noexcept;
  bool advance_settled() noexcept;
  bool advance_in_parts() noexcept;
  Outcome extrapolated(double h, bool may_reject) noexcept;
  double work_since(const Configuration& before) const noexcept;
  bool crosses() const noexcept;
  void go_back(bool moved) noexcept;
  void begin_apart();
  bool advance_apart() noexcept;
  bool advance_loose_in_parts() noexcept;
  Outcome extrapolate_loose(double h, bool may_reject) noexcept;
  Outcome advance_loose(double h, bool may_reject) noexcept;
  bool solve_step(double h) noexcept;
  void place_after(Momentum momentum, double h, double before) noexcept;
  bool touched(bool fixed) const noexcept;
  bool floats() const noexcept;
  void find_contacts(double h) noexcept;
  std::uint64_t pattern_of_contacts() const noexcept;
  std::uint64_t pattern() const noexcept;
  double end_speed(std::size_t joint, double h) const noexcept;
  void report_contacts() noexcept;
  Status take_step() noexcept;
  // After a step that is taken.  Faces by which fast bodies came would be forgotten in sleep.
  void rest() noexcept {
    if (!config_.asleep || config_.continuous) return;
    loose_.rest(contacts_, config_.step, last_h_);
    loose_.sleep_on();
  }
  void doubt_depths(double h) noexcept;
  void keep_depths(double h) noexcept;

  WorldConfig config_;
  ArticulatedBody body_;
  GroundContacts ground_;
  LooseBodies loose_;
  Ties ties_;
  std::optional<SoftContact> soft_;  // of contact soft
  ContactSolve solve_;
  FlightMotion flight_;
  std::vector<JointLaw> joints_;
  MotorLimits motors_;  // of joints that share them
  std::vector<JointRow> rows_;
  std::vector<Contact> contacts_;
  std::vector<ContactPoint> reported_;
  std::vector<Push> pushes_;
  // Pairs of links that were deep in one another after the last solve, and how deep [m].
  struct DeepPair {
    std::array<int, 4> who;
    double depth;
  };
  std::vector<DeepPair> deep_;
  bool placed_ = true;   // since the last step somebody has: nothing is known of contacts
  double last_h_ = 0.0;  // of the last solve [s]
  Configuration configuration_, start_;
  std::array<Configuration, 2> coarse_;
  Configuration next_;
  int part_ = most_parts();  // of most_parts(): what is taken of a step at once
  int held_ = 0;            // steps in which it has not grown
  bool calm_ = true;        // it may
  bool grows_ = false;      // within the step too
  // The same of the loose bodies by themselves, and what their last solve left.
  struct Apart {
    bool now = false;  // the last step was taken so
    int part = 0;
    bool calm = true;
    double share = 0.0;  // of the links of the world that are theirs
    std::vector<Contact> contacts;
    std::vector<DeepPair> deep;
    double h = 0.0;
  } apart_;
  double solves_ = 0.0;     // passes over the links
  double pass_ = 1.0;       // of all links, what a pass of the robot is over
  long joint_passes_ = 0;
  long unsettled_ = 0;
  long unconverged_ = 0;
  long events_ = 0;
  long flown_ = 0;
  bool converged_ = true;  // the last solve
  double work_ = 0.0;      // of the servos in the last step of order 2 or 3; else kUnknown [J]
  bool airborne_ = false;  // nothing fixed touched the robot when the last solve began
  Momentum before_;        // then
  bool frozen_ = false;
};

}  // namespace twinbus::sim
