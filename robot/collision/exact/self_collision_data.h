// What the kernels of SelfCollision read and write: plain numbers, so that no inline function of a
// library is compiled for an instruction set that the machine may lack.

#pragma once

#include "geometry/distance/body_data.h"
#include "robot/collision/exact/posture_cells.h"

namespace twinbus::inline robot {

// What the last look at a pair found; it says where to look first, never what is there.
struct alignas(16) CollisionMemory {
  float apart[4] =
      {};  // a direction that parted the hulls, in the axes of the second body; or zero
  int cluster[2] = {-1, -1};  // that crossed
  int stuck = 0;              // looks in a row at which no plane was found between the hulls
};

struct CollisionCells {  // JointCells of a pair, clusters in the order in which it is looked at
  int joints = 0;
  int slot[JointCells::kMostJoints] = {}, count[JointCells::kMostJoints] = {};
  double low[JointCells::kMostJoints] = {}, per_unit[JointCells::kMostJoints] = {};
  const std::uint32_t *cell = nullptr, *lists = nullptr;
};

struct CollisionCandidate {
  int a = 0, b = 0;  // bodies
};

struct CollisionTables {
  const CollisionJoint* joint = nullptr;
  const CollisionBody* body = nullptr;
  const unsigned char* wanted = nullptr;  // [bodies x blocks], a bit per body b > a
  const int* pair_of = nullptr;           // [bodies x bodies], -1
  const CollisionCells* cells = nullptr;  // [pairs]
  int joints = 0, bodies = 0, blocks = 0;
  // Of the posture.
  const double* q = nullptr;
  const double* sine = nullptr;
  const double* cosine = nullptr;
  CollisionPose* pose = nullptr;                                                 // [links]
  float *sphere[4] = {}, *from[3] = {}, *to[3] = {}, *capsule_radius = nullptr;  // padded to 8
  CollisionCandidate* near = nullptr;                                            // [pairs + 8]
  int* hit = nullptr;                                                            // [pairs]
  float* bound = nullptr;             // [pairs + 8], of the candidates
  float* kept = nullptr;              // [14 x most clusters]
  int* open = nullptr;      // [most clusters / 8]
  CollisionMemory* memory = nullptr;  // [pairs]
  long* work = nullptr;               // spheres, capsules, clusters, rows
  int most_clusters = 0;              // padded to 8
};

}  // namespace twinbus::robot
