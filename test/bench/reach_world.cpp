// One world of `twinbus bench reach`: a robot, hrp1s unless told, balances or holds its base among random obstacles and is asked
// for random places of its hands.
//
//     reach_world [--robot NAME_OR_DIR] [--held] [--away M] [--goals N] [--seed N] [--speed S] [--trace]
//
// With --held every second goal picks: the hand arrives empty and holds a box, rod or ball of random size from then on, also while
// the other hand moves; the next goal of the hand places it, and it is let go where it arrived.  The held thing rests on nothing.
//
// With --away goals are drawn from postures in which what carries the arm (a lift, a base on the plane) is moved too, a base by up to so
// many metres along x and y and turned by any angle.
//
// Each goal is the hand of a random arm posture, the body leaning as balance asks, that keeps the planner's
// least clearance and 3 mm, and that its joints can hold: so there is a posture that answers it.  Half are places, half whole poses.  They come one
// after the other from where the last one left the arms, by the steps of `twinbus reach`; everything in one process
// in simulated time.  The only true refusal is that there is no way, or none along which the joints can hold the arm, when a
// planner without margins and with ten times the patience finds none either.
// Contacts are looked for at every tick by the exact meshes, with the base where the simulator has it; of what is held by FCL.
// The last line is a JSON object of what happened, for campaigns.  Exit status 1 when a goal was neither reached nor truly refused, anything touched, or the robot fell.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "launcher/run/local_stack.h"
#include "planner/timing/motion_effort.h"
#include "launcher/operate/reach_progress.h"
#include "common/math/splitmix64.h"
#include "common/process/process.h"
#include "robot/kinematics/arm_span.h"
#include "robot/collision/links/link_geometry.h"
#include "robot/description/link_points.h"
#include "robot/description/load.h"
#include "sim/scene/obstacle_pieces.h"
#include "common/math/index.h"
#include "common/process/options.h"
#include "robot/collision/exact/self_collision.h"
#include "test/collision/postures.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

constexpr double kFromStart = 0.05;  // obstacles to the standing robot [m]
constexpr double kInside = 0.02;     // goal postures inside the joint limits [rad]
constexpr double kAngle = 0.035;     // a pose is reached within [rad]
constexpr double kSpare = 0.003;     // kept beyond the planner's least clearance [m]
constexpr double kLook = 0.02;       // pairs nearer than this are measured [m]
constexpr int kTries = 20000;

struct Tally {
  int reached = 0, true_refusals = 0, untrue = 0, held = 0, falls = 0, contacts = 0;
  double worst_miss = 0.0, worst_angle = 0.0, nearest = 1.0;
  std::map<std::string, int> reasons;
  std::vector<double> plan_ms;
};

Obstacle shape(ObstacleShape kind, const Eigen::Vector3d& size, const Eigen::Vector3d& at) {
  Obstacle o;
  o.shape = kind;
  o.size = size;
  o.pose.translation() = at;
  return o;
}

// Where the arms are: a standing robot's before it; an arm's all around its shoulder, as far as it reaches.
struct Surroundings {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // in the ground frame [m]
  double reach = 0.0;                                // 0: a standing robot's
};

// Boxes, posts and balls in a ring around an arm.
Obstacle draw_around(const Surroundings& about, SplitMix64& random) {
  const double angle = random.uniform(-M_PI, M_PI), out = random.uniform(0.4, 1.0) * about.reach, l = about.reach;
  const Eigen::Vector3d place = about.middle + Eigen::Vector3d(out * std::cos(angle), out * std::sin(angle), random.uniform(-0.4, 0.7) * l);
  switch (random.next() % 3) {
    case 0:
      return shape(ObstacleShape::kBox, {random.uniform(0.05, 0.4) * l, random.uniform(0.05, 0.4) * l, random.uniform(0.03, 0.3) * l}, place);
    case 1:
      return shape(ObstacleShape::kCylinder, {random.uniform(0.02, 0.06) * l, random.uniform(0.3, 1.2) * l, 0.0}, place);
    default:
      return shape(ObstacleShape::kSphere, {random.uniform(0.04, 0.12) * l, 0.0, 0.0}, place);
  }
}

