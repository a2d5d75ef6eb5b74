// The triangles of a mesh in clusters of up to 16, in the order of their tree; neighbours lie together.

#pragma once

#include <vector>

#include "geometry/mesh/mesh_file.h"
#include "geometry/shapes.h"

namespace twinbus::inline geometry {

// Up to 16 triangles that lie together, a lane each; the lanes behind the last repeat it.  Bounds
// are enlarged by more than single precision can lose.
struct alignas(64) TriangleCluster {
  static constexpr int kLanes = 16;
  float corner[3][3][kLanes];  // corner, coordinate, triangle
  float normal[3][kLanes];     // unit; zero for a triangle without area
  float offset[kLanes];        // normal . x of the plane
  float center[3];             // of the sphere around all
  float radius;
  float low[3], high[3];  // box around all
  int count;              // triangles that are real
};

// What the sphere around a cluster is larger by, more than single precision can lose [m].
inline constexpr double kGrowTriangleCluster = 2e-6;

// order: the triangles, cluster by cluster.
std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh, std::vector<int>& order);
std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh);

// One of `count` triangles; of its sphere only what is known.
TriangleCluster triangle_cluster(const TriangleMesh& mesh, const int* triangles, int count,
                                 const Ball* sphere);

}  // namespace twinbus::geometry
