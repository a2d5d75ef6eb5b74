// From "the left hand there" to a timed motion of that arm that touches neither the robot nor an
// obstacle.
//
// Legs, waist, the other arm and the base stay as in the start.  What carries the arm (Hand::carriers: a lift, a base on the plane)
// moves only for a goal that the arm does not reach by itself: first the lift, then the base, then both.  Nothing depends on the time or the
// machine: the same question with the same seed gives the same motion, bit for bit.

#pragma once

#include <cstdint>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lcmtypes/msg/guard_defaults.h"
#include "planner/batch/robot.h"
#include "planner/timing/path_timing.h"
#include "robot/collision/collision.h"
#include "robot/collision/near_pairs.h"
#include "robot/collision/thing_name.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline common {
class SplitMix64;
}  // namespace twinbus::common

namespace twinbus::inline planner {

struct ArmPlannerConfig {
  double clearance = 0.020;        // kept to everything where start and goal allow it [m]
  double least_clearance = GuardDefaults::kAtGoal;  // a goal must keep this: the guard holds the arm at less [m]
  // Obstacles are taken for thicker by this where start and goal allow it: a balancing body moves
  // while its arm does, and the guard holds the arm before it is too near [m].
  double padding = 0.030;
  double full_speed_time = 0.5;  // from rest to a joint's velocity limit at speed 1 [s]
  double full_push_time = 0.1;   // from rest to the acceleration that takes [s]
  int ik_restarts = 80;          // random postures to look for a goal posture from
  int goal_postures = 6;         // enough of them
  int rrt_rounds = 8000;         // of a search; when no way was found, five times as many, keeping least_clearance
  double knot_spacing = 0.025;  // [s]
};

struct ArmPlan {
  enum class Heavy { kNo, kThere, kOnTheWay };
  ArmPathStatus status = ArmPathStatus::kBadGoal;
  std::string complaint;    // kBadGoal: what is wrong with it
  Heavy heavy = Heavy::kNo;  // kBadGoal: where joints cannot hold the arm
  CollisionPair pair;       // kStartInCollision, kGoalInCollision
  std::array<ThingName, 2> touching{};  // the same by name
  double miss = 0.0;        // kUnreachable: by how much [m]
  bool oriented = false;    // kUnreachable: the goal has an orientation, too
  std::vector<int> joints;  // model indices of the columns
  TimedPath path;           // kOk
  // Proved: every posture of the path, between knots too, keeps it [m]; 0 where the path begins by taking something off what it
  // stands on.
  double clearance = 0.0;
  double padding = 0.0;     // that it keeps to obstacles besides [m]
  int rounds = 0;           // of all searches of the last attempt; 0: the straight way was free
  std::int64_t checks = 0;  // postures whose exact distances were asked for
  // To a goal that is one: none was found, or none on which the joints can hold the arm.
  bool no_way() const { return status == ArmPathStatus::kTimeLimit || heavy == Heavy::kOnTheWay; }
  double duration() const { return path.empty() ? 0.0 : path.back().time; }
};

class ArmPlanner {
 public:
  // The model must outlive the planner.  Throws std::runtime_error if a mesh cannot be read.
  explicit ArmPlanner(const Model& model, const ArmPlannerConfig& config = {});

  // In the world of `start`'s base, or held by a hand: what is held is planned with as a part of it.
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  // Does the body give way to the arm, so that the centre of mass stays where it is?  Goals then
  // mean the hand when the body has done so.
  void set_balancing(bool yes) { balancing_ = yes; }

  // start: the posture and base pose now.  ground_in_world: the frame goals are given in.  keep_on,
  // when given: asked now and then; false ends the plan with kCancelled.
  ArmPlan plan(const ArmGoal& goal, const Configuration& start,
               const Eigen::Isometry3d& ground_in_world, std::uint64_t seed,
               bool (*keep_on)(void*) = nullptr, void* user = nullptr);

  // Is it proved of every instant of the motion that it keeps `clearance` [m]?
  bool path_free(const ArmPlan& plan, const Configuration& start, double clearance);

  const Model& model() const { return *model_; }

 private:
  struct Question;
  struct Effort {
    std::vector<int> carriers = {};  // that move with the arm
    double clearance = 0.0;  // [m]
    int rounds = 0;
    bool exact = false;  // exact distances decide the lines that are not proved; on return: they did
  };
  // carriers: that move with the arm; patience: it is searched for long before there is said to be no way.
  ArmPlan plan_with(const std::vector<int>& carriers, bool patience, const ArmGoal& goal, const Configuration& start,
                    const Eigen::Isometry3d& ground_in_world, std::uint64_t seed, bool (*keep_on)(void*), void* user);
  ArmPlan attempt(const ArmGoal& goal, const Configuration& start,
                  const Eigen::Isometry3d& ground_in_world, std::uint64_t seed, Effort& spent,
                  bool (*keep_on)(void*), void* user);
  bool understand(const std::vector<int>& carriers, const ArmGoal& goal, const Configuration& start,
                  const Eigen::Isometry3d& ground, Question& question, ArmPlan& plan) const;
  Eigen::Isometry3d leaned(const Question& question, const Eigen::VectorXd& q) const;
  bool find_goals(class EdgeCheck& space, Question& question, SplitMix64& random,
                  ArmPlan& plan);
  const BallGroup& balls_of(const Obstacle& held);
  bool too_near(class EdgeCheck& space, const JointPoint& q, CollisionPair& pair);
  TimedPath timed(class EdgeCheck& space, class ArmLines& lines, const JointPath& corners, const TimingLimits& limits,
                  int most_knots) const;
  double within_efforts(const Configuration& start, ArmPlan& plan) const;

  const Model* model_;
  ArmPlannerConfig config_;
  MarginShares shares_;  // of what is kept of links that are near by design
  bool balancing_ = false;
  Collision collision_;
  std::vector<BallGroup> balls_;     // of all links, then of what is held
  std::size_t link_balls_;           // of them those of links
  std::vector<std::pair<Obstacle, BallGroup>> held_balls_;  // of what was held lately
  std::vector<int> looped_;          // joints that closed loops tie, refused
  std::vector<Obstacle> obstacles_;  // as they are
  std::vector<Obstacle> padded_;     // as a plan takes them
};

// One sentence for people: what was planned, or why not and what to do.
std::string describe(const ArmPlan& plan);

}  // namespace twinbus::planner
