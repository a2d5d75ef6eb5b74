#include "sim/scene/arm_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/math/angle.h"
#include "common/math/index.h"
#include "common/math/splitmix64.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/collision/collision.h"
#include "robot/collision/near_pairs.h"
#include "robot/collision/thing_name.h"
#include "robot/dynamics/gravity_load.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/kinematics/kinematics.h"
#include "sim/scene/scene_obstacle.h"

namespace twinbus::inline sim {

namespace {

constexpr double kSpare = 2.0;   // of a goal, beside the way at full speed: to plan, to speed up and brake, to come to rest [s]
constexpr double kLatest = 20.0;  // times as late
constexpr double kClear = 0.05;  // of the robot where it begins from what stands around [lengths of the arm]
constexpr double kNear = GuardDefaults::kAtGoal;  // of the robot at a goal from what stands around and from itself
constexpr double kHolds = 0.9;   // of its effort limit that a joint may need to hold the arm at a goal
constexpr int kNearPairs = 32;
constexpr int kWayParts = 8;  // at whose ends the weight is looked at
constexpr int kTries = 12;  // of a goal, from postures by the dice
constexpr double kFar = 0.1;  // a goal that is missed by more is not tried on [lengths of the arm]
constexpr double kSpinWeight = 0.05;  // of how such a hand is turned, against where it is [lengths of the arm/rad]
constexpr int kSpins = 8;  // until a hand that may turn about where it points has found how
constexpr double kAlong = 0.02;  // such a hand may point off [rad]
constexpr int kSteps = 12;       // to half a turn

// Of the places of a scene around an arm.
struct Placement {
  double turn = 0.0;    // about the upright through the shoulder [rad]
  double share = 1.0;   // of the lengths
  double up = 0.0;      // [lengths of the arm]
  double tilt = 0.0;    // of what the hands point to, outwards [rad]
  bool spins = false;   // hands turn about where they point as they can
};

Eigen::Matrix3d about_z(double angle) { return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix(); }

Eigen::Matrix3d matrix(const std::array<double, 4>& wxyz) {
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).toRotationMatrix();
}

// Each goal has time for the longest way of the slowest joint, at most once around, and kSpare: what comes too soon for that comes
// later, all alike.
void give_time(Scene& scene, const Model& model, const Hand& hand) {
  double longest = 0.0;  // [s] at full speed
  for (const int j : hand.joints) {
    const Joint& joint = model.joints[at(j)];
    const double way = joint.kind == JointKind::kPrismatic ? joint.upper - joint.lower : 2.0 * M_PI;
    longest = std::max(longest, way / joint.velocity);
  }
  double later = 1.0;
  for (std::size_t i = 0; i < scene.goals.size(); ++i) {
    const double until = i + 1 < scene.goals.size() ? scene.goals[i + 1].at : scene.duration;
    const double needed = kSpare + longest / static_cast<double>(scene.goals[i].request.speed);
    if (until > scene.goals[i].at) later = std::max(later, needed / (until - scene.goals[i].at));
  }
  if (!(later > 1.0) || !(later < kLatest)) return;
  scene.duration *= later;
  for (TimedGoal& timed : scene.goals) timed.at *= later;
  for (TimedMode& timed : scene.modes) timed.at *= later;
  for (Grasp& grasp : scene.grasps) {
    grasp.at *= later;
    grasp.until *= later;
  }
}

class ArmPlaces {
 public:
  ArmPlaces(const Scene& scene, const Model& model, const Hand& hand)
      : scene_(scene),
        model_(model),
        hand_(hand),
        arm_(arm_in_scene(scene, model, hand)),
        collision_(model),
        shares_(model),
        k_(model),
        start_(model, scene.start_pose),
        last_(start_),
        load_(model),
        ik_(model, model.joints[at(hand.joints.front())].parent, hand.link, hand.frame) {
    k_.update(start_);
    ground_ = arm_span(k_, hand).shoulder - arm_.shoulder;
    base_ = k_.link_in_world(model.joints[at(hand.joints.front())].parent);
    axes_ = pointing(k_, hand);
    Scene empty;
    empty.start_pose = scene.start_pose;
    add_floor(empty, model);
    floor_ = empty.obstacles;
  }