// A table, posts, boards of a shelf and balls, as the dice have it.
Obstacle draw_obstacle(const Surroundings& about, SplitMix64& random) {
  if (about.reach > 0.0) return draw_around(about, random);
  const double y = random.uniform(-0.7, 0.7);
  switch (random.next() % 4) {
    case 0:
      return shape(ObstacleShape::kBox, {random.uniform(0.2, 0.5), random.uniform(0.3, 1.2), 0.04},
                   {random.uniform(0.45, 0.7), y, random.uniform(0.5, 0.85)});
    case 1:
      return shape(ObstacleShape::kCylinder, {random.uniform(0.02, 0.05), 1.3, 0.0},
                   {random.uniform(0.25, 0.55), y, 0.65});
    case 2:
      return shape(ObstacleShape::kBox, {0.3, random.uniform(0.2, 0.6), 0.03},
                   {random.uniform(0.4, 0.6), y, random.uniform(0.9, 1.4)});
    default:
      return shape(ObstacleShape::kSphere, {random.uniform(0.04, 0.1), 0.0, 0.0},
                   {random.uniform(0.1, 0.6), y, random.uniform(0.7, 1.4)});
  }
}

// Of all pairs, or of those with an obstacle alone.
double nearest_of(Collision& collision, const Kinematics& kinematics, double far,
                  int first_obstacle = 0) {
  std::array<PairDistance, 64> pairs;
  const int count = collision.near_pairs(kinematics, far, pairs.data(), 64);
  for (int i = 0; i < count; ++i) {
    if (pairs[at(i)].link_b >= first_obstacle) return pairs[at(i)].distance;
  }
  return far;
}

Eigen::Isometry3d ground_of(const Model& model, const Kinematics& kinematics) {
  Eigen::Isometry3d ground = Eigen::Isometry3d::Identity();
  Eigen::Vector3d ahead = Eigen::Vector3d::Zero();
  if (model.soles[0].link < 0) return ground;
  for (const Sole& sole : model.soles) {
    const Eigen::Isometry3d in_world = kinematics.link_in_world(sole.link) * sole.frame;
    ground.translation() += 0.5 * in_world.translation();
    ahead += in_world.linear().col(0);
  }
  ground.linear() =
      Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()).matrix();
  return ground;
}

class World {
 public:
  World(const Model& model, SplitMix64& random, std::uint64_t seed, double speed, bool holds, double away, bool trace)
      : model_(model),
        random_(random),
        speed_(speed),
        holds_(holds),
        away_(away),
        trace_(trace),
        exact_(model, build_geometry(model)),
        collision_(model),
        oracle_(model),
        kinematics_(model),
        posture_(model) {
    Scene scene;
    scene.obstacles = obstacles();
    resolve_poses(scene, model);  // with the floor below an arm
    obstacles_ = scene.obstacles;
    look_with(0, {});
    OneProcessConfig config;
    config.seed = seed;
    run_ = std::make_unique<OneProcess>(model, scene, config);
    wait(1.0);
  }

  bool fallen() const { return run_->seen().figures().fell; }

