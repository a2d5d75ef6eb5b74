#include "geometry/mesh/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "common/text/xml.h"

namespace twinbus::inline geometry {

namespace {

constexpr double kFarthest = 1e4;  // a corner further away [m] is a mistake of the unit

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw std::runtime_error("mesh " + file + ": " + what);
}

}  // namespace

void add_polygon(const std::vector<int>& corners, const std::string& file, TriangleMesh& mesh) {
  if (corners.size() < 3) return;  // points and lines
  if (mesh.triangles.size() + corners.size() - 2 > kMaxMeshTriangles) {
    fail(file, "more than 2 million triangles; simplify it");
  }
  for (const int corner : corners) {
    if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.points.size()) {
      fail(file, "a face names a corner that does not exist; export it again");
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

TriangleMesh parse_mesh(const std::string& bytes, const std::string& file,
                        const Eigen::Vector3d& scale) {
  const std::size_t dot = file.rfind('.');
  std::string kind = dot == std::string::npos ? "" : file.substr(dot + 1);
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  TriangleMesh mesh;
  if (kind == "stl") {
    mesh = parse_stl(bytes, file);
  } else if (kind == "obj") {
    mesh = parse_obj(bytes, file);
  } else if (kind == "dae") {
    mesh = parse_dae(bytes, file);
  } else {
    fail(file, "is neither .stl, .obj nor .dae; export it as one of them");
  }
  if (mesh.triangles.empty()) fail(file, "has no triangle; export it again");
  for (Eigen::Vector3d& point : mesh.points) {
    point = point.cwiseProduct(scale);
    for (int i = 0; i < 3; ++i) {
      if (!(std::abs(point[i]) < kFarthest)) {
        fail(file, "a corner is not finite or further away than 10 km; check unit and scale");
      }
    }
  }
  return mesh;
}

TriangleMesh load_mesh(const std::string& file, const Eigen::Vector3d& scale) {
  std::string bytes;
  try {
    bytes = read_file(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("mesh " + std::string(error.what()) +
                             "; check the file name in the URDF, or simplify the mesh");
  }
  return parse_mesh(bytes, file, scale);
}

}  // namespace twinbus::geometry
