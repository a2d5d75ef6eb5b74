// What the kernels of SelfCollision read and write: plain numbers, so that no inline function of a
// library is compiled for an instruction set that the machine may lack.

#pragma once

#include "robot/collision/links/link_geometry.h"
#include "robot/collision/exact/posture_cells.h"

namespace twinbus {

struct alignas(16) CollisionJoint {                       // one that moves geometry
  float still[3][4], with_cosine[3][4], with_sine[3][4];  // columns of the rotation
  float offset[4];                                        // in the parent's axes
  float slide[4];                                         // per unit of a prismatic joint
  int parent = 0, child = 0;                              // links
  int index = 0;                                          // of the joint in the model
  bool turns = true;
};

struct alignas(16) CollisionPose {  // in link 0
  float column[3][4];
  float origin[4];
};

// Boxes along the link's axes around the triangles of a cluster, enlarged by more than single precision can lose.
struct alignas(64) CollisionTriangleBoxes {
  float low[3][TriangleCluster::kLanes], high[3][TriangleCluster::kLanes];
};

struct alignas(16) CollisionBody {  // a link that bears geometry
  float sphere[4], from[4], to[4];  // sphere centre, capsule ends; the last number is the radius
  float low[4], high[4];
  int link = 0;
  int clusters = 0;
  const float* center[3] = {};  // of the clusters' spheres, padded to a multiple of 8
  const float* radius = nullptr;
  const float* block_center[3] = {};  // of balls around eight clusters in a row, padded likewise
  const float* block_radius = nullptr;
  const float (*middle)[4] = nullptr;  // of the clusters' boxes
  const float (*half)[4] = nullptr;
  const float *box_middle[3] = {}, *box_half[3] = {};  // the same, padded like the centres
  const float *box_low[3] = {}, *box_high[3] = {};
  const TriangleCluster* cluster = nullptr;
  const CollisionTriangleBoxes* triangle_boxes = nullptr;  // of every cluster
  const float (*witness)[4] = nullptr;
  int witnesses = 0;
  const float* hull[3] =
      {};                // corners of the convex hull, the last one repeated up to a multiple of 8
  int hull_corners = 0;  // with the repeated ones
  const float* inner[4] = {};  // balls inside: centres and radii, padded to a multiple of 8
  int inner_balls = 0;         // with the padding
};

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
  unsigned char* open = nullptr;      // [most clusters / 8]
  CollisionMemory* memory = nullptr;  // [pairs]
  long* work = nullptr;               // spheres, capsules, clusters, rows
  int most_clusters = 0;              // padded to 8
};

}  // namespace twinbus