  void reach(int number, Tally& tally) {
    const std::size_t hand = random_hand();
    const bool picks = holds_ && held_[hand].shape == ObstacleShape::kNone;
    const Obstacle thing = picks ? draw_thing(hand) : Obstacle{};
    // What is to be gripped must have room where it is.
    if (picks) look_with(hand, thing);
    std::optional<ArmGoal> drawn = draw_goal(number, hand);
    if (picks) look_with(hand, {});
    const bool has_room = picks && drawn.has_value();
    if (picks && !drawn) drawn = draw_goal(number, hand);
    if (!drawn) throw std::runtime_error("no reachable goal was found in a world");
    ArmGoal goal = *drawn;
    touched_ = false;
    nearest_ = 1.0;
    plan_ms_ = &tally.plan_ms;
    const char* failure = nullptr;
    std::string refusal;
    double miss = 0.0, angle = 0.0;
    int plans = 0;
    bool moved = false;
    for (; plans <= kReachCorrections && failure == nullptr && refusal.empty(); ++plans) {
      goal.goal_id = number * 16 + plans + 1;
      const ArmPlan plan = ask(goal);
      if (plan.status != ArmPathStatus::kOk) {
        refusal = said_.empty() ? describe(plan) : said_;
        if (!moved && !(plan.no_way() && truly_refused(goal))) refusal += " (UNTRUE)";
        break;
      }
      moved = true;
      failure = follow(plan.duration());
      wait(kReachSettle);
      error_of(goal, miss, angle);
      if (miss <= kReachNearEnough) break;
    }
    const bool pose = goal.kind == ArmGoalKind::kPose;
    const bool there = miss <= kReachFar && (!pose || angle <= kAngle);
    tally.contacts += touched_ ? 1 : 0;
    tally.falls += fallen() ? 1 : 0;
    tally.nearest = std::min(tally.nearest, nearest_);
    if (has_room && failure == nullptr && moved && there && fits(hand, thing)) hold(hand, thing);
    if (holds_ && !picks) hold(hand, {});
    std::string outcome;
    if (failure == nullptr && moved && there) {
      ++tally.reached;
      outcome = "reached";
      tally.worst_miss = std::max(tally.worst_miss, miss);
      if (pose) tally.worst_angle = std::max(tally.worst_angle, angle);
    } else if (failure != nullptr) {
      ++tally.held;
      outcome = failure;
    } else if (!refusal.empty() && refusal.find("UNTRUE") == std::string::npos && !moved) {
      ++tally.true_refusals;
      outcome = refusal;
    } else {
      ++tally.untrue;
      outcome = refusal.empty() ? "came no nearer" : refusal;
    }
    if (outcome != "reached") ++tally.reasons[outcome];
    if (trace_ || outcome != "reached" || touched_ || fallen()) {
      std::printf(
          "%3d %s %s at %.3f %.3f %.3f: %s; %d plans, %.1f mm and %.3f rad off, nearest %.1f mm%s%s\n", number, goal.side == ArmSide::kLeft ? "left" : "right", pose ? "pose" : "place",
          goal.position[0], goal.position[1], goal.position[2], outcome.c_str(), plans + 1,
          1e3 * miss, pose ? angle : 0.0, 1e3 * nearest_, touched_ ? " TOUCHED" : "",
          fallen() ? " FELL" : "");
      std::fflush(stdout);
    }
  }

  double margin() const { return run_->seen().figures().zmp_margin_min; }

 private:
  std::size_t random_hand() {
    if (!model_.more_hands.empty()) return 2 + random_.next() % model_.more_hands.size();
    const std::size_t side = random_.next() % 2;
    return model_.hands[side].link >= 0 ? side : 1 - side;
  }

