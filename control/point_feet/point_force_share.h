// Forces of standing point feet that together push and turn the trunk as is asked.
//
//     min  |S (sum f_i - F)|^2 + |T (sum r_i x f_i - M)|^2 + a |f|^2     with  |f_i tangential| <= mu f_i normal,  0 <= f_i normal <= most_i
//
// r_i from the centre of mass, z up.  Solved by ADMM: one Cholesky decomposition of 12 x 12 and a fixed number of rounds, each
// a solve and a projection on the cones; warm from tick to tick.  No allocation.  Forces that come out are within the cones,
// whatever was asked.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus::inline control {

inline constexpr int kPointFeet = 4;
using PointForces = std::array<Eigen::Vector3d, kPointFeet>;

struct PointFoot {
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  // from the centre of mass to where the foot presses [m]
  double most = 0.0;                              // normal force [N]; 0: in the air
};

// What the trunk is to feel, about the centre of mass, z up.
struct TrunkWrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // [N m]
};

class PointForceShare {
 public:
  // weight: of the robot [N]; length: half of the distance between feet, that makes forces of moments [m]; friction: coefficient.
  PointForceShare(double weight, double length, double friction) noexcept;

  void reset() noexcept;
  // Forces on the robot, world.
  const PointForces& solve(const std::array<PointFoot, kPointFeet>& feet, const TrunkWrench& wanted, int rounds) noexcept;

 private:
  using Vector12 = Eigen::Matrix<double, 3 * kPointFeet, 1>;
  double weight_, length_, friction_;
  Vector12 shared_ = Vector12::Zero(), price_ = Vector12::Zero();  // in shares of the weight
  PointForces force_;
};

// The nearest force within the cone of friction whose normal part is between 0 and most.
Eigen::Vector3d within_cone(const Eigen::Vector3d& force, double friction, double most) noexcept;

}  // namespace twinbus::control
