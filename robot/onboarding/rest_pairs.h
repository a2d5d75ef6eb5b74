// Pairs of links that a robot's own shape brings together at rest: its guard could only stop it for them.

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus {

struct RestPair {
  int link_a = 0, link_b = 0;
  std::string why;  // they are left out
};

// Links that touch in one of the postures [joint_count], links that are nearer than a guard's margin with few joints
// between them, and the mirror images of all these.  Nothing that the SRDF leaves out already.
std::vector<RestPair> pairs_at_rest(const Model& model, const std::vector<Eigen::VectorXd>& postures);

// The link on the other side, in the posture nearest to zero; -1: there is none [link_count].
std::vector<int> mirror_images(const Model& model);

}  // namespace twinbus
