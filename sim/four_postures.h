// Forward dynamics of one robot at four postures at once: each in a lane of its own
// (sim/articulated_lanes.h), for what a short vector of postures costs little more than one.
// For methods that need several independent evaluations (sim/gauss_flight.h).
//
// Nothing touches: there are gravity and the torques of the joints, rotors included.

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "robot/model.h"
#include "sim/articulated_body.h"

namespace twinbus {

class FourPostures {
 public:
  static constexpr int kCount = 4;
  // A row for each posture, a column for each joint.
  using Rows = Eigen::Map<Eigen::Array<double, kCount, Eigen::Dynamic>>;

  // A model that ArticulatedBody takes.
  FourPostures(const Model& model, bool fixed_base, double mass_scale);

  // What to fill in before accelerate(): angles [rad], rates [rad/s] and torques [N m] of the
  // joints, [m], [m/s] and [N] of prismatic ones.
  Rows q() noexcept { return rows(lanes_.angle); }
  Rows qd() noexcept { return rows(lanes_.rate); }
  Rows torque() noexcept { return rows(lanes_.force); }
  // Axes and velocity of link 0 in world [rad/s], [m/s]; of a fixed base the axes alone count.
  void set_base(int posture, const Eigen::Matrix3d& axes, const Eigen::Vector3d& angular_velocity,
                const Eigen::Vector3d& velocity) noexcept;

  // False: an inertia that is not positive; nothing may be read then.
  [[nodiscard]] bool accelerate() noexcept;

  double qdd(int posture, int joint) const noexcept {
    return lanes_.links[at(joint + 1)].qdd[posture];
  }
  // Of link 0 in world: angular, then of its origin; in its own axes the velocity's derivative is that, turned.
  Screw base_acceleration(int posture) const noexcept;
  // Of what the joint moves, everything else free, at posture 0.
  double inverse_inertia(int joint) const noexcept {
    return lanes_.links[at(joint + 1)].inverse_d[0];
  }

 private:
  // Rank r has link r in all of its lanes, which joint r - 1 moves.
  Rows rows(std::vector<double>& numbers) noexcept {
    return {numbers.data() + kCount, kCount, static_cast<Eigen::Index>(lanes_.links.size()) - 1};
  }

  BodyLanes<Vec4> lanes_;
  LinkNumbers links_;
  RootFactors<Vec4> root_;
};

}  // namespace twinbus
