// What the kernels of MeshDistance read and write: plain numbers, as in body_data.h.

#pragma once

#include "geometry/distance/body_data.h"

namespace twinbus::inline geometry {

struct MeshView {
  const TriangleCluster* cluster = nullptr;
  int clusters = 0;
  const float* center[3] = {};  // of the clusters' spheres, padded to a multiple of 8
  const float* radius = nullptr;
  const float (*middle)[4] = nullptr;  // of the clusters' boxes
  const float (*half)[4] = nullptr;
  float low[3], high[3];  // box around all
};

struct MeshTables {
  const MeshView* a = nullptr;
  const MeshView* b = nullptr;
  CollisionPose a_to_b, b_to_a;
  float enough = 0.0F;    // what is this near is not searched further [m]
  float* kept = nullptr;  // [2 x 8 x stride]
  int stride = 0;
};

struct MeshNearest {
  float below = 0.0F;                  // [m]
  int cluster_a = -1, cluster_b = -1;  // going in: to be measured first
  int triangle_a = 0, triangle_b = 0;  // in their clusters
};

}  // namespace twinbus::geometry
