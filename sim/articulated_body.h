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

#include "robot/index.h"
#include "robot/kinematics.h"
#include "robot/model.h"
#include "sim/spatial.h"

namespace twinbus {

// Torque of everything that acts in one joint, as a line in its speed at the end of the step.
struct JointRow {
  double force = 0.0;  // [N m]
  double gain = 0.0;   // [N m s/rad], >= 0
};

struct alignas(64) LinkWork {
  Screw rigid[6];      // inertia as placed, contacts folded in
  Screw rigid_bias;    // gyroscopic forces, minus gravity, pushes and contacts
  Screw axis;          // S
  Screw coriolis;      // c = V_parent x S qd
  Screw inertia_axis;  // U = articulated inertia times S
  Screw velocity;      // V
  Screw acceleration;  // a
  double inverse_d;    // 1 / D
  double u;            // torque - S' bias
  double qdd;
  Vec4 axes[3];  // rotation and com once more, as vectors
  Vec4 center;
  Eigen::Matrix3d rotation;  // link axes in world
  Eigen::Vector3d origin;    // about O, world axes [m]
  Eigen::Vector3d com;       // about O, world axes [m]
};

// Of the whole robot.
struct Momentum {
  Eigen::Vector3d com;      // world [m]
  Eigen::Vector3d linear;   // [kg m/s]
  Eigen::Vector3d angular;  // about the com [kg m^2/s]
};

struct alignas(64) ResponseRow {
  Screw row;
  int joint;  // moves this link; 0 .. -5 for the root's six; falls along the rows
};

struct BodyData {
  // What never changes of a link and of the joint that moves it.
  struct Fixed {
    int parent = -1;
    bool prismatic = false;
    bool leaf = true;
    bool first = false;  // of its siblings to be folded into the parent
    Vec4 offset;         // of the joint, in the parent's axes
    Vec4 axis;           // in the link's axes
    // Link axes in parent axes: still + cos(q) swing + sin(q) turn.
    Vec4 still[3], swing[3], turn[3];
    double mass = 0.0;
    double rotor = 0.0;
    Vec4 com;
    Vec4 inertia[3];  // about com, link axes
  };
  // What the children of a link add to it.
  struct alignas(64) Folded {
    Screw inertia[6];
    Screw bias;
  };

  bool floating = true;
  double mass = 0.0;
  std::vector<Fixed> fixed;
  std::vector<LinkWork> links;
  std::vector<Folded> folded;
  std::vector<double> qd;
  Screw root_bias = {};
  Screw momentum = {};  // of all links, about O
  Vec4 moment = {};     // sum of mass times centre, about O
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double root[6][6] = {};  // Cholesky factor of the root's articulated inertia
  double root_inverse[6] = {};
};

class ArticulatedBody {
 public:
  // Throws std::runtime_error for a link that has no mass or no definite inertia, naming it.
  ArticulatedBody(const Model& model, bool fixed_base, double mass_scale);

  // Poses, velocities, rigid inertias and biases, gravity included.
  void place(const Configuration& configuration) noexcept;
  // The same for a base without contacts, whose velocity and position are first changed so that
  // the robot has that momentum and centre of mass: backward Euler in joint coordinates is off by
  // the square of the step.
  void place(const Momentum& wanted, Configuration& configuration) noexcept;

  // A force [N] on a point of a link, r about O.
  void add_force(int link, const Eigen::Vector3d& r, const Eigen::Vector3d& force) noexcept;
  // A force -weight * acceleration of the point; weight: symmetric 3x3 [kg].
  void add_compliance(int link, const Eigen::Vector3d& r, const Eigen::Matrix3d& weight) noexcept;

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

  // Links of different branches do not feel one another: the base between them is fixed.
  int branch(int link) const noexcept { return branch_[static_cast<std::size_t>(link)]; }

  int link_count() const noexcept { return static_cast<int>(d_.links.size()); }
  bool floating() const noexcept { return d_.floating; }
  const LinkWork& link(int i) const noexcept { return d_.links[static_cast<std::size_t>(i)]; }
  const Eigen::Vector3d& origin() const noexcept { return d_.origin; }  // O in world
  double mass() const noexcept { return d_.mass; }
  double link_mass(int i) const noexcept { return d_.fixed[static_cast<std::size_t>(i)].mass; }

 private:
  int deepest_ = 0;
  std::vector<int> branch_;  // by link
  BodyData d_;
};

}  // namespace twinbus