  // The first that does it; false, with the one that does most, when none does.
  bool find(Placement& found) {
    Placement best;
    int most = -2;
    for (const double tilt : {0.0, 0.5, 1.0, -0.5, 1.5}) {
      if (tilt != 0.0 && !points()) break;
      for (const double share : {1.0, 0.85, 0.7}) {
        for (const double up : {0.0, -0.15, 0.15, 0.3}) {
          for (const bool spins : {false, true}) {
            if (spins ? !points() : tilt != 0.0) continue;
            for (int step = 0; step <= kSteps; ++step) {
              for (const double sign : {1.0, -1.0}) {
                if (step == 0 && sign < 0.0) continue;
                const Placement tried{sign * step * M_PI / kSteps, share, up, tilt, spins};
                const int reached = goals_done(tried), done = 2 * reached + (blocked_ ? 1 : 0);
                if (done > most) {
                  most = done;
                  best = tried;
                }
                if (reached == asked()) {
                  found = tried;
                  return true;
                }
              }
            }
          }
        }
      }
    }
    goals_done(found = best);
    return false;
  }

  // Of a goal of the last placement that was looked at [w, x, y, z].
  const std::array<double, 4>& orientation(std::size_t goal) const { return orientation_[goal]; }
  Eigen::Vector3d reach(const Placement& p, const Eigen::Vector3d& in_lengths) const {
    return p.share * (about_z(p.turn) * in_lengths) + p.up * Eigen::Vector3d::UnitZ();
  }
  // In the ground frame.
  Eigen::Isometry3d put(const Placement& p, Eigen::Isometry3d pose) const {
    pose.translation() = arm_.shoulder + arm_.length * reach(p, pose.translation());
    pose.linear() = about_z(p.turn) * pose.linear();
    return pose;
  }
  double length() const { return arm_.length; }
  // Where the last placement that was looked at fails, to be read after "the hand".
  const std::string& why() const { return why_; }

 private:
  bool points() const {
    return std::any_of(scene_.goals.begin(), scene_.goals.end(),
                       [](const TimedGoal& timed) { return timed.of_reach && timed.request.kind == ArmGoalKind::kPose; });
  }
  int asked() const {
    if (model_.floating_base) return 0;  // a body leans, and so it reaches farther than its arm
    return static_cast<int>(
        std::count_if(scene_.goals.begin(), scene_.goals.end(), [](const TimedGoal& timed) { return timed.of_reach; }));
  }

  void surround(const std::vector<Obstacle>& things) {
    std::vector<Obstacle> around;
    for (Obstacle thing : things) {
      if (thing.hand < 0) thing.pose = Eigen::Translation3d(ground_) * thing.pose;
      around.push_back(thing);
    }
    collision_.set_obstacles(around);
    around_ = around;
  }

  std::vector<Obstacle> things(const Placement& p) const {
    std::vector<Obstacle> placed = scene_.obstacles;
    for (Obstacle& thing : placed) {
      thing.pose = put(p, thing.pose);
      thing.size *= p.share * arm_.length;
    }
    return placed;
  }

  bool begins_clear(const Placement& p) {
    std::vector<Obstacle> around = things(p);
    for (const LooseBody& body : scene_.loose) {
      Obstacle& thing = around.emplace_back();
      thing.shape = ObstacleShape::kSphere;
      thing.size.setConstant(0.5 * p.share * arm_.length * body.solid.size.norm());
      thing.pose = put(p, body.start.pose);
    }
    if (around.empty()) return true;
    surround(around);
    k_.update(start_);
    PairDistance near;
    for (int link = 0; link < model_.link_count(); ++link) {
      for (int thing = 0; thing < std::min(static_cast<int>(around.size()), Collision::kMaxObstacles); ++thing) {
        if (collision_.pair_nearer_than(k_, link, model_.link_count() + thing, kClear * arm_.length, near)) return false;
      }
    }
    return true;
  }