  // Before the hand, so that it is clear of the rest of the arm.
  Obstacle draw_thing(std::size_t hand) {
    Obstacle thing = random_.next() % 3 == 0   ? shape(ObstacleShape::kSphere, {random_.uniform(0.02, 0.06), 0.0, 0.0}, {0.0, 0.0, 0.0})
                     : random_.next() % 2 == 0 ? shape(ObstacleShape::kCylinder, {random_.uniform(0.01, 0.03), random_.uniform(0.1, 0.3), 0.0}, {0.0, 0.0, 0.0})
                                               : shape(ObstacleShape::kBox, {random_.uniform(0.03, 0.1), random_.uniform(0.03, 0.1), random_.uniform(0.05, 0.25)}, {0.0, 0.0, 0.0});
    thing.hand = static_cast<int>(hand);
    // Away from the middle of the hand's link, its end at the hand's frame.
    const Hand& by = *hand_of(model_, static_cast<int>(hand));
    const std::vector<Eigen::Vector3d> points = link_points(model_.links[at(by.link)]);
    Eigen::Vector3d out = by.frame.translation();
    for (const Eigen::Vector3d& point : points) out -= point / static_cast<double>(points.size());
    out = by.frame.linear().transpose() * (out.norm() > 1e-3 ? out.normalized() : Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d half = thing.shape == ObstacleShape::kBox      ? Eigen::Vector3d(0.5 * thing.size)
                                 : thing.shape == ObstacleShape::kSphere ? Eigen::Vector3d::Constant(thing.size.x())
                                                                         : Eigen::Vector3d(thing.size.x(), thing.size.x(), 0.5 * thing.size.y());
    thing.pose.translation() = (out.cwiseAbs().dot(half) + 0.005) * out;
    return thing;
  }

  std::vector<Obstacle> with_held() const {
    std::vector<Obstacle> all = obstacles_;
    for (const Obstacle& thing : held_) {
      if (thing.shape != ObstacleShape::kNone) all.push_back(thing);
    }
    return all;
  }

  void look_with(std::size_t hand, const Obstacle& thing) {
    held_[hand] = thing;
    collision_.set_obstacles(with_held());
    oracle_.set_obstacles(with_held());
    held_pairs_ = collision_.held_pairs();
    for (const Obstacle& held : held_) {
      if (held.shape == ObstacleShape::kNone) continue;
      const int index = model_.link_count() + static_cast<int>(obstacles_.size()) + (held.hand == 1 && held_[0].shape != ObstacleShape::kNone ? 1 : 0);
      for (int k = 0; k < static_cast<int>(obstacles_.size()); ++k) held_pairs_.push_back({index, model_.link_count() + k});
    }
  }

  // The posture that answers a goal is not the one that it was drawn from.
  bool fits(std::size_t hand, const Obstacle& thing) {
    look_with(hand, thing);
    look();
    const bool clear = nearest_of(collision_, kinematics_, kSpare) >= kSpare;
    look_with(hand, {});
    return clear;
  }

  void hold(std::size_t hand, const Obstacle& thing) {
    look_with(hand, thing);
    ObstaclesPiece piece = obstacle_pieces(thing.shape == ObstacleShape::kNone ? std::vector<Obstacle>{} : std::vector<Obstacle>{thing}, ++holds_said_)[0];
    piece.piece = static_cast<std::int16_t>(hand);
    piece.pieces = 2;
    run_->say_held(piece);
  }

  Surroundings around_arm(const Kinematics& kinematics) const {
    Surroundings about;
    if (model_.soles[0].link >= 0) return about;
    const Hand& hand = *hand_of(model_, 1);
    const ArmSpan arm = arm_span(kinematics, hand);
    return {arm.shoulder, arm.length};
  }

  std::vector<Obstacle> obstacles() {
    Configuration standing = named_posture(model_, "half_sitting");
    kinematics_.update(standing);
    standing.base = ground_of(model_, kinematics_).inverse() * standing.base;
    kinematics_.update(standing);
    std::vector<Obstacle> all;
    // Links that are nearer by design keep what the planner does.
    const double least = ArmPlannerConfig{}.least_clearance;
    clear_ = std::max(least, std::min(least + kSpare, nearest_of(collision_, kinematics_, 0.05)));
    const Surroundings about = around_arm(kinematics_);
    const std::size_t wanted = (about.reach > 0.0 ? 4 : 2) + random_.next() % 4;
    while (all.size() < wanted) {
      all.push_back(draw_obstacle(about, random_));
      collision_.set_obstacles(all);
      if (nearest_of(collision_, kinematics_, kFromStart, model_.link_count()) < kFromStart)
        all.pop_back();
    }
    return all;
  }

  // The robot as it is, by what only the simulator knows.
  void look() {
    const SimTruth& truth = run_->truth();
    const auto& p = truth.base_position;
    const auto& a = truth.base_attitude;
    posture_.base = Eigen::Translation3d(p[0], p[1], p[2]) *
                    Eigen::Quaterniond(a[0], a[1], a[2], a[3]).normalized();
    for (std::size_t k = 0; k < model_.bus_joints.size(); ++k)
      posture_.q[model_.bus_joints[k]] = run_->state().q[k];
    kinematics_.update(posture_);
  }

  bool tick() {
    if (!run_->tick()) throw std::runtime_error(run_->failure());
    look();
    const double now = nearest_of(collision_, kinematics_, kLook);
    nearest_ = std::min(nearest_, now);
    exact_.place(posture_.q);
    touched_ = touched_ || !(now > 0.0) || exact_.any_touching() ||
               std::any_of(held_pairs_.begin(), held_pairs_.end(), [&](const CollisionPair& pair) {
                 return oracle_.touches(kinematics_, pair);
               });
    return !fallen();
  }

  void wait(double seconds) {
    for (double t = 0.0; t < seconds; t += model_.period()) {
      if (!tick()) return;
    }
  }

  std::optional<ArmGoal> draw_goal(int number, std::size_t side) {
    look();
    const Eigen::Isometry3d to_ground = ground_of(model_, kinematics_).inverse();
    const Configuration now = posture_;
    ArmGoal goal;
    goal.side = static_cast<ArmSide>(side + 1);
    goal.kind = number % 2 == 0 ? ArmGoalKind::kPosition : ArmGoalKind::kPose;
    goal.speed = static_cast<float>(speed_);
    const Hand& hand = *hand_of(model_, static_cast<int>(side));
    const bool balances = model_.soles[0].link >= 0;
    Kinematics kinematics(model_);
    std::vector<int> moved = away_ > 0.0 ? hand.carriers : std::vector<int>{};
    moved.insert(moved.end(), hand.joints.begin(), hand.joints.end());
    collision_.check_only_moved_by(moved);
    MotionEffort effort(model_, now, moved);
    std::optional<ArmGoal> drawn;
    for (int i = 0; i < kTries && !drawn; ++i) {
      Configuration there = now;
      for (const int j : moved) {
        const Joint& joint = model_.joints[at(j)];
        const bool endless = joint.kind == JointKind::kContinuous;
        double low = endless ? -M_PI : joint.lower + kInside, high = endless ? M_PI : joint.upper - kInside;
        const auto plane = model_.plane_joints.begin();
        if (!model_.plane_joints.empty() && (j == plane[0] || j == plane[1])) {
          low = std::max(low, -away_);
          high = std::min(high, away_);
        }
        there.q[j] = random_.uniform(low, high);
      }
      kinematics.update(there);
      if (balances) there.base.pretranslate(kinematics_.com() - kinematics.com());  // balance keeps it
      kinematics.update(there);
      if (nearest_of(collision_, kinematics, 0.05) < clear_) continue;
      JointPoint arm(static_cast<int>(moved.size()));
      for (int k = 0; k < arm.size(); ++k) arm[k] = there.q[moved[at(k)]];
      if (!effort.holds(arm)) continue;  // an arm that falls from there is truly refused
      const Eigen::Isometry3d place = to_ground * kinematics.link_in_world(hand.link) * hand.frame;
      const Eigen::Quaterniond turn(place.linear());
      for (std::size_t k = 0; k < 3; ++k)
        goal.position[k] = place.translation()[static_cast<int>(k)];
      if (goal.kind == ArmGoalKind::kPose)
        goal.orientation = {turn.w(), turn.x(), turn.y(), turn.z()};
      drawn = goal;
    }
    collision_.check_only_moved_by({});
    return drawn;
  }

  // As much of the answer as the message tells.
  ArmPlan ask(const ArmGoal& goal) {
    const std::int64_t begin = monotonic_ns();
    run_->say(goal);
    plan_ms_->push_back(1e-6 * static_cast<double>(monotonic_ns() - begin));
    said_.clear();
    for (const std::string& sentence : run_->take_sentences()) said_ += (said_.empty() ? "" : "; ") + sentence;
    const std::vector<ArmPathPiece>& pieces = run_->arm_answer();
    ArmPlan plan;
    plan.status = pieces.front().status;
    plan.pair = {pieces.front().link_a, pieces.front().link_b};
    plan.miss = static_cast<double>(pieces.front().miss);
    path_id_ = pieces.front().path_id;
    const ArmPathPiece& last = pieces.back();
    if (last.knot_count > 0) plan.path.push_back({last.time[at(last.knot_count - 1)], {}, {}});
    return plan;
  }

  const char* follow(double duration) {
    ReachProgress progress(path_id_, duration);
    const std::int64_t begin = run_->ticks();
    double now = 0.0;
    do {
      if (!tick()) return "the robot fell";
      now = static_cast<double>(run_->ticks() - begin) * model_.period();
    } while (progress.goes_on(now, run_->state().stop_kind, &run_->loop().status()));
    if (progress.must_cancel()) {
      ArmGoal cancel;
      cancel.kind = ArmGoalKind::kCancel;
      cancel.goal_id = path_id_;
      run_->say(cancel);
    }
    return progress.failure();
  }

  void error_of(const ArmGoal& goal, double& miss, double& angle) {
    look();
    const Hand& hand = *hand_of(model_, number_of(goal.side));
    const Eigen::Isometry3d is = ground_of(model_, kinematics_).inverse() *
                                 kinematics_.link_in_world(hand.link) * hand.frame;
    miss =
        (is.translation() - Eigen::Vector3d(goal.position[0], goal.position[1], goal.position[2]))
            .norm();
    const auto& o = goal.orientation;
    angle =
        Eigen::Quaterniond(is.linear()).angularDistance(Eigen::Quaterniond(o[0], o[1], o[2], o[3]));
  }

  bool truly_refused(ArmGoal goal) {
    look();
    const Configuration now = posture_;
    ArmPlannerConfig patient;
    patient.clearance = 0.002;
    patient.padding = 0.0;
    patient.ik_restarts *= 10;
    patient.goal_postures *= 5;
    patient.rrt_rounds *= 10;
    ArmPlanner planner(model_, patient);
    planner.set_obstacles(with_held());
    planner.set_balancing(model_.soles[0].link >= 0);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      if (!planner.plan(goal, now, ground_of(model_, kinematics_), seed).no_way()) return false;
    }
    return true;
  }

