// How far the points of a link can move when joints do: a bound over all postures.
//
//     |x(q + dq) - x(q)|  <=  sum over the joints between of |dq_j| reach(link, j)
//
// seen from link 0; seen from another link, the joints that move both drop out.  Along a direction n
// that is still for the observer, a joint counts only as far as its axis is not along n:
//
//     |n . (x(q + dq) - x(q))|  <=  sum of |dq_j| reach(link, j) min(1, |n x axis_j| + turn_j),
//
// turn_j the sum of |dq| of the joints before it, which may turn its axis.

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

class JointReach {
 public:
  // radius: of the geometry of every link about its origin [m]; what bears none does not move.
  JointReach(const Model& model, const std::vector<double>& radius);

  // The largest reach of a joint, over all links that it moves [m/rad, or 1 if it slides].
  double farthest(int joint) const noexcept;
  // Of a joint and a link that it moves; 0 if it does not.
  double of(int link, int joint) const noexcept {
    return reach_[static_cast<std::size_t>(link * joints_ + joint)];
  }
  // It is, of a joint that turns, the radius of the link and the length of the stretched chain to it,
  // less that to the link behind the joint [m].
  double radius(int link) const noexcept { return radius_[static_cast<std::size_t>(link)]; }
  double length(int link) const noexcept { return length_[static_cast<std::size_t>(link)]; }
  // By how much two links can come nearer when no joint moves farther than `moves` [joint_count,
  // rad or m, not negative] [m].  Link 0 and obstacles (link < 0) stand still.
  double between(int link_a, int link_b, const Eigen::VectorXd& moves) const noexcept;
  // The same of every link and link 0, all at once [link_count].
  void from_base(const Eigen::VectorXd& moves, std::vector<double>& of_links) noexcept;
  // The same along n alone (world, unit), from where the links are.
  double along(const Eigen::Vector3d& n, const Kinematics& kinematics, int link_a, int link_b,
               const Eigen::VectorXd& moves) const noexcept;

 private:
  template <class Visit>
  void climb(int link_a, int link_b, Visit visit) const noexcept;

  int joints_;
  std::vector<int> parent_;     // [link_count]
  std::vector<char> slides_;    // [joint_count]
  std::vector<double> reach_;   // [link_count x joint_count, m/rad or m/m]
  std::vector<double> radius_;  // [link_count, m]
  std::vector<double> length_;  // of the stretched chain to a link [link_count, m]
  struct Sums {                 // over the joints to a link
    double turned = 0.0, less = 0.0;
  };
  std::vector<Sums> sums_;  // [link_count]
};

}  // namespace twinbus::robot