  // What the hand holds at that goal, as it took it at the one before.
  std::vector<Obstacle> held_at(const Placement& p, std::size_t goal) {
    std::vector<Obstacle> held;
    const double time = scene_.goals[goal].at;
    for (const Grasp& grasp : scene_.grasps) {
      const bool own = grasp.link == "right_hand" || grasp.link == "left_hand" || grasp.link == model_.links[at(hand_.link)].name;
      if (!own || !(grasp.at < time && time < grasp.until) || first_) continue;
      for (const LooseBody& body : scene_.loose) {
        if (body.name != grasp.to) continue;
        k_.update(last_);
        Obstacle& thing = held.emplace_back();
        const Eigen::Vector3d size = p.share * arm_.length * body.solid.size;
        thing.shape = body.solid.shape == SolidShape::kBox      ? ObstacleShape::kBox
                      : body.solid.shape == SolidShape::kSphere ? ObstacleShape::kSphere
                                                                : ObstacleShape::kCylinder;
        thing.size = size;
        if (body.solid.shape == SolidShape::kCapsule) thing.size.y() += 2.0 * size.x();
        const Eigen::Isometry3d hand = k_.link_in_world(hand_.link) * hand_.frame;
        thing.pose = hand.inverse() * Eigen::Translation3d(ground_) * put(p, body.start.pose);
        thing.hand = number_of(model_, hand_);
      }
    }
    return held;
  }

  // -1: it begins in what stands around; else the goals that it reaches one after the other.
  int goals_done(const Placement& p) {
    blocked_ = false;
    orientation_.clear();
    for (const TimedGoal& timed : scene_.goals)
      orientation_.push_back(as_frame(about_z(p.turn) * matrix(timed.request.orientation)));
    if (!begins_clear(p)) {
      why_ = "begins in what the scene puts around it";
      return -1;
    }
    std::vector<Obstacle> around = things(p);
    around.insert(around.end(), floor_.begin(), floor_.end());
    first_ = true;
    last_ = start_;
    pointed_ = false;
    int done = 0;
    for (std::size_t i = 0; i < scene_.goals.size(); ++i) {
      if (model_.floating_base || (!scene_.goals[i].of_reach && scene_.goals[i].pose.empty())) continue;
      if (!scene_.goals[i].of_reach && first_) {
        last_ = Configuration(model_, scene_.goals[i].pose);
        continue;
      }
      if (!scene_.goals[i].of_reach) {  // back to a posture: the way there is what may be too heavy
        const Configuration back(model_, scene_.goals[i].pose);
        const std::string heavy = too_heavy_on_way(back);
        last_ = back;
        if (heavy.empty()) continue;
        blocked_ = true;
        why_ = heavy + " at goal " + std::to_string(i + 1);
        return std::min(done, asked() - 1);
      }
      std::vector<Obstacle> there = around;
      for (const Obstacle& thing : held_at(p, i)) there.push_back(thing);
      surround(there);
      const bool possible = can(p, i);
      if (!possible) return done;
      ++done;
    }
    return done;
  }

  // Of the hand's frame, from how the hand looks.
  std::array<double, 4> as_frame(const Eigen::Matrix3d& look) const {
    const Eigen::Quaterniond q(look * axes_.transpose());
    return {q.w(), q.x(), q.y(), q.z()};
  }

  // How the hand is to look, before it is turned about where it points.
  Eigen::Matrix3d turned(const Placement& p, const TimedGoal& timed) {
    const Eigen::Matrix3d as_asked = about_z(p.turn) * matrix(timed.request.orientation);
    if (p.tilt == 0.0) return as_asked;
    const Eigen::Vector3d out = reach(p, timed.reach);
    const double azimuth = std::atan2(out.y(), out.x());
    if (pointed_) return about_z(azimuth - azimuth_) * tilted_;
    azimuth_ = azimuth;
    const Eigen::Vector3d aside = about_z(azimuth) * Eigen::Vector3d::UnitY();
    return tilted_ = Eigen::AngleAxisd(-p.tilt, aside).toRotationMatrix() * as_asked;
  }

