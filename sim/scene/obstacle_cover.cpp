#include "sim/scene/obstacle_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace twinbus::inline sim {

namespace {

using Eigen::Array3i;
using Eigen::Vector3d;

constexpr double kMostCells = 4e6;
constexpr std::size_t kMostNumbers = 5'000'000;
constexpr double kFarthest = 1000.0;  // [m]
constexpr double kTouch = 1e-9;       // of an edge: what touches a cell is in it

// Cells of the box around a shape; its faces are faces of cells.
class Cells {
 public:
  Cells(const Eigen::AlignedBox3d& box, double cell) : low_(box.min()) {
    const Vector3d edge = box.sizes().cwiseMax(1e-3);
    const Eigen::Array3d count = (edge.array() / cell - 1e-6).ceil().max(1.0);
    if (!(count.prod() <= kMostCells))
      throw std::runtime_error("more than 4 million cells; take a larger `cell`");
    count_ = count.cast<int>();
    edge_ = (edge.array() / count).matrix();
    solid_.assign(static_cast<std::size_t>(count_.prod()), false);
  }

  const Vector3d& edge() const noexcept { return edge_; }
  const Array3i& count() const noexcept { return count_; }
  Vector3d middle(const Array3i& at) const noexcept {
    return low_ + ((at.cast<double>() + 0.5) * edge_.array()).matrix();
  }
  Array3i cell_of(const Vector3d& point) const noexcept {
    const Eigen::Array3d at = ((point - low_).array() / edge_.array()).floor();
    return at.max(0.0).min((count_ - 1).cast<double>()).cast<int>();
  }
  bool solid(const Array3i& at) const noexcept { return solid_[index(at)]; }
  void fill(const Array3i& at) noexcept { solid_[index(at)] = true; }

  void fill_what_is_shut_in();
  std::vector<Obstacle> boxes();

 private:
  std::size_t index(const Array3i& at) const noexcept {
    return (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(count_.y()) +
            static_cast<std::size_t>(at.y())) *
               static_cast<std::size_t>(count_.x()) +
           static_cast<std::size_t>(at.x());
  }
  bool all_solid(const Array3i& from, const Array3i& to) const noexcept;

  Vector3d low_, edge_;
  Array3i count_;
  std::vector<bool> solid_;
};

// From every face of the whole inwards, through cells that are not solid.
void Cells::fill_what_is_shut_in() {
  std::vector<bool> open(solid_.size(), false);
  std::vector<Array3i> front;
  const auto reach = [&](const Array3i& at) {
    if ((at < 0).any() || (at >= count_).any() || solid(at) || open[index(at)]) return;
    open[index(at)] = true;
    front.push_back(at);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < count_[u]; ++i) {
      for (int j = 0; j < count_[v]; ++j) {
        Array3i at;
        at[u] = i;
        at[v] = j;
        for (const int end : {0, count_[axis] - 1}) {
          at[axis] = end;
          reach(at);
        }
      }
    }
  }
  while (!front.empty()) {
    const Array3i at = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int by : {-1, 1}) {
        Array3i next = at;
        next[axis] += by;
        reach(next);
      }
    }
  }
  for (std::size_t i = 0; i < solid_.size(); ++i) solid_[i] = !open[i];
}

bool Cells::all_solid(const Array3i& from, const Array3i& to) const noexcept {
  for (int z = from.z(); z < to.z(); ++z) {
    for (int y = from.y(); y < to.y(); ++y) {
      for (int x = from.x(); x < to.x(); ++x) {
        if (!solid({x, y, z})) return false;
      }
    }
  }
  return true;
}

// Each box begins at the first cell that no box has, and grows along x, then y, then z.
std::vector<Obstacle> Cells::boxes() {
  std::vector<Obstacle> boxes;
  for (int z = 0; z < count_.z(); ++z) {
    for (int y = 0; y < count_.y(); ++y) {
      for (int x = 0; x < count_.x(); ++x) {
        const Array3i from(x, y, z);
        if (!solid(from)) continue;
        Array3i to = from + 1;
        for (int axis = 0; axis < 3; ++axis) {
          for (; to[axis] < count_[axis]; ++to[axis]) {
            Array3i next_from = from, next_to = to;
            next_from[axis] = to[axis];
            next_to[axis] = to[axis] + 1;
            if (!all_solid(next_from, next_to)) break;
          }
        }
        for (int k = from.z(); k < to.z(); ++k) {
          for (int j = from.y(); j < to.y(); ++j) {
            for (int i = from.x(); i < to.x(); ++i) solid_[index({i, j, k})] = false;
          }
        }
        Obstacle& box = boxes.emplace_back();
        box.shape = ObstacleShape::kBox;
        box.size = (to - from).cast<double>() * edge_.array();
        box.pose = Eigen::Isometry3d::Identity();
        box.pose.translation() =
            low_ + (0.5 * (from + to).cast<double>() * edge_.array()).matrix();
      }
    }
  }
  return boxes;
}

// Whether a triangle, seen from the middle of a box, touches it.
bool touches(const std::array<Vector3d, 3>& corner, const Vector3d& half) noexcept {
  const auto apart = [&](const Vector3d& axis) {
    const double a = axis.dot(corner[0]), b = axis.dot(corner[1]), c = axis.dot(corner[2]);
    const double reach = half.dot(axis.cwiseAbs());
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
  };
  const std::array<Vector3d, 3> side{corner[1] - corner[0], corner[2] - corner[1],
                                     corner[0] - corner[2]};
  if (apart(side[0].cross(side[1]))) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d unit = Vector3d::Unit(axis);
    if (apart(unit)) return false;
    for (const Vector3d& edge : side) {
      if (apart(unit.cross(edge))) return false;
    }
  }
  return true;
}

