#include "sim/scene/scene_places.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "common/math/index.h"
#include "robot/collision/collision.h"
#include "robot/kinematics/arm_span.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

namespace {

constexpr double kSpare = 1.0;     // of a goal, beside the way there [s]
constexpr double kLatest = 20.0;   // times as late
constexpr double kPitch = 0.7;  // cosine: an axis so nearly to the left bends a leg forward or back

std::vector<int> way_up(const Model& model, int link) {  // from the link to the base
  std::vector<int> way;
  for (; link >= 0; link = model.links[at(link)].parent) way.push_back(link);
  return way;
}

int chest(const Model& model) {
  if (model.hands[0].link < 0 || model.hands[1].link < 0) return 0;
  const std::vector<int> left = way_up(model, model.hands[0].link);
  for (const int link : way_up(model, model.hands[1].link)) {
    if (std::find(left.begin(), left.end(), link) != left.end()) return link;
  }
  return 0;
}

// Called so, of the last if several are.
int head(const Model& model) {
  int found = -1;
  for (const Frame& frame : model.frames) {
    std::string lower = frame.name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (lower.find("head") != std::string::npos && frame.link > 0) found = std::max(found, frame.link);
  }
  return found;
}

// Joints of a leg that bend it forward or back, from the foot up.
std::vector<int> pitch_joints(const Model& model, int foot) {
  if (foot < 0) return {};
  Configuration c(model);
  Kinematics k(model);
  k.update(c);
  std::vector<int> joints;
  for (int link = foot; link > 0; link = model.links[at(link)].parent) {
    if (std::abs(k.axis_in_world(link - 1).y()) > kPitch) joints.push_back(link - 1);
  }
  return joints;
}

// While the robot is as the scene starts it, in the ground frame.
ArmSpan arm_of(const Scene& scene, const Model& model, const Hand& hand) {
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

// Each goal has time for once around the slowest joint and kSpare: what comes too soon for that comes later, all alike.
void give_time(Scene& scene, const Model& model, const Hand& hand) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const int joint : hand.joints) slowest = std::min(slowest, model.joints[at(joint)].velocity);
  double later = 1.0;
  for (std::size_t i = 0; i < scene.goals.size(); ++i) {
    const double until = i + 1 < scene.goals.size() ? scene.goals[i + 1].at : scene.duration;
    const double needed = kSpare + 2.0 * M_PI / (static_cast<double>(scene.goals[i].goal.speed) * slowest);
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

// A turn about the upright through `middle`.
Eigen::Isometry3d turned_about(const Eigen::Vector3d& middle, double angle) {
  return Eigen::Translation3d(middle) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(-middle);
}

// How far what stands around an arm is turned about its shoulder, that the robot begins clear of it: as little as can be [rad].
double turn_to_clear(const Scene& scene, const Model& model, const Hand& hand, const ArmSpan& arm) {
  constexpr double kClear = 0.05;  // lengths of the arm
  constexpr int kSteps = 12;       // to half a turn
  std::vector<Obstacle> things = scene.obstacles;
  for (const LooseBody& body : scene.loose) {
    Obstacle& thing = things.emplace_back();
    thing.shape = ObstacleShape::kSphere;
    thing.size.setConstant(0.5 * body.solid.size.norm());
    thing.pose = body.start.pose;
  }
  if (things.empty()) return 0.0;
  Collision collision(model);
  Kinematics k(model);
  k.update(Configuration(model, scene.start_pose));
  const Eigen::Vector3d ground = arm_span(k, hand).shoulder - arm.shoulder;
  const auto clear = [&](double angle) {
    std::vector<Obstacle> turned = things;
    for (Obstacle& thing : turned) thing.pose = Eigen::Translation3d(ground) * turned_about(arm.shoulder, angle) * thing.pose;
    collision.set_obstacles(turned);
    PairDistance near;
    for (int link = 0; link < model.link_count(); ++link) {
      for (int thing = 0; thing < std::min(static_cast<int>(turned.size()), Collision::kMaxObstacles); ++thing) {
        if (collision.pair_nearer_than(k, link, model.link_count() + thing, kClear * arm.length, near)) return false;
      }
    }
    return true;
  };
  for (int step = 0; step <= kSteps; ++step) {
    for (const double angle : {step * M_PI / kSteps, -step * M_PI / kSteps}) {
      if (clear(angle)) return angle;
    }
  }
  return 0.0;
}

// What is given in lengths of the right arm, or the only one, in metres from then on.
void measure_by_arm(Scene& scene, const Model& model) {
  if (!scene.in_arm_lengths) return;
  const Hand& hand = model.hands[model.hands[1].link >= 0 ? 1 : 0];
  if (hand.link < 0 || hand.joints.empty())
    throw std::runtime_error("scene " + scene.name + ": its lengths are those of an arm, and the robot " + model.name + " has none");
  const ArmSpan arm = arm_of(scene, model, hand);
  Kinematics k(model);
  k.update(Configuration(model, scene.start_pose));
  const Eigen::Matrix3d axes = pointing(k, hand);
  const auto place = [&](Eigen::Vector3d position) { return Eigen::Vector3d(arm.shoulder + arm.length * position); };
  for (Obstacle& obstacle : scene.obstacles) {
    obstacle.pose.translation() = place(obstacle.pose.translation());
    obstacle.size *= arm.length;
  }
  for (LooseBody& body : scene.loose) {
    body.start.pose.translation() = place(body.start.pose.translation());
    body.solid.size *= arm.length;
  }
  for (LooseEnd& end : scene.criteria.loose) end.position = place(end.position);
  const Eigen::Isometry3d turn = turned_about(arm.shoulder, turn_to_clear(scene, model, hand, arm));
  for (Obstacle& obstacle : scene.obstacles) obstacle.pose = turn * obstacle.pose;
  for (LooseBody& body : scene.loose) body.start.pose = turn * body.start.pose;
  for (LooseEnd& end : scene.criteria.loose) end.position = turn * end.position;
  for (TimedGoal& timed : scene.goals) {
    if (!timed.of_reach) continue;
    timed.reach = turn.linear() * timed.reach;
    const auto& [w, x, y, z] = timed.goal.orientation;
    const Eigen::Quaterniond turned(turn.linear() * Eigen::Quaterniond(w, x, y, z).toRotationMatrix() * axes.transpose());
    timed.goal.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
  }
  give_time(scene, model, hand);
  scene.in_arm_lengths = false;
}

}  // namespace

int find_place(const Model& model, const std::string& name) {
  if (const int link = model.find_link(name); link >= 0) return link;
  if (name == "base") return 0;
  if (name == "chest") return chest(model);
  if (name == "head") return head(model);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string which = side == 0 ? "left" : "right";
    if (name == which + "_foot") return model.soles[side].link;
    if (name != which + "_hand") continue;
    return model.hands[side].link >= 0 ? model.hands[side].link : model.hands[1 - side].link;
  }
  return -1;
}

