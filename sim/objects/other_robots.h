// The further robots of a world, beside the one that is commanded, in its one implicit solve.
//
// Each has what that one has: an articulated body, a law in each joint, contacts with the ground
// and the obstacles.  Contacts of robots with one another and with loose bodies are found by
// sim/objects/rigid_object_contacts.h.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "sim/articulated/aba.h"
#include "sim/contact/contact_solve.h"
#include "sim/contact/ground_contacts.h"
#include "sim/articulated/joint_law.h"
#include "sim/motors/motor_limits.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class OtherRobots {
 public:
  // Throws std::runtime_error, naming the robot, for a start or a servo that cannot be.
  explicit OtherRobots(const WorldConfig& config);

  bool empty() const noexcept { return robots_.empty(); }
  int count() const noexcept { return static_cast<int>(robots_.size()); }
  ArticulatedBody& body(int robot) noexcept { return robots_[at(robot)].body; }
  Eigen::Isometry3d link_in_world(int robot, int link) const noexcept;

  // Appends what touches the ground and the obstacles; system: of the first of them in the solve.
  void find(int system, double h, std::vector<Contact>& contacts) noexcept;

  // A step begins; then inward() and outward() as often as a joint's law is not the one assumed.
  void begin(double h) noexcept;
  bool inward(double h) noexcept;
  void outward() noexcept;
  int wrong(double h) const noexcept;  // so many joints
  // All of these take the pieces that hold at the end speed found, or the last of them alone does.
  void approach(double h, bool all) noexcept;

  // After the solve; share: how much of a whole step it was.  False: no sane result.
  bool advance(const std::vector<Contact>& contacts, int system, double h, double share) noexcept;

  // As they are, without what was folded in for a solve.
  void place_all() noexcept;

  // For higher orders: the state as it is; back to it; what coarser steps came to; their limit,
  // unless that lies beyond a stop.
  void save() noexcept;
  void restore() noexcept;
  void keep_coarse(int which) noexcept;
  double extrapolate(int order) noexcept;  // returns the largest correction, as sim/articulated/richardson.h
  // Mixed with which pieces of their laws the joints are on.
  std::uint64_t pattern(std::uint64_t pattern) const noexcept;

 private:
  struct Robot {
    ArticulatedBody body;
    GroundContacts ground;
    std::vector<JointLaw> joints;
    std::vector<JointRow> rows;
    Configuration now, start, fine;
    std::array<Configuration, 2> coarse;
    MotorLimits motors{};  // of joints that share them
  };

  static bool holds(const Robot& robot, std::size_t joint, double h) noexcept;
  static double end_speed(const Robot& robot, std::size_t joint, double h) noexcept;

  std::vector<Robot> robots_;
  std::vector<Contact> found_;  // of one
};

}  // namespace twinbus::sim
