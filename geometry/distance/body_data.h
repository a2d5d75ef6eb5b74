// What the kernels of distances and intersections read of moving bodies: plain numbers, so that no inline function of a
// library is compiled for an instruction set that the machine may lack.

#pragma once

#include "geometry/bounds/triangle_clusters.h"

namespace twinbus::inline geometry {

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

}  // namespace twinbus::geometry