int find_joint_place(const Model& model, const std::string& name) {
  if (const int joint = model.find_joint(name); joint >= 0) return joint;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string which = side == 0 ? "left" : "right";
    const bool ankle = name == which + "_ankle_pitch", knee = name == which + "_knee";
    if (!ankle && !knee) continue;
    const std::vector<int> joints = pitch_joints(model, model.soles[side].link);
    const std::size_t index = ankle ? 0 : 1;
    return index < joints.size() ? joints[index] : -1;
  }
  return -1;
}

void name_places(Scene& scene, const Model& model) {
  measure_by_arm(scene, model);
  const auto link = [&](std::string& name) {
    const int found = name.empty() ? -1 : find_place(model, name);
    if (found >= 0) name = model.links[at(found)].name;
  };
  const auto joint = [&](std::string& name) {
    const int found = name.empty() ? -1 : find_joint_place(model, name);
    if (found >= 0) name = model.joints[at(found)].name;
  };
  for (Push& push : scene.pushes) link(push.link);
  link(scene.push_round.link);
  for (BodyChange& body : scene.bodies) link(body.link);
  for (Grasp& grasp : scene.grasps) {
    link(grasp.link);
    const bool loose = std::any_of(scene.loose.begin(), scene.loose.end(),
                                   [&](const LooseBody& body) { return body.name == grasp.to; });
    if (!loose) link(grasp.to);
  }
  joint(scene.criteria.swing.joint);
  for (JointEnd& end : scene.criteria.joints) joint(end.name);
  for (auto& [name, speed] : scene.start_velocity) joint(name);
  for (TimedGoal& timed : scene.goals) {
    const std::size_t side = timed.goal.side == ArmSide::kLeft ? 0 : 1;
    if (model.hands[side].link < 0 && model.hands[1 - side].link >= 0)
      timed.goal.side = side == 0 ? ArmSide::kRight : ArmSide::kLeft;
    const Hand& hand = model.hands[timed.goal.side == ArmSide::kLeft ? 0 : 1];
    if (!timed.of_reach || hand.link < 0 || hand.joints.empty()) continue;
    const ArmSpan arm = arm_of(scene, model, hand);
    const Eigen::Vector3d position = arm.shoulder + arm.length * timed.reach;
    for (int i = 0; i < 3; ++i) timed.goal.position[at(i)] = position[i];
  }
  if (model.floating_base) return;
  for (TimedMode& timed : scene.modes) {
    if (timed.request.mode == Mode::kBalance) timed.request.mode = Mode::kHold;
  }
}

}  // namespace twinbus
