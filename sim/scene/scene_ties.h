// The ties of a scene: the loops of the robot and of the scene, and what is to be gripped and let go
// as it runs.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/scene/rigid_object_pieces.h"
#include "sim/scene/scene.h"
#include "sim/world/constraint.h"

namespace twinbus::inline sim {

class SceneTies {
 public:
  SceneTies() = default;
  // robots: the further ones of the scene.  Throws std::runtime_error for a name that neither
  // robot nor scene has.
  SceneTies(const Model& model, const std::vector<OtherRobot>& robots, const Scene& scene);

  const std::vector<Tie>& ties() const noexcept { return ties_; }
  // At the start of a step at a time of the scene [s]: what is due is gripped or let go.
  void update(double time, World& world) noexcept;
  // What a hand holds (by its number), as on HELD, of the loose bodies; false: no grasp is of this hand.
  bool held(int hand, const LoosePieces& loose, ObstaclesPiece& out) const noexcept;

 private:
  struct Timed {
    int first;  // of its ties
    double at, until;
    int hand = -1, body = -1;  // a loose body that this hand grips, else -1
    bool holds = false;
    Eigen::Isometry3d body_in_hand = Eigen::Isometry3d::Identity();  // as it was gripped
  };

  std::vector<Tie> ties_;
  std::vector<Timed> grasps_;
  std::array<Hand, kMostHands> hands_;  // by their numbers
  std::int64_t changes_ = 0;  // grips and releases so far
};

}  // namespace twinbus::sim