  const Model& model_;
  SplitMix64& random_;
  double speed_;
  bool holds_;
  double away_;  // that the base goes for a goal [m]; 0: it and what else carries an arm stay
  bool trace_;
  SelfCollision exact_;
  Collision collision_;
  FclOracle oracle_;
  Kinematics kinematics_;
  Configuration posture_;
  std::vector<Obstacle> obstacles_;
  std::array<Obstacle, kMostHands> held_;
  std::vector<CollisionPair> held_pairs_;
  std::int64_t holds_said_ = 0;
  std::vector<double>* plan_ms_ = nullptr;
  std::unique_ptr<OneProcess> run_;
  std::int64_t path_id_ = 0;
  bool touched_ = false;
  double clear_ = 0.0;  // of the postures that goals are drawn from [m]
  double nearest_ = 1.0;
  std::string said_;  // by the planner, to the last goal
};

int run(int argc, char** argv) {
  Options options("reach_world", "Reachable goals for the hands of a robot among obstacles.");
  std::int64_t goals = 10, seed = 1;
  double speed = 0.4, away = 0.0;
  bool holds = false, trace = false;
  std::string robot = "hrp1s";
  options.text("--robot", "NAME_OR_DIR", robot, "the robot");
  options.flag("--held", holds, "every second goal of a hand picks something, the next one places it");
  options.number("--away", "M", away, 0.0, 100.0, "goals for an arm and what carries it, a base on the plane by so much");
  options.integer("--goals", "N", goals, 1, 100'000, "goals");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the world and its goals");
  options.number("--speed", "SHARE", speed, 0.05, 1.0, "of the joints' velocity limits");
  options.flag("--trace", trace, "a line for every goal");
  options.parse(argc, argv);
  const Model model = load_robot(robot);
  if (hands_of(model).empty()) throw std::runtime_error("reach_world: " + model.name + " has no hand (robot.yaml, hands)");
  if (holds && !model.more_hands.empty()) throw std::runtime_error("reach_world: --held is for a left and a right hand");
  SplitMix64 random(static_cast<std::uint64_t>(seed));
  Tally tally;
  World world(model, random, random.next() >> 16, speed, holds, away, trace);
  int asked = 0;
  while (asked < goals && !world.fallen()) world.reach(asked++, tally);
  std::sort(tally.plan_ms.begin(), tally.plan_ms.end());
  nlohmann::json found = {{"asked", asked},
                          {"plan_ms", tally.plan_ms.empty() ? 0.0 : tally.plan_ms[tally.plan_ms.size() / 2]},
                          {"plan_ms_worst", tally.plan_ms.empty() ? 0.0 : tally.plan_ms.back()},
                          {"reached", tally.reached}, {"refused_truly", tally.true_refusals}, {"missed", tally.untrue},
                          {"given_up", tally.held}, {"contacts", tally.contacts}, {"falls", tally.falls},
                          {"miss_mm", 1e3 * tally.worst_miss},
                          {"angle_rad", tally.worst_angle},
                          {"nearest_mm", 1e3 * tally.nearest},
                          {"zmp_margin_mm", std::isfinite(world.margin()) ? 1e3 * world.margin() : 0.0},
                          {"failures", nlohmann::json::array()}};
  for (const auto& [reason, times] : tally.reasons)
    found["failures"].push_back(std::to_string(times) + " times: " + reason);
  std::printf("%s\n", found.dump().c_str());
  return tally.reached + tally.true_refusals == asked && tally.contacts == 0 && tally.falls == 0 ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  return twinbus::run(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "reach_world: %s\n", error.what());
  return 1;
}
