// Triangles of a mesh file: STL (text and binary), OBJ, DAE.
//
// Read by code of our own, and only the geometry: what a general importer does with a hostile file
// (it leaks, opens the files it names, takes all memory) cannot be bounded from outside.  Material
// libraries and textures are not opened.

#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline geometry {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;        // [m]
  std::vector<std::array<int, 3>> triangles;  // indices of points
};

inline constexpr std::size_t kMaxMeshTriangles = 2'000'000;

// scale: per axis.  Throws std::runtime_error naming the file when it cannot be read, has no
// triangle, is larger than 64 MB or 2 million triangles, or has a corner that is not finite.
TriangleMesh load_mesh(const std::string& file, const Eigen::Vector3d& scale);

// The same from the bytes of a file; the ending of its name says what it is.
TriangleMesh parse_mesh(const std::string& bytes, const std::string& file,
                        const Eigen::Vector3d& scale);

// One format each, unscaled and without the checks that all share.  Throw, naming file and place.
TriangleMesh parse_stl(std::string_view bytes, const std::string& file);
TriangleMesh parse_obj(std::string_view text, const std::string& file);
TriangleMesh parse_dae(const std::string& text, const std::string& file);

// Adds the triangles of a convex polygon.  Throws when a corner is not a point of the mesh, or the
// mesh grows too large.
void add_polygon(const std::vector<int>& corners, const std::string& file, TriangleMesh& mesh);

}  // namespace twinbus::geometry