  bool can(const Placement& p, std::size_t goal) {
    const TimedGoal& timed = scene_.goals[goal];
    const bool pose = timed.request.kind == ArmGoalKind::kPose;
    Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
    target.translation() = ground_ + arm_.shoulder + arm_.length * reach(p, timed.reach);
    if (pose) target.linear() = turned(p, timed);
    IkOptions options;
    options.position_tolerance = 2e-4;
    options.rotation_tolerance = 2e-3;
    options.limit_margin = 0.01;
    options.restarts = 3;
    if (!pose) options.rotation_weight = 0.0;
    SplitMix64 dice(1);
    double miss = 1e9;
    std::string other;
    Configuration c = start_;
    for (int i = 0; i < kTries && !(i > 2 && miss > kFar * arm_.length); ++i) {
      for (const int j : hand_.joints) {
        const Joint& joint = model_.joints[at(j)];
        const bool bounded = joint.upper - joint.lower < 4.0 * M_PI;
        if (i > 0) c.q[j] = bounded ? dice.uniform(joint.lower, joint.upper) : dice.uniform(-M_PI, M_PI);
      }
      Eigen::Matrix3d look = target.linear();
      const IkResult result = solve(target, pose && p.spins && (!pointed_ || p.tilt == 0.0), options, c.q, look);
      miss = std::min(miss, result.position_error + (pose ? 0.1 * result.rotation_error : 0.0));
      if (!result.reached) continue;
      other = why_not(c);
      if (other.empty()) other = too_heavy_on_way(c);
      if (!other.empty()) continue;
      if (pose) {
        orientation_[goal] = as_frame(look);
        if (!pointed_) tilted_ = look;
        pointed_ = true;
      }
      first_ = false;
      last_ = c;
      return true;
    }
    blocked_ = !other.empty();
    why_ = blocked_ ? formatted("%s at goal %zu", other.c_str(), goal + 1)
                    : formatted("misses goal %zu by %.0f mm%s", goal + 1, 1e3 * miss, pose ? " as it is to be turned" : "");
    return false;
  }

  // look: how the hand looks in the world, as asked, and then as it does.
  IkResult solve(const Eigen::Isometry3d& target, bool spins, IkOptions options, Eigen::VectorXd& q, Eigen::Matrix3d& look) {
    IkResult result;
    if (spins) options.rotation_weight = kSpinWeight * arm_.length;
    for (int i = 0; i < (spins ? kSpins : 1); ++i) {
      Eigen::Isometry3d there = target;
      there.linear() = look * axes_.transpose();
      result = ik_.solve(base_.inverse() * there, options, q);
      if (!spins || result.reached) return result;
      const Eigen::Matrix3d now = (base_ * ik_.pose(q)).linear() * axes_;
      const Eigen::Matrix3d off = target.linear().transpose() * now;
      look = target.linear() * about_z(std::atan2(off(1, 0) - off(0, 1), off(0, 0) + off(1, 1)));
      // It points there, turned as its joints allow.
      if (result.position_error < options.position_tolerance && std::acos(std::clamp(off(2, 2), -1.0, 1.0)) < kAlong) {
        look = now;
        result.reached = true;
        return result;
      }
    }
    return result;
  }

  std::string why_not(const Configuration& c) {
    k_.update(c);
    std::array<PairDistance, kNearPairs> near;
    const int count = collision_.near_pairs(k_, kNear, near.data(), kNearPairs);
    for (int i = 0; i < count; ++i) {
      const PairDistance& pair = near[at(i)];
      if (pair.distance <= kNear * shares_.of(pair.link_a, pair.link_b)) return near_words(pair);
    }
    return too_heavy(c);
  }

  std::string near_words(const PairDistance& pair) const {
    const std::string a = thing_name(model_, around_, pair.link_a).data(), b = thing_name(model_, around_, pair.link_b).data();
    return "brings " + a + " and " + b + formatted(" within %.0f mm", 1e3 * kNear);
  }

  std::string too_heavy(const Configuration& c) {
    const GravityLoad::Worst worst = load_.of(c, hand_.joints);
    if (!(worst.share > kHolds)) return "";
    return "is too heavy for " + model_.joints[at(worst.joint)].name +
           formatted(" (%.3g of its %.3g)", worst.effort, worst.effort / worst.share);
  }

  // From the last goal.
  std::string too_heavy_on_way(const Configuration& to) {
    Configuration there = to;
    for (int part = 1; part < kWayParts; ++part) {
      there.q = last_.q + static_cast<double>(part) / kWayParts * (to.q - last_.q);
      if (const std::string heavy = too_heavy(there); !heavy.empty()) return heavy + " on the way to, or";
    }
    return "";
  }

