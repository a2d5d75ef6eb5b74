// What a block check writes on: every number eight times, a lane per posture.

#pragma once

#include <cstdint>

#include "planner/batch/robot.h"

// Vectors are passed by value between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace twinbus::inline planner {

typedef float Lanes __attribute__((vector_size(32), aligned(32)));
typedef std::int32_t Flags __attribute__((vector_size(32), aligned(32)));  // -1 or 0 per lane

struct BlockWork {
  const float *from, *step;  // the line, and where on it the lanes are
  Lanes t;
  Lanes rotation[kBlockBodies][9], origin[kBlockBodies][3];
  Lanes around[kBlockGroups][3];  // centres of the balls around groups
  Lanes reach[kBlockGroups];      // their radii, and how far they move between two postures
  Lanes turn[kBlockGroups];       // how far a unit of length turns meanwhile
  Lanes ball[kBlockBalls][3];
  // For certificates: how bodies move, and groups over half an interval.
  Lanes rate[kBlockBodies][6], moves[kBlockGroups][3];
  float bend[kBlockGroups];
  bool placed[kBlockGroups];
  bool by_pieces = false;  // what hulls leave open is settled by their pieces
  bool pairs_by_hulls = false;  // what balls of two groups leave open is settled by their hulls
  // On the rake, groups and pairs of them that hulls and pieces settle; balls have the last word on the others.
  bool settles[kBlockGroups], settles_pair[kBlockGroups * kBlockGroups / 2];
  bool fine[kBlockGroups], fine_pair[kBlockGroups * kBlockGroups / 2];  // those that pieces do
  bool notes = false;  // what is touched is noted there, and in nobody's way
  // What a line has near it, found by its first block: groups with an obstacle, and their balls.
  struct Near {
    int group, obstacle;
    int first, count;  // in near_ball
  };
  static constexpr int kMostNear = 1024, kMostNearBalls = 8192;
  Near near[kMostNear];
  int near_count;
  int near_ball[kMostNearBalls];
  int near_ball_count;
  int near_pair[kBlockGroups * kBlockGroups / 2];
  int near_pair_count;
  int near_group[kBlockGroups];  // those of near pairs
  int near_group_count;
  // Of the groups, eight at a time and by joints: see BlockGroup.
  Lanes travel[kMostPlanned][kBlockGroups / 8], turning[kMostPlanned][kBlockGroups / 8];
  // How far a line swings and turns the groups, at most.
  Lanes swing[kBlockGroups / 8], angle[kBlockGroups / 8];
  int last_body;  // the highest that anything near is fixed to
};

}  // namespace twinbus::planner
