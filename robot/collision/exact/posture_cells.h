// What of two links can touch, by cells of the joints between them: for links with few joints between,
// whose hulls overlap in every posture and of whose triangles few ever come near.
//
// The ranges of these joints are cut into boxes.  With c the posture in the middle, h_j its half widths
// and r_j how far a cluster of triangles lies from the axis of joint j at c, moves of the joints farther
// out added, two clusters touch nowhere in the box when at c they are farther apart than
//
//     sum over j of  2 r_j sin(h_j / 2)        (h_j for a sliding joint)
//
// Boxes are halved, their lists of what may touch growing shorter, down to empty lists or cells.
// Nothing is said of postures beyond the limits.

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/collision/links/link_geometry.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct JointCells {
  static constexpr int kMostJoints = 3, kMostCouples = 30;
  static constexpr std::uint32_t kFree = 0;     // proved not to touch, nor to be inside
  static constexpr std::uint32_t kUnknown = 1;  // or too much to list

  int joints = 0;  // none: nothing is known of the pair
  int joint[kMostJoints] = {};
  int count[kMostJoints] = {};        // of cells
  double low[kMostJoints] = {};       // [rad or m]
  double per_unit[kMostJoints] = {};  // cells
  // Of a cell, the last joint's the fastest: one of the above, or where in `lists` its list begins.
  std::vector<std::uint32_t> cell;
  // How many couples, then each: cluster of link a, and of link b times 65536.
  std::vector<std::uint32_t> lists;
};

struct JointCellOptions {
  int per_joint = 24;  // cells
  int looks = 40'000;  // boxes per pair, at most
};

// One of each pair, in their order; without joints where more than kMostJoints are between.  Takes
// some tenths of a second per pair that comes near.  progress: called before each pair.
std::vector<JointCells> find_joint_cells(const Model& model, const RobotGeometry& geometry,
                                         const std::vector<CollisionPair>& pairs,
                                         const JointCellOptions& options = {},
                                         const std::function<void(int done)>& progress = {});

// Could they be of this pair: joints, ranges, cells and lists as find_joint_cells makes them?  Says
// nothing of whether a cell is rightly free.
bool are_cells_of(const JointCells& cells, const Model& model, const RobotGeometry& geometry,
                  const CollisionPair& pair, const JointCellOptions& options = {});

}  // namespace twinbus::robot