// Calls with each line that holds something, and its number.
template <typename Take>
void each_line(const std::string& text, Take take) {
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string line = text.substr(from, end - from);
    from = end + 1;
    ++number;
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") != std::string::npos) take(line, number);
  }
}

[[noreturn]] void fail(const std::string& file, int line, const std::string& why) {
  throw std::runtime_error(file + ":" + std::to_string(line) + ": " + why);
}

// The numbers of a line, at most so many.
std::vector<double> numbers_of(const std::string& line, std::size_t most, const std::string& file,
                               int number) {
  std::vector<double> values;
  const char* at = line.c_str();
  while (values.size() < most) {
    at += std::strspn(at, " \t\r,;");
    if (*at == '\0') break;
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !(std::abs(value) <= kFarthest))
      fail(file, number, "what is there is no number within +-1000 m");
    values.push_back(value);
    at = end;
  }
  return values;
}

}  // namespace

std::vector<Obstacle> cover_mesh(const TriangleMesh& mesh, double cell) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : mesh.points) box.extend(point);
  Cells cells(box, cell);
  const Vector3d half = (0.5 + kTouch) * cells.edge();
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector3d, 3> corner;
    Eigen::AlignedBox3d around;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = mesh.points[static_cast<std::size_t>(triangle[i])];
      around.extend(corner[i]);
    }
    const Vector3d skin = kTouch * cells.edge();
    const Array3i first = cells.cell_of(around.min() - skin),
                  last = cells.cell_of(around.max() + skin);
    for (int z = first.z(); z <= last.z(); ++z) {
      for (int y = first.y(); y <= last.y(); ++y) {
        for (int x = first.x(); x <= last.x(); ++x) {
          const Vector3d middle = cells.middle({x, y, z});
          if (touches({corner[0] - middle, corner[1] - middle, corner[2] - middle}, half))
            cells.fill({x, y, z});
        }
      }
    }
  }
  cells.fill_what_is_shut_in();
  return cells.boxes();
}

std::vector<Obstacle> cover_points(const std::vector<Eigen::Vector3d>& points, double cell) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : points) box.extend(point);
  // Around every point some space is taken, too.
  const Vector3d margin = Vector3d::Constant(0.5 * cell);
  Cells cells({box.min() - margin, box.max() + margin}, cell);
  for (const Vector3d& point : points) cells.fill(cells.cell_of(point));
  return cells.boxes();
}

std::vector<Obstacle> cover_heights(const HeightMap& map, double cell) {
  const double top = *std::max_element(map.heights.begin(), map.heights.end());
  if (!(top > 0.0)) return {};
  const Vector3d size(map.spacing * (map.rows - 1), map.spacing * (map.columns - 1), top);
  Cells cells({Vector3d::Zero(), size}, std::min(cell, map.spacing));
  const auto height = [&](int row, int column) {
    return map.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                       static_cast<std::size_t>(column)];
  };
  for (int x = 0; x < cells.count().x(); ++x) {
    for (int y = 0; y < cells.count().y(); ++y) {
      // Of a bilinear surface no point is higher than the highest corner of its patches.
      const Vector3d middle = cells.middle({x, y, 0});
      const Eigen::Array2d half = (0.5 - kTouch) * cells.edge().head<2>().array();
      const Eigen::Array2i first =
          ((middle.head<2>().array() - half) / map.spacing).floor().cast<int>().max(0);
      const Eigen::Array2i last =
          ((middle.head<2>().array() + half) / map.spacing).ceil().cast<int>().min(
              Eigen::Array2i(map.rows - 1, map.columns - 1));
      double highest = 0.0;
      for (int row = first.x(); row <= last.x(); ++row) {
        for (int column = first.y(); column <= last.y(); ++column)
          highest = std::max(highest, height(row, column));
      }
      const int full = static_cast<int>(std::ceil(highest / cells.edge().z() - kTouch));
      for (int z = 0; z < std::min(full, cells.count().z()); ++z) cells.fill({x, y, z});
    }
  }
  return cells.boxes();
}

std::vector<Eigen::Vector3d> parse_points(const std::string& text, const std::string& file) {
  std::vector<Vector3d> points;
  each_line(text, [&](const std::string& line, int number) {
    const std::vector<double> values = numbers_of(line, 3, file, number);
    if (values.size() < 3) fail(file, number, "a point is three numbers: x y z [m]");
    if (3 * points.size() >= kMostNumbers) fail(file, number, "too many points");
    points.emplace_back(values[0], values[1], values[2]);
  });
  if (points.empty()) throw std::runtime_error(file + ": no point is in it");
  return points;
}

HeightMap parse_heights(const std::string& text, const std::string& file, double spacing) {
  HeightMap map;
  map.spacing = spacing;
  each_line(text, [&](const std::string& line, int number) {
    const std::vector<double> values = numbers_of(line, kMostNumbers, file, number);
    if (map.rows == 0) map.columns = static_cast<int>(values.size());
    if (static_cast<int>(values.size()) != map.columns)
      fail(file, number, "this row has " + std::to_string(values.size()) + " heights, the first " +
                             std::to_string(map.columns));
    if (!(*std::min_element(values.begin(), values.end()) >= 0.0))
      fail(file, number, "a height is below 0; the map stands on its own z = 0");
    if (map.heights.size() + values.size() > kMostNumbers) fail(file, number, "too many heights");
    map.heights.insert(map.heights.end(), values.begin(), values.end());
    ++map.rows;
  });
  if (map.rows < 2 || map.columns < 2)
    throw std::runtime_error(file + ": a height map has at least two rows of two heights");
  return map;
}

}  // namespace twinbus::sim
