// Forward dynamics of one robot in linear time: the articulated-body algorithm (Featherstone 2008,
// section 7.3) in world axes about one point, with implicit joints.
//
// The common point O is link 0's origin at the start of the step, so that a child adds its inertia
// to its parent by plain addition.  Each link obeys  force = inertia * acceleration + bias.
// Stiffness that is to be implicit enters as inertia: of a contact in add_compliance(), of a joint
// in JointRow, whose torque at the end of a step h is
//
//     torque = force - gain (qd + h qdd)        so  D = S' I S + rotor + h gain
//
// place(), then fold forces in, then inward() and outward() as often as wanted: each inward()
// begins from the links as placed and folded.

#pragma once

#include <vector>

#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/articulated/articulated_lanes.h"
#include "sim/articulated/spatial.h"

namespace twinbus::inline sim {

// Torque of everything that acts in one joint, as a line in its speed at the end of the step.
struct JointRow {
  double force = 0.0;  // [N m]
  double gain = 0.0;   // [N m s/rad], >= 0
};

// A link as it is placed, in world axes about O.
struct LinkNow {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d origin;
  Screw velocity;
};

// Of the whole robot.
struct Momentum {
  Eigen::Vector3d com;      // world [m]
  Eigen::Vector3d linear;   // [kg m/s]
  Eigen::Vector3d angular;  // about the com [kg m^2/s]
};

// Of all links, without rotors [J].
struct BodyEnergy {
  double kinetic, potential;
};

// What acts on one link at several points: forces [N], and forces -weight * acceleration of the
// point; weight: symmetric 3x3 [kg].  All about O.
struct PointForces {
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(), force = Eigen::Vector3d::Zero();
  // Of J(r)' weight J(r) = [ ww wv ; wv' vv ].
  Eigen::Matrix3d ww = Eigen::Matrix3d::Zero(), wv = Eigen::Matrix3d::Zero(),
                  vv = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& r, const Eigen::Vector3d& f,
           const Eigen::Matrix3d& weight) noexcept;
};

struct alignas(64) ResponseRow {
  Screw row;
  int joint;  // moves this link; 0 .. -5 for the root's six; falls along the rows
};

// Of the body as a whole.
struct BodyState : RootFactors<double> {
  double mass = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // O in world
};

class ArticulatedBody {
 public:
  // Throws std::runtime_error for a link that has no mass or no definite inertia, naming it.
  ArticulatedBody(const Model& model, bool fixed_base, double mass_scale);
  ArticulatedBody(ArticulatedBody&&) = default;
  ArticulatedBody(const ArticulatedBody&) = delete;
  ArticulatedBody& operator=(const ArticulatedBody&) = delete;

  // Poses, velocities, rigid inertias and biases, gravity included.
  void place(const Configuration& configuration) noexcept;
  // The same for a base without contacts, whose velocity and position are first changed so that
  // the robot has that momentum and centre of mass: backward Euler in joint coordinates is off by
  // the square of the step.
  void place(const Momentum& wanted, Configuration& configuration) noexcept;

  // As placed last, before anything was folded in: the same as place() again, for a fraction of it.
  void let_go() noexcept;

  // A force [N] on a point of a link, r about O.
  void add_force(int link, const Eigen::Vector3d& r, const Eigen::Vector3d& force) noexcept;
  void add_forces(int link, const PointForces& forces) noexcept;

  // False: an inertia that is not positive; nothing may be read then.
  [[nodiscard]] bool inward(const std::vector<JointRow>& rows, double h) noexcept;
  void outward() noexcept;

  // A further wrench on a link after inward(), about O; outward() then gives its effect.
  void add_wrench(int link, const Screw& wrench) noexcept;

  // Rows Y of a link, so that a wrench e on it moves link b by Y_b' Y e.  Returns how many, at most
  // most_rows().
  int response(int link, ResponseRow* rows) const noexcept;
  int most_rows() const noexcept { return deepest_ + 6; }

  // One step on: velocity by the acceleration of outward(), then position by the new velocity.
  void advance(double h, Configuration& configuration) const noexcept;

  // As placed, before anything is folded in.
  Momentum momentum() const noexcept;

  // As placed.  By link, velocities of the centres of mass: in world and, unless null, in the link's own axes [m/s].
  BodyEnergy energy(Eigen::Vector3d* world, Eigen::Vector3d* own) const noexcept;

  // Links of different branches do not feel one another: the base between them is fixed.
  int branch(int link) const noexcept { return branch_[static_cast<std::size_t>(link)]; }

  int link_count() const noexcept { return static_cast<int>(links_.where.size()); }
  bool floating() const noexcept { return state_.floating; }
  const Eigen::Vector3d& origin() const noexcept { return state_.origin; }  // O in world
  double mass() const noexcept { return state_.mass; }

  LinkNow link(int i) const noexcept {
    constexpr std::size_t kTurn = TWINBUS_LANE_FIELD(rotation);
    LinkNow now;
    now.rotation << links_.three(i, kTurn), links_.three(i, kTurn + 3), links_.three(i, kTurn + 6);
    now.origin = links_.three(i, TWINBUS_LANE_FIELD(origin));
    now.velocity = links_.screw(i, TWINBUS_LANE_FIELD(velocity));
    return now;
  }
  Screw velocity(int link) const noexcept { return links_.screw(link, TWINBUS_LANE_FIELD(velocity)); }  // world axes, about O
  // Of a link's origin, in world.
  double height(int link) const noexcept {
    return state_.origin.z() + *links_.of(link, TWINBUS_LANE_FIELD(origin) + 2);
  }
  // Of a point of a link, link axes, in world.
  double height(int link, const Eigen::Vector3d& local) const noexcept {
    const double* up = links_.of(link, TWINBUS_LANE_FIELD(rotation) + 2);
    const double* origin = links_.of(link, TWINBUS_LANE_FIELD(origin) + 2);
    return state_.origin.z() + *origin + up[0] * local.x() + up[3 * links_.stride] * local.y() +
           up[6 * links_.stride] * local.z();
  }
  // No point within reach of link 0's origin that belongs to the robot moves faster.
  double fastest(double reach) const noexcept;
  // After outward().
  Screw acceleration(int link) const noexcept {
    return links_.screw(link, TWINBUS_LANE_FIELD(acceleration));
  }
  double qdd(int joint) const noexcept { return *links_.of(joint + 1, TWINBUS_LANE_FIELD(qdd)); }
  // After inward(): of what the joint moves, everything else free.
  double inverse_inertia(int joint) const noexcept {
    return *links_.of(joint + 1, TWINBUS_LANE_FIELD(inverse_d));
  }

 private:
  friend class LaneWorlds;
  void add_wrench_to_bias(int link, const Eigen::Vector3d& torque,
                          const Eigen::Vector3d& force) noexcept;
  int deepest_ = 0;
  std::vector<int> branch_;  // by link
  BodyState state_;
  // One of the two, as the tree is wide or narrow.
  bool wide_ = false;
  BodyLanes<Vec4> four_;
  BodyLanes<double> one_;
  LinkNumbers links_;
};

}  // namespace twinbus::sim
