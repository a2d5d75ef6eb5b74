// Postures of the arm that answer a goal.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/math/index.h"
#include "common/math/splitmix64.h"
#include "planner/arm_question.h"
#include "planner/joint_turns.h"
#include "planner/search/edge_check.h"
#include "planner/timing/motion_effort.h"
#include "robot/kinematics/arm_span.h"
#include "robot/kinematics/inverse_kinematics.h"

namespace twinbus::inline planner {

namespace {

constexpr double kHandTolerance = 2e-4;  // of a goal posture [m]
constexpr double kTurnTolerance = 2e-3;  // [rad]
constexpr double kStubborn = 0.05;       // a miss that more tries may mend [m]
constexpr double kAround = 1.0;          // a base on the plane goes around things so wide [m]
constexpr double kNearby = 0.15;         // share of the way to a random posture
constexpr int kPatience = 8;             // times as many
constexpr int kIkTries = 4;              // of one start, the closed form among them
constexpr int kLeans = 8;                // steps until goal posture and lean agree
constexpr double kLeanTolerance = 5e-5;  // [m]
// A goal that is out of reach by no more than the servos' own error is answered by the nearest
// posture.
constexpr double kBarelyOut = 0.003;    // [m]
constexpr double kBarelyTurned = 0.02;  // [rad]
constexpr double kTurnWeight = 0.1;     // of what a missed pose is off by [m/rad]

}  // namespace

void stay_near(const Model& model, const Configuration& start, const std::vector<int>& joints, const Hand& hand,
               const Eigen::Vector3d& target, JointTurns& range) {
  Kinematics kinematics(model);
  kinematics.update(start);
  const double far = arm_span(kinematics, hand).length + kAround;
  for (std::size_t k = 0; k < joints.size() && k < model.plane_joints.size() && k < 2; ++k) {  // x, y
    if (joints[k] != model.plane_joints[k]) return;
    const double here = start.q[joints[k]], there = target[static_cast<Eigen::Index>(k)];
    const auto column = static_cast<int>(k);
    range.lower[column] = std::max(range.lower[column], std::min(here, there) - far);
    range.upper[column] = std::min(range.upper[column], std::max(here, there) + far);
    range.lower[column] = std::min(range.lower[column], here);
    range.upper[column] = std::max(range.upper[column], here);
  }
}

// Where the base is when the arm is at q: legs carry it so that the centre of mass rests.
Eigen::Isometry3d ArmPlanner::leaned(const Question& question, const Eigen::VectorXd& q) const {
  Configuration there = *question.start_posture;
  if (!balancing_) return there.base;
  Kinematics kinematics(*model_);
  kinematics.update(there);
  const Eigen::Vector3d com = kinematics.com();
  there.q = q;
  kinematics.update(there);
  there.base.pretranslate(com - kinematics.com());
  return there.base;
}

// For the guard: it keeps less of links that are near each other by design, and so does a goal.
bool ArmPlanner::too_near(EdgeCheck& space, const JointPoint& q, CollisionPair& pair) {
  if (shares_.least() >= 1.0) return true;
  std::array<PairDistance, kNearPairs> near;
  const int count = collision_.near_pairs(space.kinematics_at(q), config_.least_clearance, near.data(), kNearPairs);
  for (int i = 0; i < count; ++i) {
    const PairDistance& found = near[at(i)];
    pair = {found.link_a, found.link_b};
    if (found.distance <= config_.least_clearance * shares_.of(pair.link_a, pair.link_b)) return true;
  }
  return count == kNearPairs;
}

// Postures that answer the goal and keep the clearance, nearest to the start first.
bool ArmPlanner::find_goals(EdgeCheck& space, Question& question, SplitMix64& random,
                            ArmPlan& plan) {
  const ArmGoal& goal = *question.goal;
  bool reached_any = false;
  double best_miss = 1e9, miss_there = 0.0;
  double widest = -1e9;  // of the postures that are too near to something [m]
  JointPoint widest_q;
  const Eigen::Isometry3d base = question.start_posture->base;
  JointPath close_goals;  // nearer than others keep, where the guard lets links be: when there are no others
  MotionEffort effort(*model_, *question.start_posture, plan.joints);
  const auto consider = [&](const JointPoint& q, const Eigen::Isometry3d& base_there,
                            JointPath& goals) {
    if (!effort.holds(q)) return;
    reached_any = true;
    CollisionPair pair;
    bool close = space.who_is_near(q, config_.least_clearance, pair), near = close && too_near(space, q, pair);
    if (!near && balancing_) {
      space.set_base(base_there);
      close = space.who_is_near(q, config_.least_clearance, pair) || close;
      near = close && too_near(space, q, pair);
      space.set_base(base);
    }
    if (!near) {
      (close ? close_goals : goals).push_back(q);
    } else if (const double room = space.nearest(q, config_.clearance); room > widest) {
      widest = room;
      widest_q = q;
      plan.pair = pair;
    }
  };

  if (goal.kind == ArmGoalKind::kJoints) {
    JointPoint q = question.start;
    for (int k = 0; k < q.size(); ++k) {
      const auto& bus = model_->bus_joints;
      const auto index = std::find(bus.begin(), bus.end(), plan.joints[at(k)]) - bus.begin();
      q[k] = goal.q[static_cast<std::size_t>(index)];
      const Joint& joint = model_->joints[at(plan.joints[at(k)])];
      if (joint.kind == JointKind::kContinuous) q[k] = question.start[k] + std::remainder(q[k] - question.start[k], 2.0 * M_PI);
      question.range.take_in(k, q[k]);
      if (!(q[k] >= joint.lower && q[k] <= joint.upper)) {
        plan.status = ArmPathStatus::kBadGoal;
        plan.complaint = "a joint goal is beyond the joint's limits";
        return false;
      }
    }
    Eigen::VectorXd there = question.start_posture->q;
    for (int k = 0; k < q.size(); ++k) there[plan.joints[at(k)]] = q[k];
    consider(q, leaned(question, there), question.goals);
  } else {
    InverseKinematics arm(*model_, question.base_link, question.hand->link, question.hand->frame);
    for (const int j : arm.joints()) {  // between what moves
      if (std::find(plan.joints.begin(), plan.joints.end(), j) == plan.joints.end()) arm.hold(j, question.start_posture->q[j]);
    }
    IkOptions options;
    options.position_tolerance = kHandTolerance;
    options.rotation_tolerance = kTurnTolerance;
    options.limit_margin = kInside;
    options.restarts = kIkTries;
    if (goal.kind == ArmGoalKind::kPosition) options.rotation_weight = 0.0;
    Eigen::VectorXd q = question.start_posture->q;
    const auto enough = [&](int tries) {
      if (static_cast<int>(question.goals.size()) >= config_.goal_postures) return true;
      const bool stubborn = question.goals.empty() && (reached_any || best_miss < kStubborn);
      return tries > (stubborn ? kPatience : 1) * config_.ik_restarts;
    };
    for (int i = 0; !enough(i); ++i) {
      if (i > 0) {
        // Then also around the one that is least in the way.
        const bool climb = i > config_.ik_restarts && i % 2 == 0 && widest > -1e9;
        const bool as_it_is = question.carriers > 0 && i % 2 == 1;  // the arm, moved by what carries it
        for (int k = 0; k < question.start.size(); ++k) {
          if (as_it_is && k >= question.carriers) {
            q[plan.joints[at(k)]] = question.start[k];
            continue;
          }
          const double dice = random.uniform(question.range.lower[k], question.range.upper[k]);
          const double there = climb ? widest_q[k] + kNearby * (dice - widest_q[k]) : dice;
          q[plan.joints[at(k)]] = there;
        }
      }
      // The closed form may give one answer from wherever it starts: when that is in the way, every
      // other pair of tries goes down from where the dice put it.
      options.restarts = question.goals.empty() && reached_any && i % 4 < 2 ? 0 : kIkTries;
      IkResult result = arm.solve(question.target, options, q);
      Eigen::Isometry3d there = base;
      for (int lean = 0; balancing_ && lean < kLeans && result.position_error < kStubborn; ++lean) {
        const Eigen::Isometry3d next = leaned(question, q);
        const double change = (next.translation() - there.translation()).norm();
        there = next;
        if (change < kLeanTolerance) break;
        Eigen::Isometry3d target = question.target;  // the link the arm hangs on moves as the base
        target.pretranslate(question.base_in_world.transpose() *
                            (base.translation() - there.translation()));
        result = arm.solve(target, options, q);
      }
      const double miss = result.position_error + kTurnWeight * result.rotation_error *
                                                      (options.rotation_weight > 0.0 ? 1.0 : 0.0);
      if (miss < best_miss) {
        best_miss = miss;
        miss_there = result.position_error;
      }
      const bool barely = result.position_error < kBarelyOut &&
          (goal.kind == ArmGoalKind::kPosition || result.rotation_error < kBarelyTurned);
      if (result.reached || barely)
        consider(question.range.within(pick(q, plan.joints)), there, result.reached ? question.goals : question.nearly);
    }
    if (question.goals.empty()) question.goals = std::move(question.nearly);
  }
  if (question.goals.empty()) question.goals = std::move(close_goals);
  if (question.goals.empty() && !reached_any && effort.weak_joint() >= 0) {
    plan.complaint = too_heavy(*model_, effort, "there");
    plan.heavy = ArmPlan::Heavy::kThere;
    return false;
  }
  if (question.goals.empty()) {
    plan.status = reached_any ? ArmPathStatus::kGoalInCollision : ArmPathStatus::kUnreachable;
    plan.oriented = goal.kind == ArmGoalKind::kPose;
    plan.miss = reached_any ? 0.0 : miss_there;
    return false;
  }
  const auto takes = [&](const JointPoint& q) {  // the slowest joint, at full speed [s]
    double longest = 0.0;
    for (int k = 0; k < q.size(); ++k)
      longest = std::max(longest, std::abs(q[k] - question.start[k]) / model_->joints[at(plan.joints[at(k)])].velocity);
    return longest;
  };
  std::stable_sort(question.goals.begin(), question.goals.end(),
                   [&](const JointPoint& a, const JointPoint& b) {
                     if (question.carriers > 0) return takes(a) < takes(b);
                     return (a - question.start).squaredNorm() < (b - question.start).squaredNorm();
                   });
  return true;
}

}  // namespace twinbus::planner
