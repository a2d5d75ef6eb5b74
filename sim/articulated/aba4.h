// Forward dynamics of one robot at four postures at once: each in a lane of its own, for what a short
// vector of postures costs little more than one (sim/articulated/inverse_lanes.h).  For methods that need several
// independent evaluations (sim/articulated/gauss_legendre.h).
//
// Nothing touches: there are gravity and the torques of the joints, rotors included.  Everything
// is in link 0's axes: how these stand in world and how fast link 0 goes matters to nothing that
// falls.

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/model.h"
#include "common/simd/vec4.h"
#include "sim/articulated/rigid_links.h"

namespace twinbus::inline sim {

class FourPostures {
 public:
  static constexpr int kCount = 4;
  // A row for each posture, a column for each joint.
  using Rows = Eigen::Map<Eigen::Array<double, kCount, Eigen::Dynamic>>;
  using Spins = Eigen::Map<Eigen::Array<double, kCount, 3>, Eigen::Aligned32>;
  // Columns: acceleration of link 0's origin minus gravity, of its turning, of the joints.
  using Accelerations = Eigen::Array<double, kCount, Eigen::Dynamic>;
  static constexpr int kFirstJoint = 6;

  // A model that ArticulatedBody takes.
  FourPostures(const Model& model, bool fixed_base, double mass_scale);

  // What to fill in: angles [rad], rates [rad/s] and torques [N m] of the joints, [m], [m/s] and [N]
  // of prismatic ones.
  Rows q() noexcept { return rows(body_.angle); }
  Rows qd() noexcept { return rows(body_.rate); }
  Rows torque() noexcept { return rows(body_.force); }
  // Angular velocity of link 0 [rad/s], unless it is fixed.
  Spins spin() noexcept { return Spins(reinterpret_cast<double*>(&body_.links[0].value.w)); }
  // Of a fixed base, its axes in world: where gravity comes from.
  void hold(const Eigen::Matrix3d& axes) noexcept;

  // What the robots weigh as they stand.  False: an inertia that is not positive; nothing may be
  // read then.
  [[nodiscard]] bool weigh() noexcept;

  // From any guess the accelerations, if the robots were weighed as they stand; else better ones:
  // their error is multiplied by the share by which the inertia has changed, of each posture.  How much
  // they change [rad/s^2], [m/s^2]: the root of the sum of squares over links, its mean over the postures.
  double improve(const Accelerations& guess, Accelerations& to) noexcept;

  // Of what the joint moves, everything else free, of posture 0 when it was weighed.
  double inverse_inertia(int joint) const noexcept {
    return body_.links[static_cast<std::size_t>(joint) + 1].value.inverse_d[0];
  }

 private:
  // The first four numbers are nobody's: link 0 has no joint.
  Rows rows(std::vector<double>& numbers) noexcept {
    return {numbers.data() + kCount, kCount, static_cast<Eigen::Index>(body_.links.size()) - 1};
  }

  RigidBody<Vec4> body_;
};

}  // namespace twinbus::sim
