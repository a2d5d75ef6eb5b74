// STL: a list of triangles, as text or as 50 bytes each.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "geometry/mesh/mesh_file.h"
#include "common/text/xml.h"

namespace twinbus::inline geometry {

namespace {

constexpr std::size_t kHeader = 84;  // a comment of 80 bytes, then the number of triangles
constexpr std::size_t kTriangle = 50;

[[noreturn]] void fail_stl(const std::string& file, const std::string& what) {
  throw std::runtime_error("mesh " + file + ": " + what);
}

std::uint32_t count_of(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

// The size says it; some programs begin binary files with the word of a text file.
bool is_binary(std::string_view bytes) {
  if (bytes.size() < kHeader) return false;
  if (bytes.size() == kHeader + kTriangle * std::size_t{count_of(bytes)}) return true;
  return bytes.substr(0, 5) != "solid";
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& file) {
  const std::size_t count = count_of(bytes);
  if (count > kMaxMeshTriangles) fail_stl(file, "more than 2 million triangles; simplify it");
  if (bytes.size() < kHeader + kTriangle * count) {
    fail_stl(file, "is cut off: " + std::to_string(count) + " triangles do not fit in " +
                       std::to_string(bytes.size()) + " bytes; export it again");
  }
  TriangleMesh mesh;
  mesh.points.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    float values[12];  // the normal, then three corners
    std::memcpy(values, bytes.data() + kHeader + kTriangle * i, sizeof(values));
    const auto first = static_cast<int>(mesh.points.size());
    for (int corner = 1; corner <= 3; ++corner) {
      const float* at = values + 3 * corner;
      mesh.points.emplace_back(static_cast<double>(at[0]), static_cast<double>(at[1]),
                               static_cast<double>(at[2]));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh parse_text(std::string_view text, const std::string& file) {
  TriangleMesh mesh;
  std::vector<int> facet;
  int line_number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) continue;
    line.remove_prefix(start);
    if (line.substr(0, 6) == "vertex") {
      Eigen::Vector3d point;
      if (!parse_numbers(std::string(line.substr(6)), point.data(), 3)) {
        fail_stl(file + ":" + std::to_string(line_number),
                 "vertex needs three finite numbers; export it again");
      }
      facet.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(point);
    } else if (line.substr(0, 8) == "endfacet") {
      add_polygon(facet, file, mesh);
      facet.clear();
    }
    if (mesh.points.size() > 3 * kMaxMeshTriangles) {
      fail_stl(file, "more than 2 million triangles; simplify it");
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& file) {
  if (is_binary(bytes)) return parse_binary(bytes, file);
  if (bytes.substr(0, 5) != "solid") {
    fail_stl(file, "is not STL: too short for a binary file, and no text; export it again");
  }
  return parse_text(bytes, file);
}

}  // namespace twinbus::geometry
