#include "sim/scene/scene_ties.h"

#include <stdexcept>

#include "common/math/index.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/description/loops.h"

namespace twinbus::inline sim {

namespace {

constexpr int kTiesOfAGrasp = 3;  // not on one line: nothing turns in the hand

// Which of the two would a tie mean?
void refuse_loose_called(const std::string& name, const std::string& whose, const Scene& scene) {
  for (std::size_t i = 0; i < scene.loose.size(); ++i) {
    if (scene.loose[i].name != name) continue;
    throw std::runtime_error(scene.loose_at[i] + ": a tie names '" + name +
                             "', which is this loose body and " + whose +
                             "; give the loose body another name, here and in loops and grasps");
  }
}

// A link of a further robot is called NAME/LINK.
TieEnd end_of(const Model& model, const std::vector<OtherRobot>& robots, const Scene& scene,
              const std::string& name, const Eigen::Vector3d& point) {
  if (name == "world") {
    refuse_loose_called(name, "what is fixed", scene);
    return {-1, -1, point};
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const Frame& frame : robots[i].model->frames) {
      if (name != robots[i].name + "/" + frame.name) continue;
      refuse_loose_called(name, "a link of robot '" + robots[i].name + "'", scene);
      return {frame.link, -1, frame.in_link * point, static_cast<int>(i)};
    }
  }
  for (const Frame& frame : model.frames) {
    if (frame.name != name) continue;
    refuse_loose_called(name, "a link of the robot " + model.name, scene);
    return {frame.link, -1, frame.in_link * point};
  }
  for (std::size_t i = 0; i < scene.loose.size(); ++i) {
    if (scene.loose[i].name == name) return {-1, static_cast<int>(i), point};
  }
  throw std::runtime_error("scene " + scene.name + ": a tie names '" + name +
                           "', which is no link of the robot " + model.name +
                           ", no loose body, no NAME/LINK of a further robot and not world");
}

}  // namespace

SceneTies::SceneTies(const Model& model, const std::vector<OtherRobot>& robots,
                     const Scene& scene) {
  for (const Hand* hand : hands_of(model)) hands_[at(number_of(model, *hand))] = *hand;
  const auto end = [&](const std::string& name, const Eigen::Vector3d& point) {
    return end_of(model, robots, scene, name, point);
  };
  for (const std::vector<Loop>* loops : {&model.loops, &scene.loops}) {
    for (const Loop& loop : *loops) {
      Tie tie;
      tie.a = end(loop.link, loop.point);
      tie.b = end(loop.to, loop.at);
      tie.stiffness = loop.stiffness;
      tie.damping = loop.damping;
      tie.length = loop.length;
      ties_.push_back(tie);
    }
  }
  for (const Grasp& grasp : scene.grasps) {
    Timed timed{.first = static_cast<int>(ties_.size()), .at = grasp.at, .until = grasp.until};
    const TieEnd by = end(grasp.link, grasp.point), gripped = end(grasp.to, Eigen::Vector3d::Zero());
    for (int hand = 0; hand < kMostHands; ++hand) {
      if (gripped.loose < 0 || by.robot >= 0 || by.link < 0 || by.link != hands_[at(hand)].link) continue;
      timed.hand = hand;
      timed.body = gripped.loose;
    }
    grasps_.push_back(timed);
    for (int axis = 0; axis < kTiesOfAGrasp; ++axis) {
      Tie tie;
      tie.a = end(grasp.link, grasp.point + grasp.reach * Eigen::Vector3d::Unit(axis));
      tie.b = end(grasp.to, Eigen::Vector3d::Zero());
      tie.stiffness = grasp.stiffness / kTiesOfAGrasp;
      tie.damping = grasp.damping / kTiesOfAGrasp;
      tie.holds = false;
      ties_.push_back(tie);
    }
  }
}

void SceneTies::update(double time, World& world) noexcept {
  for (Timed& grasp : grasps_) {
    const bool wanted = time >= grasp.at && time < grasp.until;
    if (wanted == grasp.holds) continue;
    grasp.holds = wanted;
    for (int i = 0; i < kTiesOfAGrasp; ++i) (void)world.hold(grasp.first + i, wanted);
    if (grasp.hand < 0) continue;
    ++changes_;
    const Hand& hand = hands_[at(grasp.hand)];
    grasp.body_in_hand = (world.link_in_world(hand.link) * hand.frame).inverse() * world.loose(grasp.body).pose;
  }
}

bool SceneTies::held(int hand, const LoosePieces& loose, ObstaclesPiece& out) const noexcept {
  out = ObstaclesPiece{};
  out.scene_id = changes_ + 1;
  out.piece = static_cast<std::int16_t>(hand);
  out.pieces = held_pieces(hand);
  out.attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
  bool any = false;
  for (const Timed& grasp : grasps_) {
    if (grasp.hand != hand) continue;
    any = true;
    if (grasp.holds) loose.body(grasp.body, grasp.body_in_hand, out);
  }
  return any;
}

}  // namespace twinbus::sim