  const Scene& scene_;
  const Model& model_;
  const Hand& hand_;
  ArmSpan arm_;
  Collision collision_;
  MarginShares shares_;
  Kinematics k_;
  Configuration start_, last_;  // last_: at the last goal that was reached
  GravityLoad load_;
  InverseKinematics ik_;
  Eigen::Vector3d ground_;  // in the world
  Eigen::Isometry3d base_;  // that the arm hangs on, in the world
  Eigen::Matrix3d axes_;
  std::vector<Obstacle> floor_;
  std::vector<std::array<double, 4>> orientation_;
  std::string why_;
  std::vector<Obstacle> around_;  // as collision_ has them
  bool blocked_ = false;      // the goal that was not done is reached, but not clear or not held
  bool first_ = true;         // no goal was reached yet
  bool pointed_ = false;      // one with a turn of the hand was
  double azimuth_ = 0.0;     // of the first [rad]
  Eigen::Matrix3d tilted_ = Eigen::Matrix3d::Identity();  // its hand
};

std::string words(const Placement& p) {
  std::string text;
  const auto say = [&](const std::string& what) { text += (text.empty() ? "for this arm " : ", ") + what; };
  const auto add = [&](const char* format, double value) { say(formatted(format, value)); };
  if (p.turn != 0.0) add("the places are turned by %.0f degrees", p.turn * kDegrees);
  if (p.share != 1.0) add("lengths are x%.2f", p.share);
  if (p.up != 0.0) add(p.up > 0.0 ? "all is %.2f arm lengths higher" : "all is %.2f arm lengths lower", std::abs(p.up));
  if (p.tilt != 0.0) add("the hand points %.0f degrees outwards from where it was to point", p.tilt * kDegrees);
  if (p.spins) say("the hand is turned about where it points as its joints can");
  return text;
}

}  // namespace

ArmSpan arm_in_scene(const Scene& scene, const Model& model, const Hand& hand) {
  Kinematics k(model);
  k.update(Configuration(model, scene.start_pose));
  Eigen::Vector3d ground = Eigen::Vector3d::Zero();
  int soles = 0;
  for (const Sole& sole : model.soles) {
    if (sole.link < 0) continue;
    ground += k.link_in_world(sole.link) * sole.frame.translation();
    ++soles;
  }
  if (soles > 0) ground /= soles;
  ArmSpan arm = arm_span(k, hand);
  arm.shoulder -= ground;
  return arm;
}

std::string begins_too_heavy(const Scene& scene, const Model& model) {
  if (model.floating_base) return "";
  GravityLoad load(model);
  const Configuration start(model, scene.start_pose);
  for (const Hand* hand : hands_of(model)) {
    const GravityLoad::Worst worst = load.of(start, hand->joints);
    if (worst.joint < 0 || !(worst.share > 1.0)) continue;
    const Joint& joint = model.joints[at(worst.joint)];
    const std::string text = formatted(" needs %.4g of its effort limit of %.4g to hold the arm where it begins",
                                       worst.effort, joint.effort);
    return "joint " + joint.name + text + ": begin in another pose (--start-pose, start_pose:), or correct the limit in the URDF";
  }
  return "";
}

void measure_by_arm(Scene& scene, const Model& model) {
  if (!scene.in_arm_lengths) return;
  const Hand* right = hand_of(model, 1);
  if (right == nullptr || right->joints.empty())
    throw std::runtime_error("scene " + scene.name + ": its lengths are those of an arm, and the robot " + model.name + " has none");
  const Hand& hand = *right;
  ArmPlaces places(scene, model, hand);
  Placement p;
  if (!places.find(p) && !model.floating_base)
    throw std::runtime_error("scene " + scene.name + " does not apply to the robot " + model.name +
                             ": wherever its places are put around the arm, it " + places.why() +
                             "; ./twinbus run --help says how to name another scene");
  if (const std::string text = words(p); !text.empty()) scene.scaled += (scene.scaled.empty() ? "" : "; ") + text;
  const double length = p.share * places.length();
  for (Obstacle& obstacle : scene.obstacles) {
    obstacle.pose = places.put(p, obstacle.pose);
    obstacle.size *= length;
  }
  const auto place = [&](Eigen::Vector3d& position) {
    position = places.put(p, Eigen::Isometry3d(Eigen::Translation3d(position))).translation();
  };
  for (LooseBody& body : scene.loose) {
    body.start.pose = places.put(p, body.start.pose);
    body.solid.size *= length;
  }
  for (LooseEnd& end : scene.criteria.loose) place(end.position);
  for (std::size_t i = 0; i < scene.goals.size(); ++i) {
    TimedGoal& timed = scene.goals[i];
    if (!timed.of_reach) continue;
    timed.reach = places.reach(p, timed.reach);
    if (timed.request.kind == ArmGoalKind::kPose) timed.request.orientation = places.orientation(i);
  }
  give_time(scene, model, hand);
  scene.in_arm_lengths = false;
}

}  // namespace twinbus::sim
