// The triangles of a mesh in clusters of up to 16, in the order of their tree; neighbours lie together.

#pragma once

#include <vector>

#include "robot/collision/links/link_geometry.h"

namespace twinbus {

// order: the triangles, cluster by cluster.
std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh, std::vector<int>& order);
std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh);

// One of `count` triangles; of its sphere only what is known.
TriangleCluster triangle_cluster(const TriangleMesh& mesh, const int* triangles, int count,
                                 const Ball* sphere);

}  // namespace twinbus
