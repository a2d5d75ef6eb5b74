// Straight lines of an arm as a search asks for them: balls around the links prove most of them free
// in microseconds, exact distances settle the rest.

#pragma once

#include <vector>

#include "planner/batch/check.h"
#include "planner/search/certain_path.h"
#include "planner/search/edge_check.h"
#include "planner/search/rrt_connect.h"

namespace twinbus::inline planner {

SearchPoint to_search(const JointPoint& q);
JointPoint from_search(const SearchPoint& q, int joints);

class ArmLines : public LineTest {
 public:
  // exact: with its clearance set; must outlive this.  groups: balls of all links of the model, then of the obstacles.
  ArmLines(const Model& model, EdgeCheck& exact, const Collision& collision,
           const std::vector<BallGroup>& groups, const std::vector<Obstacle>& obstacles);

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override;
  // A short way of which every line is proved by balls, hulls and pieces alone, as find_certain.
  CertainPath find_proved(JointSearch& search, const SearchPoint& start, const SearchPath& goals, bool (*keep_on)(void*),
                          void* user);
  // Does a cubic, given by its Bezier points, keep the clearance that `exact` has now?  Its chord
  // is proved to keep that and how far the curve strays from it; what takes too many pieces takes exact distances.
  bool curve_free(const std::array<JointPoint, 4>& curve);

  std::int64_t proved() const { return proved_; }    // lines that balls were enough for
  std::int64_t settled() const { return settled_; }  // lines that took exact distances

 private:
  void keep_less_at_ends(const Model& model, const std::vector<BallGroup>& groups, const std::vector<Obstacle>& obstacles);
  bool proves(const std::array<JointPoint, 4>& curve, double room, int halvings);

  EdgeCheck* exact_;
  BlockScene scene_;
  BlockRobot robot_;
  std::vector<EndPair> ends_;  // with the margins that lines keep
  BlockCheck check_;
  std::int64_t proved_ = 0, settled_ = 0;
};

// Balls of all links: along each link's capsule, which holds its triangles.  Throws as
// build_geometry.
std::vector<BallGroup> balls_along_links(const Model& model);
// The same of what hands hold, in the order of the obstacles that take part; the others get no balls.
std::vector<BallGroup> balls_along_held(const Model& model, const std::vector<Obstacle>& obstacles);

}  // namespace twinbus::planner
