// A robot with some of its joints held for good: the links that they joined become one, with the same mass, centre of
// mass and inertia, so the result moves exactly as the whole robot would with those joints held.

#pragma once

#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline sim {

struct WeldedModel {
  Model model;             // joints and links that are left, in their order
  std::vector<int> joint;  // of each former joint: its index now, -1: held
  std::vector<int> link;   // of each former link: the one that it is part of
  std::vector<Eigen::Isometry3d> in_link;  // its frame in that one
  std::vector<int> former_link;            // of each link: the former one whose frame it keeps
  std::vector<int> first_shape;            // of each former link, among the collision shapes of the one that it is part of
};

// Adds to `held` [joint_count] what cannot move alone: a joint that follows a held one, and one that a held one follows.
void hold_followers(const Model& model, std::vector<bool>& held);

// held: [joint_count], closed as hold_followers() leaves it.  q: [joint_count], where the held ones stand [rad or m].
// Two links of the result are a disabled pair only if all pairs of their parts are.  Throws std::invalid_argument for
// another size, or a held joint that follows one which moves.
WeldedModel weld(const Model& model, const std::vector<bool>& held, const Eigen::VectorXd& q);

}  // namespace twinbus::sim
