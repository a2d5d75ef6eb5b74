#include "geometry/bounds/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "common/math/index.h"
#include "geometry/shapes.h"

namespace twinbus::inline geometry {

namespace {

using Eigen::Vector3d;

struct Face {
  std::array<int, 3> corner{};
  std::array<int, 3> neighbour{};  // behind the edge corner[k], corner[k + 1]
  Vector3d normal = Vector3d::Zero();
  double offset = 0.0;
  std::vector<int> outside;  // points
  bool alive = true;
};

// Products of three differences of 39 bits.
__extension__ typedef __int128 Wide;
constexpr double kGrid = 274877906944.0;  // 2^38
constexpr double kOutside = 5e-7;         // of the extent: a point may lie so far outside of a face

// The builder decides what is above what in floating point with a tolerance, which is fast and leaves
// out what is all but flat; or, on a grid, in whole numbers without any error, which always ends well.
class Builder {
 public:
  Builder(const std::vector<Vector3d>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}
  // On a grid of this many parts of the extent.
  Builder(const std::vector<Vector3d>& points, const Vector3d& low, double extent)
      : points_(points), tolerance_(1e-12 * extent), exact_(true) {
    for (const Vector3d& p : points) {
      std::array<std::int64_t, 3> whole{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        whole[k] = std::llround((p[i] - low[i]) / extent * kGrid);
      }
      whole_.push_back(whole);
    }
  }

  bool build() {
    if (!start()) return false;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      while (faces_[f].alive && !faces_[f].outside.empty()) {
        if (faces_.size() > 40 * points_.size() + 1000 || !take_in(static_cast<int>(f)))
          return false;
      }
    }
    return true;
  }

  TriangleMesh mesh() const {
    TriangleMesh result;
    std::map<int, int> seen;
    for (const Face& face : faces_) {
      if (!face.alive) continue;
      std::array<int, 3> t{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = seen.emplace(face.corner[k], static_cast<int>(result.points.size()));
        if (found.second) result.points.push_back(point(face.corner[k]));
        t[k] = found.first->second;
      }
      result.triangles.push_back(t);
    }
    return result;
  }

  // Points that follow one another are near one another in most meshes: a face looks at their boxes first.
  bool holds_all(double slack) const {
    constexpr std::size_t kInBox = 64;
    for (std::size_t first = 0; first < points_.size(); first += kInBox) {
      const std::size_t last = std::min(first + kInBox, points_.size());
      Eigen::AlignedBox3d box;
      for (std::size_t i = first; i < last; ++i) box.extend(points_[i]);
      const Vector3d middle = box.center(), half = 0.5 * box.sizes();
      for (const Face& face : faces_) {
        if (!face.alive || face.normal.dot(middle) + face.normal.cwiseAbs().dot(half) - face.offset <= slack) continue;
        for (std::size_t i = first; i < last; ++i) {
          if (!(face.normal.dot(points_[i]) - face.offset <= slack)) return false;
        }
      }
    }
    return true;
  }

 private:
  const Vector3d& point(int i) const { return points_[at(i)]; }
  Face& face(int i) { return faces_[at(i)]; }
  // Of exact ones only the sign is exact.
  double above(int f, int p) {
    const Face& of = face(f);
    if (!exact_) return of.normal.dot(point(p)) - of.offset;
    const auto between = [&](int to, std::size_t k) -> Wide {
      return whole_[at(to)][k] - whole_[at(of.corner[0])][k];
    };
    const auto minor = [&](std::size_t k, std::size_t l) {
      return between(of.corner[1], k) * between(of.corner[2], l) -
             between(of.corner[1], l) * between(of.corner[2], k);
    };
    return static_cast<double>(minor(1, 2) * between(p, 0) + minor(2, 0) * between(p, 1) +
                               minor(0, 1) * between(p, 2));
  }
  bool sees(int f, int p) { return above(f, p) > (exact_ ? 0.0 : 0.1 * tolerance_); }

  int add_face(int a, int b, int c) {
    Face f;
    f.corner = {a, b, c};
    f.normal = (point(b) - point(a)).cross(point(c) - point(a)).normalized();
    f.offset = f.normal.dot((point(a) + point(b) + point(c)) / 3.0);
    faces_.push_back(std::move(f));
    return static_cast<int>(faces_.size()) - 1;
  }

  template <class Measure>
  int farthest(Measure measure, double least) const {
    int best = -1;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      const double d = measure(point(i));
      if (d > least) {
        least = d;
        best = i;
      }
    }
    return best;
  }

