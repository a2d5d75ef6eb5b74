#include "planner/arm_planner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "planner/arm_question.h"
#include "planner/held_lines.h"
#include "planner/lift.h"
#include "planner/search/arm_lines.h"
#include "planner/search/edge_check.h"
#include "planner/timing/motion_effort.h"
#include "common/math/splitmix64.h"
#include "planner/search/shorten.h"
#include "common/math/index.h"
#include "robot/collision/loop_joints.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

namespace {

constexpr double kTouching = 0.001;  // a start nearer than this counts as touching [m]
constexpr double kShare = 0.9;       // of the room at start and goal that the way must keep
constexpr double kLeaving = 0.98;    // of the room of what a guard would hold on its way nearer
constexpr double kProved = 0.7;  // share of the clearance of the search that the motion is proved to keep
constexpr double kGuarded = GuardDefaults::kInController + 5e-4;  // which is no less than this where a slower motion keeps it [m]
constexpr double kUnit = 0.01;         // what the length of a quaternion may be off by
constexpr double kWidestCorner = 0.4;  // [rad]
constexpr double kMostSlower = 3.0;  // than the joints' speeds ask: then a way with more of their efforts left is looked for
constexpr double kReserve = 0.9;     // of their efforts that may hold the arm on it
constexpr int kLessForLight = 4;     // of the rounds of a search, where a way is at hand already
constexpr int kMostKnots = 360;        // what 60 pieces of an arm path hold
constexpr int kLongPatience = 5;         // times as many rounds when no way was found
constexpr std::size_t kMostHeld = 8;     // things of which balls are kept

bool is_arm_joint(const Model& model, int joint) {
  for (const Hand* hand : hands_of(model)) {
    for (const auto* listed : {&hand->joints, &hand->carriers}) {
      if (std::find(listed->begin(), listed->end(), joint) != listed->end()) return true;
    }
  }
  return false;
}

// One after the other, what moves with an arm: nothing; what is no base on the plane, such as a lift; such a base, which is faster than
// most lifts; all that carries it.
std::vector<std::vector<int>> stages_of(const Model& model, const ArmGoal& goal) {
  std::vector<std::vector<int>> stages{{}};
  const Hand* hand = goal.kind == ArmGoalKind::kJoints ? nullptr : hand_of(model, number_of(goal.side));
  if (hand == nullptr) return stages;
  std::vector<int> above, plane;
  for (const int j : hand->carriers) {
    const bool of_plane = std::find(model.plane_joints.begin(), model.plane_joints.end(), j) != model.plane_joints.end();
    (of_plane ? plane : above).push_back(j);
  }
  for (const std::vector<int>& carriers : {above, plane, hand->carriers}) {
    const bool is_new = std::find(stages.begin(), stages.end(), carriers) == stages.end();
    if (is_new && carriers.size() + hand->joints.size() <= at(kArmJoints)) stages.push_back(carriers);
  }
  return stages;
}

// Of a goal that another place of the arm's foot may answer.
bool asks_for_more(const ArmPlan& plan) {
  return plan.status == ArmPathStatus::kUnreachable || plan.status == ArmPathStatus::kGoalInCollision || plan.no_way() ||
         plan.heavy != ArmPlan::Heavy::kNo;
}

bool is_same(const Obstacle& a, const Obstacle& b) {
  return a.shape == b.shape && a.hand == b.hand && a.size == b.size && a.pose.matrix() == b.pose.matrix();
}

// None at all, or none along which the joints can hold the arm.

void forget_weight(ArmPlan& plan) {
  plan.complaint.clear();
  plan.heavy = ArmPlan::Heavy::kNo;
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

}  // namespace

ArmPlanner::ArmPlanner(const Model& model, const ArmPlannerConfig& config)
    : model_(&model),
      config_(config),
      shares_(model),
      collision_(model, false),
      balls_(balls_along_links(model)),
      link_balls_(balls_.size()),
      looped_(joints_in_loops(model)) {}

// Fills the question; false, with the reason in plan, if it makes no sense for this robot.
bool ArmPlanner::understand(const std::vector<int>& carriers, const ArmGoal& goal, const Configuration& start,
                            const Eigen::Isometry3d& ground, Question& question, ArmPlan& plan) const {
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
    if (goal.side == ArmSide::kNone) return refuse("side must be left or right, or say which of the other arms");
    question.hand = hand_of(*model_, number_of(goal.side));
    if (question.hand == nullptr || question.hand->joints.empty()) return refuse("the robot has no such hand");
    if (question.hand->joints.size() > at(kArmJoints)) return refuse("the arm has more than 12 joints");
    plan.joints = carriers;
    plan.joints.insert(plan.joints.end(), question.hand->joints.begin(), question.hand->joints.end());
    question.carriers = static_cast<int>(carriers.size());
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
  for (const Hand* hand : hands_of(*model_)) {  // that joint goals move
    if (question.hand == nullptr && hand->joints == plan.joints) question.hand = hand;
  }
  question.start = pick(start.q, plan.joints);
  question.range = JointTurns(*model_, plan.joints, question.start);
  if (question.carriers > 0) {
    stay_near(*model_, start, plan.joints, *question.hand, question.target.translation(), question.range);
  }
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

// As slow as the joints' efforts ask, which is given back; no path, and 0, if one cannot hold the arm on the way.
double ArmPlanner::within_efforts(const Configuration& start, ArmPlan& plan) const {
  MotionEffort effort(*model_, start, plan.joints);
  const double slower = effort.slower(plan.path);
  if (slower > 1.0) slow_down(plan.path, slower);
  if (slower > 0.0) return slower;
  plan.path.clear();
  plan.status = ArmPathStatus::kBadGoal;
  plan.complaint = too_heavy(*model_, effort, "on the way");
  plan.heavy = ArmPlan::Heavy::kOnTheWay;
  return 0.0;
}

void ArmPlanner::set_obstacles(const std::vector<Obstacle>& obstacles) {
  obstacles_ = obstacles;
  balls_.resize(link_balls_);
  for (const Obstacle& obstacle : obstacles) {
    if (!takes_part(obstacle, *model_)) continue;
    if (obstacle.hand >= 0) balls_.push_back(balls_of(obstacle));
    else balls_.emplace_back().held = true;
  }
  collision_.set_obstacles(obstacles_);
}

// They take a millisecond to find, and are asked for with each question while a hand holds it.
const BallGroup& ArmPlanner::balls_of(const Obstacle& held) {
  const auto known = std::find_if(held_balls_.begin(), held_balls_.end(),
                                  [&](const auto& one) { return is_same(one.first, held); });
  if (known != held_balls_.end()) return known->second;
  if (held_balls_.size() == kMostHeld) held_balls_.erase(held_balls_.begin());
  return held_balls_.emplace_back(held, balls_along_held(*model_, {held}).front()).second;
}

ArmPlan ArmPlanner::plan(const ArmGoal& goal, const Configuration& start,
                         const Eigen::Isometry3d& ground_in_world, std::uint64_t seed,
                         bool (*keep_on)(void*), void* user) {
  const std::vector<std::vector<int>> stages = stages_of(*model_, goal);
  ArmPlan plan;
  std::int64_t checks = 0;
  for (const std::vector<int>& carriers : stages) {
    plan = plan_with(carriers, &carriers == &stages.back(), goal, start, ground_in_world, seed, keep_on, user);
    plan.checks = checks += plan.checks;
    if (!asks_for_more(plan)) break;
  }
  return plan;
}

ArmPlan ArmPlanner::plan_with(const std::vector<int>& carriers, bool patience, const ArmGoal& goal, const Configuration& start,
                              const Eigen::Isometry3d& ground_in_world, std::uint64_t seed, bool (*keep_on)(void*), void* user) {
  ArmPlan plan;
  std::int64_t checks = 0;
  for (const double padding : {config_.padding, 0.5 * config_.padding, 0.0}) {
    if (obstacles_.empty() && padding > 0.0) continue;
    padded_ = obstacles_;
    for (Obstacle& obstacle : padded_) pad(obstacle, padding);
    collision_.set_obstacles(padded_);
    Effort usual{.carriers = carriers, .clearance = config_.clearance, .rounds = config_.rrt_rounds};
    plan = attempt(goal, start, ground_in_world, seed, usual, keep_on, user);
    plan.padding = padding;
    plan.checks = checks += plan.checks;
    const bool in_the_way = plan.status == ArmPathStatus::kStartInCollision || plan.status == ArmPathStatus::kGoalInCollision ||
                            plan.no_way();
    if (!in_the_way) break;
  }
  // Then with patience, and as near as a goal may be: first by proofs, which are quick, then by distances, which are exact.
  Effort patient{.carriers = carriers,
                 .clearance = std::min(config_.clearance, config_.least_clearance),
                 .rounds = kLongPatience * config_.rrt_rounds};
  const ArmPlan heavy = plan.heavy == ArmPlan::Heavy::kOnTheWay ? plan : ArmPlan{};
  for (bool again = patience; again && plan.no_way(); patient.exact = true) {
    plan = attempt(goal, start, ground_in_world, seed, patient, keep_on, user);
    plan.checks = checks += plan.checks;
    again = !patient.exact;
  }
  if (plan.status == ArmPathStatus::kTimeLimit && heavy.heavy != ArmPlan::Heavy::kNo) {  // the joint says more than "no way"
    plan = heavy;
    plan.checks = checks;
  }
  collision_.set_obstacles(obstacles_);
  if (plan.status == ArmPathStatus::kStartInCollision || plan.status == ArmPathStatus::kGoalInCollision)
    plan.touching = {thing_name(*model_, obstacles_, plan.pair.link_a), thing_name(*model_, obstacles_, plan.pair.link_b)};
  return plan;
}

ArmPlan ArmPlanner::attempt(const ArmGoal& goal, const Configuration& start,
                            const Eigen::Isometry3d& ground_in_world, std::uint64_t seed, Effort& spent,
                            bool (*keep_on)(void*), void* user) {
  ArmPlan plan;
  Question question;
  if (!understand(spent.carriers, goal, start, ground_in_world, question, plan)) return plan;
  SplitMix64 random(seed);
  EdgeCheck space(*model_, collision_, start, plan.joints, spent.clearance);

  double room_at_start = space.nearest(question.start, spent.clearance);
  Lift lift(*model_, collision_, space);
  JointPath off;  // what the hand holds is taken off what it stands on
  if (question.hand != nullptr && !(room_at_start > kTouching) && lift.find(*question.hand, question.start, off)) {
    room_at_start = space.nearest(off.back(), spent.clearance);
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
  double share = MotionEffort::kAll;
  ArmPlan slow;  // found, past a posture that a joint hardly holds
  const auto better = [&] {
    if (slow.path.empty() || plan.status == ArmPathStatus::kCancelled) return plan;
    return plan.status == ArmPathStatus::kOk && plan.duration() < slow.duration() ? plan : slow;
  };
  for (;;) {
    std::vector<EndPair> ends;  // so near that a share of their room may be less than what a guard keeps
    double room = std::min(spent.clearance, space.nearest_beside(question.start, spent.clearance, kGuarded / kShare, ends));
    for (const JointPoint& q : question.goals)
      room = std::min(room, space.nearest_beside(q, spent.clearance, kGuarded / kShare, ends));
    for (EndPair& end : ends)
      end.margin = std::max(kShare * end.room, std::min(kGuarded * shares_.of(end.link_a, end.link_b), kLeaving * end.room));
    space.set_clearance(kShare * room);
    space.keep_at_ends(ends);

    ArmLines lines(*model_, space, collision_, balls_, padded_);
    SearchLimits limits = question.range.limits();
    limits.most_rounds = slow.path.empty() ? spent.rounds : spent.rounds / kLessForLight;
    limits.seed = seed;
    JointSearch search(limits);
    SearchPath goals;
    for (const JointPoint& q : question.goals) goals.push_back(to_search(q));
    const int joints = static_cast<int>(question.start.size());
    HeldLines light(lines, effort, joints, share);
    LineTest& test = held ? static_cast<LineTest&>(light) : lines;
    const SearchPoint begin = to_search(question.start);
    CertainPath way;
    if (!held && !spent.exact) way = lines.find_proved(search, begin, goals, keep_on, user);
    SearchPath found = std::move(way.path);
    plan.rounds = way.rounds;
    if (!way.ends_certain) {  // or not asked
      spent.exact = true;
      found = search.find(test, begin, goals, keep_on, user);
      plan.rounds = search.rounds();
      shorten(test, found, joints);
    }
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
        forget_weight(plan);
      }
      return better();
    }
    // The ends are what was asked for, to the last bit.
    const std::size_t goal_index = at(static_cast<int>(std::find(goals.begin(), goals.end(), found.back()) - goals.begin()));
    JointPath corners;
    for (const SearchPoint& q : found) corners.push_back(from_search(q, joints));
    corners.front() = question.start;
    corners.back() = question.goals[goal_index];

    TimingLimits timing;
    timing.velocity = timing.acceleration = timing.jerk = question.start;
    for (int k = 0; k < question.start.size(); ++k) {
      const Joint& joint = model_->joints[at(plan.joints[at(k)])];
      timing.velocity[k] = static_cast<double>(goal.speed) * joint.velocity;
      timing.acceleration[k] = timing.velocity[k] / config_.full_speed_time;
      timing.jerk[k] = timing.acceleration[k] / config_.full_push_time;
      const double lasting = MotionEffort::lasting_speed(joint);
      if (lasting > 0.0) timing.velocity[k] = std::min(timing.velocity[k], lasting);  // 0: that way is refused below
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
    const double slower = plan.path.empty() ? 1.0 : within_efforts(start, plan);
    if (plan.status != ArmPathStatus::kBadGoal) forget_weight(plan);  // of another way
    const auto is_light = [&](const JointPoint& q) { return effort.holds(q, kReserve); };
    if (slower > kMostSlower && slow.path.empty() && is_light(question.start) &&
        std::any_of(all_goals.begin(), all_goals.end(), is_light)) {
      slow = plan;
      held = true;
      share = kReserve;
      question.goals.clear();
      std::copy_if(all_goals.begin(), all_goals.end(), std::back_inserter(question.goals), is_light);
      continue;
    }
    if (plan.status != ArmPathStatus::kBadGoal || (held && question.goals.size() < 2)) return better();
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

}  // namespace twinbus::planner
