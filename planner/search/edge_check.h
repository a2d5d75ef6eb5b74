// Straight lines in joint space against the robot's own body and the obstacles, with no gap for
// anything to slip through.
//
// A point on a link moves at most
//
//     |dx| <= sum over joints of reach_j |dq_j|
//
// where reach_j is the largest distance of any link point from joint j's axis in any posture.  A
// line is sampled so finely that this bound is at most twice the clearance between two samples;
// every sample keeps the clearance, so no posture between them touches.  Where some pairs keep less, samples are as close as the
// nearest pair at them asks for.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planner/search/free_space.h"
#include "robot/collision/collision.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

inline constexpr int kNearPairs = 64;  // looked at in one posture; more are too many

// The halves of a cubic that is given by its Bezier points.
std::array<std::array<JointPoint, 4>, 2> halves(const std::array<JointPoint, 4>& curve);

// Two links, or a link and an obstacle, that are near each other where a motion begins or ends: it keeps less of them than of others.
struct EndPair {
  int link_a = 0, link_b = 0;
  double room = 0.0;    // there [m]
  double margin = 0.0;  // that is kept [m]
};

class EdgeCheck : public FreeSpace {
 public:
  // Everything but `joints` (model indices) stays as in posture.  clearance [m], positive.  model
  // and collision must outlive this; collision must already know the obstacles, in the world of the
  // posture's base.
  EdgeCheck(const Model& model, Collision& collision, const Configuration& posture,
            const std::vector<int>& joints, double clearance);

  bool point_free(const JointPoint& q) override;
  bool line_free(const JointPoint& from, const JointPoint& to) override;

  // Every point of a cubic, given by its Bezier points: it stays in their hull, so from its middle
  // no point of the robot moves farther than the bound above of the farthest of them. Halved until
  // that proves that the clearance is kept; no is also said when that takes too long.
  bool curve_free(const std::array<JointPoint, 4>& curve, int halvings = 12);

  // Which pair is in the way at q; false when none is.
  bool who_is_near(const JointPoint& q, double clearance, CollisionPair& pair);
  // Distance of the nearest pair at q, at most `far` [m].
  double nearest(const JointPoint& q, double far);
  // The most any point of the robot moves between two postures [m].
  double motion_bound(const JointPoint& from, const JointPoint& to) const;

  // Distance of the nearest pair at q, at most `far`, but for pairs nearer than `close` [m], which are added to ends.
  double nearest_beside(const JointPoint& q, double far, double close, std::vector<EndPair>& ends);
  // From now on these pairs keep their margins, times `share`, instead of the clearance.
  void keep_at_ends(const std::vector<EndPair>& ends) { ends_ = ends; }
  void set_share_at_ends(double share) { share_ = share; }
  const std::vector<EndPair>& ends() const { return ends_; }
  // What is kept of two, now [m].
  double margin(int link_a, int link_b) const;
  // The least that is kept of any pair [m].
  double kept() const;

  void set_clearance(double clearance) { clearance_ = clearance; }
  void set_base(const Eigen::Isometry3d& base) { posture_.base = base; }  // in the world
  double clearance() const { return clearance_; }
  std::int64_t checks() const { return checks_; }  // postures looked at so far
  const Kinematics& kinematics_at(const JointPoint& q);
  const std::vector<int>& joints() const { return joints_; }
  const Configuration& posture() const { return posture_; }

 private:
  double room(const JointPoint& q);
  bool clear_by(const JointPoint& q, double moves);
  bool between(const JointPoint& from, double room_from, const JointPoint& to, double room_to, int halvings);

  Collision* collision_;
  std::vector<EndPair> ends_;
  double share_ = 1.0;
  Configuration posture_;
  Kinematics kinematics_;
  std::vector<int> joints_;
  JointPoint reach_;  // [m/rad or m/m]
  double clearance_;
  std::int64_t checks_ = 0;
};

}  // namespace twinbus::planner
