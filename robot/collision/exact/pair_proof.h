// Which pairs of links can touch at all: neighbours, pairs seen touching, and pairs that are proved
// never to touch, by which alone a pair may be left out.
//
// The ranges of the joints between the two links are cut into cells.  With d the distance of the
// hulls at the middle of a cell, h_j its half widths and r_j the largest distance of a point of the
// moving link from the axis of joint j in any posture, the pair touches nowhere in the cell when
//
//     d  >  sum over j of  2 r_j sin(h_j / 2)        (h_j for a sliding joint)
//
// Sampling proves nothing: a pair not seen touching and not proved stays in.

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/collision/links/link_geometry.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

enum class PairKind { kNeighbours, kNever, kTouches, kAlwaysSeen, kUnproved };

const char* name(PairKind kind) noexcept;

struct PairVerdict {
  CollisionPair pair;
  PairKind kind = PairKind::kUnproved;
  Eigen::VectorXd posture;  // where it touches, when it was seen
  int cells = 0;            // that were looked at
};

struct PairProofOptions {
  int samples = 10000;          // postures tried for contact
  int cells = 20000;            // most per pair
  double beyond_limits = 0.02;  // joints are taken to overshoot their limits by this [rad or m]
};

// All pairs of links that bear geometry, those that the SRDF leaves out included.
std::vector<PairVerdict> judge_pairs(const Model& model, const RobotGeometry& geometry,
                                     const PairProofOptions& options = {});

// The SRDF with the pairs added that need no check and are not in it yet, each with its reason.
std::string srdf_with_pairs(const Model& model, const std::vector<PairVerdict>& verdicts);

}  // namespace twinbus::robot
