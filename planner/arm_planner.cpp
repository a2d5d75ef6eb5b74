#include "planner/arm_planner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "planner/held_lines.h"
#include "planner/joint_turns.h"
#include "planner/lift.h"
#include "planner/search/arm_lines.h"
#include "planner/search/edge_check.h"
#include "planner/timing/motion_effort.h"
#include "common/math/splitmix64.h"
#include "planner/search/shorten.h"
#include "common/math/index.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/collision/loop_joints.h"
#include "robot/description/hand_of.h"

namespace twinbus {

namespace {

constexpr double kTouching = 0.001;  // a start nearer than this counts as touching [m]
constexpr double kShare = 0.9;       // of the room at start and goal that the way must keep
constexpr double kLeaving = 0.98;    // of the room of what a guard would hold on its way nearer
constexpr double kProved = 0.7;  // share of the clearance of the search that the motion is proved to keep
constexpr double kGuarded = GuardDefaults::kInController + 5e-4;  // which is no less than this where a slower motion keeps it [m]
constexpr double kUnit = 0.01;         // what the length of a quaternion may be off by
constexpr double kInside = 0.01;       // goal postures stay this far inside the joint limits [rad]
constexpr double kWidestCorner = 0.4;  // [rad]
constexpr int kMostKnots = 360;        // what 60 pieces of an arm path hold
constexpr double kHandTolerance = 2e-4;  // of a goal posture [m]
constexpr double kTurnTolerance = 2e-3;  // [rad]
constexpr double kStubborn = 0.05;       // a miss that more tries may mend [m]
constexpr double kNearby = 0.15;         // share of the way to a random posture
constexpr int kPatience = 8;             // times as many
constexpr int kLongPatience = 5;         // times as many rounds when no way was found
constexpr int kIkTries = 4;              // of one start, the closed form among them
constexpr int kLeans = 8;                // steps until goal posture and lean agree
constexpr double kLeanTolerance = 5e-5;  // [m]
// A goal that is out of reach by no more than the servos' own error is answered by the nearest
// posture.
constexpr double kBarelyOut = 0.003;    // [m]
constexpr double kBarelyTurned = 0.02;  // [rad]
constexpr double kTurnWeight = 0.1;     // of what a missed pose is off by [m/rad]

bool is_arm_joint(const Model& model, int joint) {
  for (const Hand& hand : model.hands) {
    if (std::find(hand.joints.begin(), hand.joints.end(), joint) != hand.joints.end()) return true;
  }
  return false;
}

// What is not a shape stays none, and what is held as it is.
void pad(Obstacle& obstacle, double by) {
  if (obstacle.hand >= 0) return;
  if (!(obstacle.size.head(obstacle.shape == ObstacleShape::kBox ? 3 : 1).minCoeff() > 0.0)) return;
  if (obstacle.shape == ObstacleShape::kBox) obstacle.size.array() += 2.0 * by;
  if (obstacle.shape == ObstacleShape::kSphere) obstacle.size.x() += by;
  if (obstacle.shape == ObstacleShape::kCylinder)
    obstacle.size.head<2>() += Eigen::Vector2d(by, 2.0 * by);
}

JointPoint pick(const Eigen::VectorXd& q, const std::vector<int>& joints) {
  JointPoint point(static_cast<int>(joints.size()));
  for (int k = 0; k < point.size(); ++k) point[k] = q[joints[at(k)]];
  return point;
}

std::string too_heavy(const Model& model, const MotionEffort& effort, const char* where) {
  return std::string(where) + " joint " + model.joints[at(effort.weak_joint())].name +
         " would need more than its effort limit to hold the arm";
}

}  // namespace

struct ArmPlanner::Question {
  const ArmGoal* goal = nullptr;
  const Configuration* start_posture = nullptr;
  const Hand* hand = nullptr;
  int base_link = 0;                                            // that the arm hangs on
  Eigen::Isometry3d target;                                     // of the hand frame, in base_link
  Eigen::Matrix3d base_in_world = Eigen::Matrix3d::Identity();  // how base_link is turned
  JointPoint start;
  JointTurns range;  // of the joints
  JointPath goals;   // free postures that answer the goal
  JointPath nearly;  // and some that barely miss it
};

ArmPlanner::ArmPlanner(const Model& model, const ArmPlannerConfig& config)
    : model_(&model),
      config_(config),
      shares_(model),
      collision_(model),
      balls_(balls_along_links(model)),
      link_balls_(balls_.size()),
      looped_(joints_in_loops(model)) {}

// Fills the question; false, with the reason in plan, if it makes no sense for this robot.
bool ArmPlanner::understand(const ArmGoal& goal, const Configuration& start,
                            const Eigen::Isometry3d& ground, Question& question,
                            ArmPlan& plan) const {
  const auto refuse = [&](const char* complaint) {
    plan.status = ArmPathStatus::kBadGoal;
    plan.complaint = complaint;
    return false;
  };
  if (!(goal.speed > 0.0F && goal.speed <= 1.0F)) return refuse("speed must be above 0 and at most 1");
  question.goal = &goal;
  question.start_posture = &start;
  if (goal.kind == ArmGoalKind::kJoints) {
    for (int k = 0; k < std::min(model_->bus_count(), kMaxJoints); ++k) {
      if (((goal.joint_mask >> k) & 1) == 0) continue;
      const int joint = model_->bus_joints[at(k)];
      if (!is_arm_joint(*model_, joint)) return refuse("joint_mask names a joint that is not of an arm");
      plan.joints.push_back(joint);
    }
    if (plan.joints.empty()) return refuse("joint_mask names no joint");
    if (plan.joints.size() > at(kArmJoints)) return refuse("more than 12 joints at once");
  } else if (goal.kind == ArmGoalKind::kPosition || goal.kind == ArmGoalKind::kPose) {
    if (goal.side != ArmSide::kLeft && goal.side != ArmSide::kRight) return refuse("side must be left or right");
    question.hand = hand_of(*model_, goal.side == ArmSide::kLeft ? 0 : 1);
    if (question.hand == nullptr || question.hand->joints.empty()) return refuse("the robot has no such hand");
    if (question.hand->joints.size() > at(kArmJoints)) return refuse("the arm has more than 12 joints");
    plan.joints = question.hand->joints;
    question.base_link = model_->joints[at(plan.joints.front())].parent;
    Eigen::Isometry3d in_ground = Eigen::Isometry3d::Identity();
    in_ground.translation() = Eigen::Vector3d(goal.position[0], goal.position[1], goal.position[2]);
    if (goal.kind == ArmGoalKind::kPose) {
      const Eigen::Quaterniond w(goal.orientation[0], goal.orientation[1], goal.orientation[2], goal.orientation[3]);
      if (!(std::abs(w.norm() - 1.0) < kUnit)) return refuse("orientation must have length 1");
      in_ground.linear() = w.normalized().toRotationMatrix();
    }
    if (!in_ground.matrix().allFinite()) return refuse("position and orientation must be finite");
    Kinematics kinematics(*model_);
    kinematics.update(start);
    const Eigen::Isometry3d& base = kinematics.link_in_world(question.base_link);
    question.target = base.inverse() * ground * in_ground;
    question.base_in_world = base.linear();
  } else {
    return refuse("kind must be joints, position or pose");
  }

  for (const int joint : plan.joints) {
    if (std::find(looped_.begin(), looped_.end(), joint) == looped_.end()) continue;
    plan.status = ArmPathStatus::kBadGoal;
    plan.complaint = "joint " + model_->joints[at(joint)].name +
                     " is in a closed loop (loops: of robot.yaml), and the planner moves every joint by itself";
    return false;
  }

  const auto parts = std::count_if(balls_.begin(), balls_.end(), [](const BallGroup& group) { return !group.balls.empty(); });
  if (parts > kBlockGroups) return refuse("the robot and what it holds have more parts than planning takes");
  for (const Hand& hand : model_->hands) {  // that joint goals move
    if (question.hand == nullptr && hand.link >= 0 && hand.joints == plan.joints) question.hand = &hand;
  }
  question.start = pick(start.q, plan.joints);
  question.range = JointTurns(*model_, plan.joints, question.start);
  return true;
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
        for (int k = 0; k < question.start.size(); ++k) {
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
    return false;
  }
  if (question.goals.empty()) {
    plan.status = reached_any ? ArmPathStatus::kGoalInCollision : ArmPathStatus::kUnreachable;
    plan.oriented = goal.kind == ArmGoalKind::kPose;
    plan.miss = reached_any ? 0.0 : miss_there;
    return false;
  }
  std::stable_sort(question.goals.begin(), question.goals.end(),
                   [&](const JointPoint& a, const JointPoint& b) {
                     return (a - question.start).squaredNorm() < (b - question.start).squaredNorm();
                   });
  return true;
}

TimedPath ArmPlanner::timed(EdgeCheck& space, ArmLines& lines, const JointPath& corners,
                            const TimingLimits& limits, int most_knots) const {
  const double clearance = space.clearance();
  // What is interpolated between knots may stray a little from the rounded path.
  const double least = kProved * clearance, kept = std::max(least, std::min(clearance, kGuarded));
  const bool guarded = kept > least || space.kept() < clearance;  // or what is near at an end would lose what a guard keeps
  for (int i = guarded ? 0 : 3; i < 6; ++i) {
    const std::vector<RoundedPath> parts = RoundedPath::parts(space, corners, std::array{kWidestCorner, 0.1, 0.0}[at(i % 3)]);
    TimedPath path = time_path(parts, limits, config_.knot_spacing, most_knots);
    space.set_clearance(i < 3 ? kept : least);
    space.set_share_at_ends(i < 3 ? 1.0 : kProved);
    bool free = true;
    for (std::size_t n = 0; free && n + 1 < path.size(); ++n) free = lines.curve_free(bezier_between(path[n], path[n + 1]));
    space.set_clearance(clearance);
    space.set_share_at_ends(1.0);
    if (free) return path;
  }
  return {};
}

// As slow as the joints' efforts ask; no path if one cannot hold the arm on the way.
void ArmPlanner::within_efforts(const Configuration& start, ArmPlan& plan) const {
  MotionEffort effort(*model_, start, plan.joints);
  const double slower = effort.slower(plan.path);
  if (slower > 1.0) slow_down(plan.path, slower);
  if (slower > 0.0) return;
  plan.path.clear();
  plan.status = ArmPathStatus::kBadGoal;
  plan.complaint = too_heavy(*model_, effort, "on the way");
}

void ArmPlanner::set_obstacles(const std::vector<Obstacle>& obstacles) {
  obstacles_ = obstacles;
  balls_.resize(link_balls_);
  for (BallGroup& held : balls_along_held(*model_, obstacles)) balls_.push_back(std::move(held));
  collision_.set_obstacles(obstacles_);
}

ArmPlan ArmPlanner::plan(const ArmGoal& goal, const Configuration& start,
                         const Eigen::Isometry3d& ground_in_world, std::uint64_t seed,
                         bool (*keep_on)(void*), void* user) {
  ArmPlan plan;
  std::int64_t checks = 0;
  for (const double padding : {config_.padding, 0.5 * config_.padding, 0.0}) {
    if (obstacles_.empty() && padding > 0.0) continue;
    padded_ = obstacles_;
    for (Obstacle& obstacle : padded_) pad(obstacle, padding);
    collision_.set_obstacles(padded_);
    plan = attempt(goal, start, ground_in_world, seed, keep_on, user);
    plan.padding = padding;
    plan.checks = checks += plan.checks;
    const bool in_the_way = plan.status == ArmPathStatus::kStartInCollision || plan.status == ArmPathStatus::kGoalInCollision ||
                            plan.status == ArmPathStatus::kTimeLimit;
    if (!in_the_way) break;
  }
  if (plan.status == ArmPathStatus::kTimeLimit) {  // then with patience, and as near as a goal may be
    const ArmPlannerConfig usual = config_;
    config_.clearance = std::min(config_.clearance, config_.least_clearance);
    config_.rrt_rounds *= kLongPatience;
    ArmPlan other = attempt(goal, start, ground_in_world, seed, keep_on, user);
    config_ = usual;
    other.checks += checks;
    plan = std::move(other);
  }
  collision_.set_obstacles(obstacles_);
  if (plan.status == ArmPathStatus::kStartInCollision || plan.status == ArmPathStatus::kGoalInCollision)
    plan.touching = {thing_name(*model_, obstacles_, plan.pair.link_a), thing_name(*model_, obstacles_, plan.pair.link_b)};
  return plan;
}

ArmPlan ArmPlanner::attempt(const ArmGoal& goal, const Configuration& start,
                            const Eigen::Isometry3d& ground_in_world, std::uint64_t seed,
                            bool (*keep_on)(void*), void* user) {
  ArmPlan plan;
  Question question;
  if (!understand(goal, start, ground_in_world, question, plan)) return plan;
  SplitMix64 random(seed);
  EdgeCheck space(*model_, collision_, start, plan.joints, config_.clearance);

  double room_at_start = space.nearest(question.start, config_.clearance);
  Lift lift(*model_, collision_, space);
  JointPath off;  // what the hand holds is taken off what it stands on
  if (question.hand != nullptr && !(room_at_start > kTouching) && lift.find(*question.hand, question.start, off)) {
    room_at_start = space.nearest(off.back(), config_.clearance);
    question.start = off.back();
  }
  if (!(room_at_start > kTouching)) {
    space.who_is_near(question.start, kTouching, plan.pair);
    plan.status = ArmPathStatus::kStartInCollision;
    return plan;
  }
  if (!find_goals(space, question, random, plan)) return plan;
  const JointPath all_goals = question.goals;
  MotionEffort effort(*model_, start, plan.joints);
  bool held = false;     // only where the joints can hold the arm
  bool unfound = false;  // no way was found to some of the goals, too heavy ones to the others
  for (;;) {
    std::vector<EndPair> ends;  // so near that a share of their room may be less than what a guard keeps
    double room = std::min(config_.clearance, space.nearest_beside(question.start, config_.clearance, kGuarded / kShare, ends));
    for (const JointPoint& q : question.goals)
      room = std::min(room, space.nearest_beside(q, config_.clearance, kGuarded / kShare, ends));
    for (EndPair& end : ends)
      end.margin = std::max(kShare * end.room, std::min(kGuarded * shares_.of(end.link_a, end.link_b), kLeaving * end.room));
    space.set_clearance(kShare * room);
    space.keep_at_ends(ends);

    ArmLines lines(*model_, space, collision_, balls_, padded_);
    SearchLimits limits = question.range.limits();
    limits.most_rounds = config_.rrt_rounds;
    limits.seed = seed;
    JointSearch search(limits);
    SearchPath goals;
    for (const JointPoint& q : question.goals) goals.push_back(to_search(q));
    const int joints = static_cast<int>(question.start.size());
    HeldLines light(lines, effort, joints);
    LineTest& test = held ? static_cast<LineTest&>(light) : lines;
    SearchPath found = search.find(test, to_search(question.start), goals, keep_on, user);
    plan.rounds = search.rounds();
    plan.checks = space.checks();
    if (found.empty()) {
      const bool cancelled = keep_on != nullptr && !keep_on(user);
      if (!cancelled && !held && question.goals.size() < all_goals.size()) {
        held = unfound = true;
        question.goals = all_goals;
        continue;
      }
      if (cancelled || !held || unfound) {
        plan.status = cancelled ? ArmPathStatus::kCancelled : ArmPathStatus::kTimeLimit;
        plan.complaint.clear();
      }
      return plan;
    }
    shorten(test, found, joints);
    // The ends are what was asked for, to the last bit.
    const std::size_t goal_index = at(static_cast<int>(std::find(goals.begin(), goals.end(), found.back()) - goals.begin()));
    JointPath corners;
    for (const SearchPoint& q : found) corners.push_back(from_search(q, joints));
    corners.front() = question.start;
    corners.back() = question.goals[goal_index];

    TimingLimits timing;
    timing.velocity = timing.acceleration = timing.jerk = question.start;
    for (int k = 0; k < question.start.size(); ++k) {
      timing.velocity[k] =
          static_cast<double>(goal.speed) * model_->joints[at(plan.joints[at(k)])].velocity;
      timing.acceleration[k] = timing.velocity[k] / config_.full_speed_time;
      timing.jerk[k] = timing.acceleration[k] / config_.full_push_time;
    }
    TimedPath first;
    if (!off.empty()) first = lift.timed(off, timing, config_.knot_spacing);
    plan.path = timed(space, lines, corners, timing, kMostKnots - static_cast<int>(first.size()));
    plan.checks = space.checks();
    plan.clearance = kProved * space.kept();
    // A goal that is where the arm is already: a motion all the same, of one instant.
    if (plan.path.empty() && length_of(found, joints) < 1e-6F) {
      const JointPoint rest = JointPoint::Zero(question.start.size());
      plan.path = {{0.0, question.start, rest}, {0.1, corners.back(), rest}};
    }
    if (!off.empty()) {
      plan.clearance = 0.0;
      if (first.empty()) plan.path.clear();
      const double begins = first.empty() ? 0.0 : first.back().time;
      for (Knot& knot : plan.path) knot.time += begins;
      if (!plan.path.empty()) plan.path.insert(plan.path.begin(), first.begin(), first.end() - 1);
    }
    plan.status = plan.path.empty() ? ArmPathStatus::kTimeLimit : ArmPathStatus::kOk;
    if (!plan.path.empty()) within_efforts(start, plan);
    if (plan.status != ArmPathStatus::kBadGoal) plan.complaint.clear();  // of another way
    if (plan.status != ArmPathStatus::kBadGoal || (held && question.goals.size() < 2)) return plan;
    question.goals.erase(question.goals.begin() + static_cast<std::ptrdiff_t>(goal_index));  // the way there is too heavy
    if (!question.goals.empty()) continue;
    held = true;
    question.goals = all_goals;
  }
}

bool ArmPlanner::path_free(const ArmPlan& plan, const Configuration& start, double clearance) {
  EdgeCheck space(*model_, collision_, start, plan.joints, clearance);
  for (std::size_t i = 0; i + 1 < plan.path.size(); ++i) {
    if (!space.curve_free(bezier_between(plan.path[i], plan.path[i + 1]))) return false;
  }
  return !plan.path.empty();
}

}  // namespace twinbus
