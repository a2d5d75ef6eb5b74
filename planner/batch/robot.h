// A robot compiled for checks of 8 postures at a time: bodies that the planned joints move, and balls
// fixed to them.
//
// Everything that no planned joint moves is one body, the world.  Body frames are turned so that
// every joint axis is +z: a joint then mixes two columns of its rotation only.  Columns of the
// constant rotations that are coordinate axes (nearly all, in practice) are known as such.

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "robot/collision/links/link_geometry.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

inline constexpr int kMostPlanned = 24;   // joints planned together
inline constexpr int kBlockBodies = 48;   // bodies
inline constexpr int kBlockGroups = 96;   // groups of balls
inline constexpr int kBlockBalls = 2048;  // balls
inline constexpr int kBunch = 16;         // pieces that have one ball around them

// Balls around what a group has, in the link frame [m].
struct GroupBounds {
  Ball balls;                  // around all balls
  std::vector<Ball> pieces;    // around each
  std::vector<Ball> bunches;   // of up to kBunch pieces each, but the first
};

// Balls of one link, or of one part of it: with one ball around them.
struct BallGroup {
  int link = 0;             // model index
  std::vector<Ball> balls;  // in the link frame [m]
  // Corners of convex bodies that settle what the balls leave open: the first holds everything, the
  // others everything together, more tightly.  Empty: the balls have the last word.
  std::vector<std::vector<Eigen::Vector3d>> pieces = {};
  std::vector<Ball> inner = {};  // inside of the link: what touches them touches it
  std::optional<GroupBounds> bounds = std::nullopt;  // as bounds_of finds them, when a group is compiled more than once
  bool held = false;  // of an obstacle that the link holds; without balls: of one that it does not
};

struct BlockBody {
  int parent = 0;
  int joint = 0;                     // planned joint
  float scale = 1.0F, shift = 0.0F;  // angle = scale q + shift (mimic joints)
  bool slides = false;
  int axis[3] = {0, 1, 2};             // the column is this axis of the parent; -1: any vector
  float sign[3] = {1.0F, 1.0F, 1.0F};  // times this
  float rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // by rows
  float offset[3] = {0, 0, 0};                      // [m]
};

struct BlockBall {
  float x, y, z, radius;  // in the body [m]
};

struct BlockPiece {
  int first = 0, count = 0;  // in corners: x of all, then y, then z
  int room = 0;              // of each: a multiple of 16, filled up with the first
  BlockBall around{};
};

struct BlockGroup {
  int body = 0;
  int first = 0, count = 0;  // in balls
  int link = 0;              // model index
  int first_piece = 0, piece_count = 0;
  int first_bunch = 0;
  int first_inner = 0, inner_count = 0;
  BlockBall around{};
  float travel[kMostPlanned] = {};  // most that a point of it moves per unit of each joint [m]
  float turn[kMostPlanned] = {};    // and that it turns [rad]
};

// Of two groups with one or two joints between: cells of these joints in which the hulls are proved apart.
struct ClearCells {
  int joints = 0;  // 0: nothing is known
  int joint[2] = {}, count[2] = {};
  float low[2] = {}, per_unit[2] = {};  // [rad or m], cells
  std::vector<int> open;  // [count + 1 x count + 1]: how many cells before both are not clear
};

// A group and an obstacle of the scene that keep less than others.
struct BlockMargin {
  int group = 0, shape = 0;
  float kept = 0.0F;  // [m]; below zero: they are no pair
};

struct BlockRobot {
  int joints = 0;
  float grow = 0.0F;                // in every radius; what pieces keep from obstacles [m]
  std::vector<float> lower, upper;  // of the planned joints [rad or m]
  std::vector<BlockBody> bodies;    // parents first; 0 is the world
  std::vector<BlockGroup> groups;   // those of the world first
  int fixed_groups = 0;             // that many are of the world
  std::vector<BlockBall> balls;
  std::vector<BlockBall> inner;
  std::vector<BlockPiece> pieces;
  std::vector<BlockBall> bunches;  // of pieces but the first of a group, in their order
  std::vector<float> corners;              // of the pieces, in the body [m]
  std::vector<ClearCells> clear;           // of the pairs, or empty
  std::vector<std::pair<int, int>> pairs;  // groups that may touch; those that touch often first
  std::vector<int> group_of;               // index in groups of each that was compiled; -1: it has no balls
  // Where hulls and pieces keep less than `grow`: of each pair, or empty, and of some groups and obstacles.
  std::vector<float> kept_of_pairs;  // [m]
  std::vector<BlockMargin> kept_of_shapes;
};

// Balls, hull and clusters of a link.
BallGroup group_from(const LinkGeometry& geometry);

// Milliseconds for a link of many pieces.
GroupBounds bounds_of(const BallGroup& group);

// planned: model indices.  Other joints, and the base, stay as in posture; the result is in its
// world.  pairs: indices of groups; those that no planned joint moves are dropped.  grow: added to
// every radius [m].  Throws std::runtime_error when the robot has more parts than a block holds.
BlockRobot compile_robot(const Model& model, const Configuration& posture,
                         const std::vector<int>& planned, const std::vector<BallGroup>& groups,
                         const std::vector<std::pair<int, int>>& pairs, double grow);

}  // namespace twinbus::planner
