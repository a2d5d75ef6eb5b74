// Joint angles of an arm or a leg without iterating, for chains built like most of them are: three
// axes that meet (shoulder, hip), one more (elbow, knee), two that meet (wrist, ankle), or the same
// from the other end.  Further joints are locked by the caller.
//
// With the pose as a product of rotations about the axes of the zero posture,
//
//     pose(q) pose(0)^-1 = e^(x1 q1) ... e^(xn qn),
//
// the distance between the two meeting points gives the elbow, then directions give pairs of joints
// (subproblems of Paden and Kahan; Murray, Li, Sastry 1994, section 3.2).  Up to eight postures.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

class ClosedForm {
 public:
  static constexpr int kSolved = 6;
  static constexpr int kMaxChain = 16;
  using Angles = std::array<double, kMaxChain>;  // chain order, base first

  // Of the postures with the locked joints as given, the one least beyond limits, then nearest to
  // the start.
  struct Candidate {
    Angles q{};
    double beyond = std::numeric_limits<double>::infinity();    // limits, sum over joints [rad]
    double distance = std::numeric_limits<double>::infinity();  // from the start [rad]
  };

  // path: joints from a base link to a tip, base first; frame: of the tip in its link.  Any chain may
  // be given; usable() tells whether it is of the kind above.
  ClosedForm(const Model& model, const std::vector<int>& path, const Eigen::Isometry3d& frame);

  bool usable() const noexcept { return first_ >= 0; }
  // Chain positions of the joints that are not solved for.
  const std::vector<int>& locked() const noexcept { return locked_; }

  // Betters `best` if a posture for the target (in the base link's frame) does.  start: where locked
  // joints have their values and the others are wished to be.  A target out of reach gives the
  // posture that comes near it, with its lack of reach counted as beyond limits.
  void solve(const Eigen::Isometry3d& target, const Angles& start, const Angles& low,
             const Angles& high, Candidate& best) const noexcept;

 private:
  struct Axis {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(), point = Eigen::Vector3d::Zero();
    bool slides = false;
    int joint = 0;  // chain position
  };
  struct Branch;

  bool find_window() noexcept;
  double angle_at(std::size_t i, double angle, const Angles& start, const Angles& low,
                  const Angles& high, Branch& branch) const noexcept;

  std::vector<Axis> axes_;  // base first, or tip first when reversed_
  std::vector<int> locked_;
  Eigen::Isometry3d zero_inverse_;  // of the tip at the zero posture
  Eigen::Vector3d shoulder_, wrist_;
  int first_ = -1;  // of axes_ that are solved for
  bool reversed_ = false;
};

}  // namespace twinbus::robot
