#include "geometry/distance/support_cells.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "common/math/index.h"

namespace twinbus::inline geometry {

namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double kNoMore = 1e-12;  // ahead of all others is as good as behind [m]

constexpr int kQuadrants = 24;  // cells of which halves are not asked

struct Range {
  double from = 0.0, to = 1.0;
};

// Directions with the largest coordinate one, of which the cell is the hull; how large the one after it is, and the
// one before.
std::array<Vector3d, 4> edges_of(int quadrant, Range after, Range before) {
  const int axis = quadrant / 8;
  const Vector3d sign((quadrant & 1) != 0 ? -1.0 : 1.0, (quadrant & 2) != 0 ? -1.0 : 1.0,
                      (quadrant & 4) != 0 ? -1.0 : 1.0);
  const Vector3d x = sign[axis] * Vector3d::Unit(axis);
  const Vector3d y = sign[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
  const Vector3d z = sign[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
  return {x + after.from * y + before.from * z, x + after.to * y + before.from * z,
          x + after.to * y + before.to * z, x + after.from * y + before.to * z};
}

// What of the polygon is on the side of the plane where n . d >= kNoMore.
void cut(Points& polygon, const Vector3d& n, Points& room) {
  room.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3d& p = polygon[k];
    const Vector3d& q = polygon[(k + 1) % polygon.size()];
    const double here = n.dot(p) - kNoMore, there = n.dot(q) - kNoMore;
    if (here >= 0.0) room.push_back(p);
    if ((here < 0.0) != (there < 0.0)) room.push_back(p + here / (here - there) * (q - p));
  }
  polygon.swap(room);
}

std::size_t farthest(const Points& points, const Vector3d& d) {
  return static_cast<std::size_t>(
      std::max_element(points.begin(), points.end(),
                       [&](const Vector3d& p, const Vector3d& q) { return p.dot(d) < q.dot(d); }) -
      points.begin());
}

Points points_of(const std::array<Vector3d, 4>& edges, const Points& points) {
  // Those that are farthest along the edges leave little to the others, so they cut first.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 0; k < edges.size() && k < order.size(); ++k) {
    const std::size_t first = farthest(points, edges[k]);
    std::swap(order[k], *std::find(order.begin(), order.end(), first));
  }
  Points result, polygon, room;
  for (std::size_t k = order.size(); k-- > 0;) {
    polygon.assign(edges.begin(), edges.end());
    for (std::size_t other = 0; other < order.size() && !polygon.empty(); ++other) {
      if (other != k) cut(polygon, points[order[k]] - points[order[other]], room);
    }
    // What goes cuts no other, so of points in one place one stays.
    if (polygon.empty()) order.erase(order.begin() + static_cast<std::ptrdiff_t>(k));
  }
  for (const std::size_t k : order) result.push_back(points[k]);
  return result;
}

}  // namespace

SupportCells support_cells(const Points& points) {
  std::array<Points, kSupportCells> of_cell;
  for (int q = 0; q < kQuadrants; ++q) {
    const Points quadrant = points_of(edges_of(q, {}, {}), points);
    for (int half = 0; half < 4; ++half) {
      const Range small{0.0, 0.5}, large{0.5, 1.0};
      Points& few = of_cell[at(q + kQuadrants * half)];
      few = points_of(edges_of(q, (half & 1) != 0 ? large : small, (half & 2) != 0 ? large : small),
                      quadrant);
    }
  }
  SupportCells cells;
  for (int cell = 0; cell < kSupportCells; ++cell) {
    const Points& few = of_cell[at(cell)];
    for (int d = 0; d < 3; ++d) {
      for (std::size_t k = 0; k < few.size(); k += 8) {
        SupportCells::Eight& eight = cells.numbers.emplace_back();
        for (std::size_t i = 0; i < 8; ++i)
          eight.number[i] = few[std::min(k + i, few.size() - 1)][d];
      }
    }
    cells.begin[at(cell) + 1] = static_cast<std::uint32_t>(cells.numbers.size());
  }
  return cells;
}

}  // namespace twinbus::geometry
