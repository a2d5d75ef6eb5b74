// The triangles of a mesh in clusters of up to 16, in the order of their tree; neighbours lie together.

#pragma once

#include <vector>

#include "robot/geometry.h"

namespace twinbus {

std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh);

}  // namespace twinbus
