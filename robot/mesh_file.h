// Triangles of a mesh file (STL, OBJ, DAE, ...), through assimp.

#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace twinbus {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;        // [m]
  std::vector<std::array<int, 3>> triangles;  // indices of points
};

// scale: per axis.  Throws std::runtime_error naming the file when it cannot be read, has no
// triangle, is larger than 64 MB or 2 million triangles, or has a corner that is not finite.
TriangleMesh load_mesh(const std::string& file, const Eigen::Vector3d& scale);

}  // namespace twinbus
