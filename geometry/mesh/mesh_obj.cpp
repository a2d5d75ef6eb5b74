// OBJ: lines `v x y z` and `f a b c ...`, whose corners are counted from 1, or backwards from -1.

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "geometry/mesh/mesh_file.h"
#include "common/text/xml.h"

namespace twinbus::inline geometry {

namespace {

constexpr std::size_t kMaxCorners = 1000;  // of one face

class ObjReader {
 public:
  explicit ObjReader(const std::string& file) : file_(file) {}

  void line(std::string_view line) {
    ++number_;
    const std::string_view word = next(line);
    if (word == "v") {
      vertex(line);
    } else if (word == "f") {
      face(line);
    }
  }

  TriangleMesh mesh;

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("mesh " + file_ + ":" + std::to_string(number_) + ": " + what);
  }

  // Takes the next word off the line; empty at its end.
  static std::string_view next(std::string_view& line) {
    const std::size_t start = std::min(line.find_first_not_of(" \t\r"), line.size());
    line.remove_prefix(start);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
  }

  void vertex(std::string_view line) {
    Eigen::Vector3d point;
    for (int i = 0; i < 3; ++i) {  // what follows is a weight or a colour
      if (!parse_numbers(std::string(next(line)), &point[i], 1)) {
        fail("v needs three finite numbers; export it again");
      }
    }
    if (mesh.points.size() >= 3 * kMaxMeshTriangles)
      fail("more than 6 million points; simplify it");
    mesh.points.push_back(point);
  }

  void face(std::string_view line) {
    corners_.clear();
    for (std::string_view word = next(line); !word.empty(); word = next(line)) {
      int index = 0;  // what follows a slash is texture and normal
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
      const bool whole = end == word.data() + word.size() || *end == '/';
      if (error != std::errc() || !whole || index == 0) {
        fail("f needs whole numbers; export it again");
      }
      if (corners_.size() >= kMaxCorners) fail("a face of more than 1000 corners; make triangles");
      const auto count = static_cast<int>(mesh.points.size());
      corners_.push_back(index > 0 ? index - 1 : count + index);
    }
    add_polygon(corners_, file_ + ":" + std::to_string(number_), mesh);
  }

  const std::string& file_;
  int number_ = 0;
  std::vector<int> corners_;
};

}  // namespace

TriangleMesh parse_obj(std::string_view text, const std::string& file) {
  ObjReader reader(file);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return std::move(reader.mesh);
}

}  // namespace twinbus::geometry
