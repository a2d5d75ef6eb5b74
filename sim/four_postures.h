// Forward dynamics of one robot at four postures at once: each in a lane of its own
// (sim/articulated_lanes.h), for what a short vector of postures costs little more than one.
// For methods that need several independent evaluations (sim/gauss_flight.h).
//
// Nothing touches: there are gravity and the torques of the joints, rotors included.  Everything
// is in link 0's axes: how these stand in world and how fast link 0 goes matters to nothing that
// falls.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/dynamics.h"
#include "robot/model.h"
#include "sim/articulated_body.h"
#include "sim/rigid_links.h"

namespace twinbus {

class FourPostures {
 public:
  static constexpr int kCount = 4;
  // A row for each posture, a column for each joint, in the order of joint_of().
  using Rows = Eigen::Map<Eigen::Array<double, kCount, Eigen::Dynamic>>;
  using Spins = Eigen::Map<Eigen::Array<double, kCount, 3>, Eigen::Aligned32>;
  // Columns: acceleration of link 0's origin minus gravity, of its turning, of the joints.
  using Accelerations = Eigen::Array<double, kCount, Eigen::Dynamic>;
  static constexpr int kFirstJoint = 6;

  // A model that ArticulatedBody takes.
  FourPostures(const Model& model, bool fixed_base, double mass_scale);

  int joint_of(int column) const noexcept { return lanes_.ranks[at(column + 1)].link[0] - 1; }

  // What to fill in before accelerate(): angles [rad], rates [rad/s] and torques [N m] of the
  // joints, [m], [m/s] and [N] of prismatic ones.
  Rows q() noexcept { return rows(lanes_.angle); }
  Rows qd() noexcept { return rows(lanes_.rate); }
  Rows torque() noexcept { return rows(lanes_.force); }
  // Angular velocity of link 0 [rad/s], unless it is fixed.
  Spins spin() noexcept { return Spins(reinterpret_cast<double*>(&links_[0].value.w)); }
  // Of a fixed base, its axes in world: where gravity comes from.
  void hold(const Eigen::Matrix3d& axes) noexcept;

  // False: an inertia that is not positive; nothing may be read then.
  [[nodiscard]] bool accelerate(Accelerations& to) noexcept;

  // From a guess a better one, for half the time: its error is multiplied by the share by which
  // the robot's inertia has changed since accelerate(), of each posture.
  void improve(Accelerations& guess) noexcept;

  // Of what the joint moves, everything else free, at posture 0 of accelerate().
  double inverse_inertia(int joint) const noexcept {
    return numbers_.of(joint + 1, TWINBUS_LANE_FIELD(inverse_d))[0];
  }

 private:
  // Rank r has a link in all of its lanes; column r - 1 is of the joint that moves it.
  Rows rows(std::vector<double>& numbers) noexcept {
    return {numbers.data() + kCount, kCount, static_cast<Eigen::Index>(lanes_.links.size()) - 1};
  }

  BodyLanes<Vec4> lanes_;
  LinkNumbers numbers_;
  RootFactors<Vec4> root_;
  bool slides_ = false;  // there are prismatic joints: improve() knows none
  std::vector<RigidLink> rigid_;
  std::vector<Aligned<LinkMotion<Vec4>>> links_;
  Eigen::Vector3d held_ = {0.0, 0.0, kGravity};  // acceleration that a fixed base feels
};

}  // namespace twinbus
