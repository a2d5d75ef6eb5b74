// What moves in a world beside the commanded robot, in its one solve: loose bodies, of a single
// link each, and further robots (sim/objects/other_robots.h).
//
// A step of a body that touches something is backward Euler in the acceleration of the solve, with
// linear and angular momentum kept exactly: what it gains is the impulse.  A body that touches
// nothing falls exactly and turns by sim/articulated/torque_free_rotation.h.
//
// With config.asleep a heap that has lain for kRest falls asleep (sim/objects/rigid_object_sleep.cpp): each body of it touches
// something, is slower than 0.1 mm/s, is not tied and touches no robot.  What creeps or begins to tip more slowly stays as it is.

#pragma once

#include <array>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "sim/articulated/aba.h"
#include "sim/articulated/torque_free_rotation.h"
#include "sim/contact/contact_solve.h"
#include "sim/objects/rigid_object_contacts.h"
#include "sim/objects/other_robots.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class LooseBodies {
 public:
  // robot must outlive this.  Masses and sizes are such as make_world() lets pass.
  LooseBodies(const Model& model, const WorldConfig& config, ArticulatedBody& robot);

  // There is no contact but the robot's with what is fixed.
  bool empty() const noexcept { return systems_.size() == 1 && !contacts_.active(); }
  int count() const noexcept { return static_cast<int>(bodies_.size()); }
  OtherRobots& robots() noexcept { return robots_; }
  const OtherRobots& robots() const noexcept { return robots_; }
  // The robot, the loose bodies, the further robots.
  const std::vector<ArticulatedBody*>& systems() const noexcept { return systems_; }
  int most_contacts() const noexcept;

  LooseState state(int body) const noexcept;
  void set(int body, const LooseState& state) noexcept;

  // After a whole step, in the smallest part h of it last: heaps that lie still fall asleep.
  void rest(const std::vector<Contact>& contacts, double step, double h) noexcept;
  double asleep_energy() const noexcept { return contacts_.asleep_energy(); }
  bool woke(const Contact& c) const noexcept {  // all of it that moves
    return contacts_.woke(c.system) && (c.other_system < 0 || contacts_.woke(c.other_system));
  }
  void sleep_on() noexcept { contacts_.sleep_on(); }  // a step has ended
  bool asleep(std::size_t body) const noexcept { return contacts_.asleep(static_cast<int>(body) + 1); }
  bool asleep(const Contact& c) const noexcept { return contacts_.asleep(c.system) || contacts_.asleep(c.other_system); }
  // From now on the bodies are as if there were none, until they are let in again: the robot is stepped by itself.
  void leave_out(bool out) noexcept { out_ = out; }
  // Appends their contacts.
  void find(double h, std::vector<Contact>& contacts) noexcept {
    if (out_) return;
    robots_.find(count() + 1, h, contacts);
    contacts_.find(systems_, h, contacts);
  }
  // Whether none of them comes near that box, in which the robot is, in the next h [s]; then the contacts they have without it.
  bool away_from(const Eigen::AlignedBox3d& robot, double h) noexcept { return contacts_.away_from(robot, systems_, h); }
  bool away_from_robot(double h) noexcept { return contacts_.away_from_robot(systems_, h); }
  void find_alone(double h, std::vector<Contact>& contacts) noexcept { contacts_.find(systems_, h, contacts, true); }
  double extent(int link) const noexcept { return contacts_.extent(link); }  // nothing of that link of the robot is further from its origin [m]
  // A contact so deep that its bodies may soon be pushed apart the other way.
  bool may_come_through(const Contact& contact, double depth) const noexcept {
    return contacts_.active() && contacts_.may_come_through(contact, depth);
  }
  // All bodies, after the robot's; false: an inertia was not positive.
  bool inward(double h) noexcept;
  void outward() noexcept;
  // After the solve, before the robot is placed anew; share: how much of a whole step it was.
  // False: no sane result.
  bool advance(const std::vector<Contact>& contacts, double h, double share) noexcept;

  // As they are, without what was folded in for a solve.
  void place_all() noexcept;

  // For higher orders: the state as it is; back to it; what coarser steps came to; their limit.
  void save() noexcept;
  void restore() noexcept;
  void keep_coarse(int which) noexcept;
  double extrapolate(int order) noexcept;  // returns the largest correction, as sim/articulated/richardson.h

 private:
  struct Body {
    Configuration now, start;
    std::array<Configuration, 2> coarse;
    Eigen::Vector3d inertia;  // principal, the body's axes [kg m^2]
    bool touched = false;     // in the last step
    bool ever = false;        // since save()
    int still = 0;            // smooth steps in which it touched and hardly moved, one after the other
    int still_before = 0;     // at save()
    double radius = 0.0;      // [m]
    double quiet = 0.0;       // it has touched and stood so long [s]
    bool tied = false;        // never asleep
    bool slept = false;       // after the last step
  };

  bool out_ = false;
  int heap_of(int system) noexcept;
  void place(std::size_t body) noexcept;
  void land(std::size_t body, double h) noexcept;
  FreeRotation fly(std::size_t body, double h) noexcept;

  std::vector<ArticulatedBody> articulated_;
  std::vector<Body> bodies_;
  OtherRobots robots_;
  std::vector<ArticulatedBody*> systems_;
  std::vector<JointRow> no_rows_;
  LooseContacts contacts_;
  std::vector<int> parent_;   // by system: of the union of those that touch
  std::vector<char> restless_;
  std::vector<int> heap_;
};

}  // namespace twinbus::sim