  bool start() {
    const double least = 100.0 * tolerance_;
    const int a = farthest([](const Vector3d& p) { return p.x() + 1e3; }, -1e300);
    const int b = farthest([&](const Vector3d& p) { return (p - point(a)).norm(); }, least);
    if (b < 0) return false;
    const Vector3d along = (point(b) - point(a)).normalized();
    const int c =
        farthest([&](const Vector3d& p) { return along.cross(p - point(a)).norm(); }, least);
    if (c < 0) return false;
    const Vector3d normal = along.cross(point(c) - point(a)).normalized();
    const int d =
        farthest([&](const Vector3d& p) { return std::abs(normal.dot(p - point(a))); }, least);
    if (d < 0) return false;
    const bool below = normal.dot(point(d) - point(a)) < 0.0;
    const int u = below ? b : c, v = below ? c : b;  // a u v faces away from d
    add_face(a, u, v);
    if (exact_ && !(above(0, d) < 0.0)) return false;
    add_face(a, d, u);
    add_face(u, d, v);
    add_face(v, d, a);
    face(0).neighbour = {1, 2, 3};
    face(1).neighbour = {3, 2, 0};
    face(2).neighbour = {1, 3, 0};
    face(3).neighbour = {2, 1, 0};
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) all.push_back(i);
    share_out(all, 0);
    return true;
  }

  void share_out(const std::vector<int>& points, int first_face) {
    for (const int p : points) {
      int best = -1;
      double most = exact_ ? 0.0 : tolerance_;
      for (int f = first_face; f < static_cast<int>(faces_.size()); ++f) {
        const double d = above(f, p);
        if (d > most) {
          most = d;
          best = f;
        }
      }
      if (best >= 0) face(best).outside.push_back(p);
    }
  }

  // Takes the farthest point outside of face f into the hull.
  bool take_in(int f) {
    const std::vector<int>& candidates = face(f).outside;
    const int p = *std::max_element(candidates.begin(), candidates.end(),
                                    [&](int i, int j) { return above(f, i) < above(f, j); });
    // The faces that see the point, and the edges around them.
    std::vector<int> visible{f};
    struct Edge {
      int from, to, beyond;
    };
    std::vector<Edge> horizon;
    face(f).alive = false;
    for (std::size_t k = 0; k < visible.size(); ++k) {
      const Face seen = face(visible[k]);
      for (std::size_t e = 0; e < 3; ++e) {
        const int next = seen.neighbour[e];
        if (!face(next).alive) continue;
        if (sees(next, p)) {
          face(next).alive = false;
          visible.push_back(next);
        }
      }
    }
    for (const int v : visible) {
      for (std::size_t e = 0; e < 3; ++e) {
        const int next = face(v).neighbour[e];
        if (face(next).alive)
          horizon.push_back({face(v).corner[e], face(v).corner[(e + 1) % 3], next});
      }
    }
    if (horizon.size() < 3) return false;
    const int first = static_cast<int>(faces_.size());
    std::map<int, int> starting, ending;  // new faces by the corner their edge starts, ends at
    for (const Edge& edge : horizon) {
      const int made = add_face(edge.from, edge.to, p);
      if (!starting.emplace(edge.from, made).second || !ending.emplace(edge.to, made).second)
        return false;
      face(made).neighbour[0] = edge.beyond;
      Face& beyond = face(edge.beyond);
      for (std::size_t e = 0; e < 3; ++e) {
        if (beyond.corner[e] == edge.to && beyond.corner[(e + 1) % 3] == edge.from)
          beyond.neighbour[e] = made;
      }
    }
    for (const Edge& edge : horizon) {
      const int made = starting[edge.from];
      const auto after = starting.find(edge.to);
      const auto before = ending.find(edge.from);
      if (after == starting.end() || before == ending.end()) return false;
      face(made).neighbour[1] = after->second;
      face(made).neighbour[2] = before->second;
    }
    std::vector<int> orphans;
    for (const int v : visible) {
      for (const int q : face(v).outside) {
        if (q != p) orphans.push_back(q);
      }
      face(v).outside.clear();
    }
    share_out(orphans, first);
    return true;
  }

  const std::vector<Vector3d>& points_;
  double tolerance_;
  bool exact_ = false;
  std::vector<std::array<std::int64_t, 3>> whole_;
  std::vector<Face> faces_;
};

}  // namespace

TriangleMesh convex_hull(const std::vector<Vector3d>& points) {
  TriangleMesh all;
  all.points = points;
  if (points.empty()) return all;
  const Eigen::AlignedBox3d box = box_around(points);
  const double extent = box.sizes().norm();
  // What rounding leaves undecided at one tolerance, a coarser one decides.
  for (const double tolerance : {1e-9, 1e-8, 1e-7, 1e-6}) {
    Builder builder(points, tolerance * extent);
    if (builder.build() && builder.holds_all(std::min(3.0 * tolerance, kOutside) * extent)) return builder.mesh();
  }
  Builder exact(points, box.min(), extent);
  if (extent > 0.0 && exact.build()) return exact.mesh();
  return all;
}

}  // namespace twinbus::geometry
