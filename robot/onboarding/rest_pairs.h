// Pairs of links that a robot's own shape brings together at rest: its guard could only stop it for them.

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

struct RestPair {
  int link_a = 0, link_b = 0;
  std::string why;  // they are left out
};

// Links that touch in one of the postures [joint_count], links that are nearer than a guard's margin with few joints
// between them, and the mirror images of all these.  Nothing that the SRDF leaves out already.
std::vector<RestPair> pairs_at_rest(const Model& model, const std::vector<Eigen::VectorXd>& postures);

// The line of an SRDF that says so.
std::string exempted(const Model& model, const RestPair& pair);

struct NearByDesign {
  int link_a = 0, link_b = 0;
  double margin = 0.0;  // [m]
  std::string why;
};

// Pairs of one limb, or of two beside each other, that are near in one of the postures, with the margin that is enough for
// them: as far as joints that end off their foretold places bring them together.  What is in left_out has none.
std::vector<NearByDesign> pairs_near_by_design(const Model& model, const std::vector<Eigen::VectorXd>& postures,
                                               const std::vector<RestPair>& left_out);

// The link on the other side, in the posture nearest to zero; -1: there is none [link_count].
std::vector<int> mirror_images(const Model& model);

}  // namespace twinbus::robot
