#include "test/oracles/sphere_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/bounds/bounds.h"
#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus {

namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr int kDirections = 200;           // the hull is looked at from
constexpr std::size_t kMostPieces = 5000;  // of one triangle when it is proved
constexpr double kInside = 1e-9;           // rounding of the proof [m]
constexpr double kGrowth = 3e-6;           // balls are larger than their welded pieces by this [m]
constexpr int kRounds = 8;                 // of giving pieces to the ball that suits them

struct Hull {
  std::vector<Vector3d> directions;
  std::vector<double> extent;  // of the hull along each
};

Hull look_at(const std::vector<Vector3d>& points) {
  Hull hull;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
    const double turn = kPi * (1.0 + std::sqrt(5.0)) * i;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3d n(r * std::cos(turn), r * std::sin(turn), z);
    double extent = -1e300;
    for (const Vector3d& p : points) extent = std::max(extent, n.dot(p));
    hull.directions.push_back(n);
    hull.extent.push_back(extent);
  }
  return hull;
}

double excess(const Hull& hull, const Ball& ball) {
  double most = -1e300;
  for (std::size_t i = 0; i < hull.extent.size(); ++i)
    most = std::max(most, hull.directions[i].dot(ball.center) - hull.extent[i]);
  return most + ball.radius;
}

using Triangle = std::array<Vector3d, 3>;

// The two halves of a triangle, cut at the middle of its longest edge.
std::array<Triangle, 2> halves(const Triangle& t) {
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = (t[(k + 1) % 3] - t[k]).squaredNorm();
    if (length > most) {
      most = length;
      longest = k;
    }
  }
  const Vector3d& a = t[longest];
  const Vector3d& b = t[(longest + 1) % 3];
  const Vector3d& c = t[(longest + 2) % 3];
  const Vector3d middle = 0.5 * (a + b);
  return {Triangle{a, middle, c}, Triangle{middle, b, c}};
}

double longest_edge(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

void cut(const Triangle& t, double edge, std::vector<Triangle>& pieces) {
  if (longest_edge(t) <= edge) {
    pieces.push_back(t);
    return;
  }
  for (const Triangle& half : halves(t)) cut(half, edge, pieces);
}

Triangle corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]};
}

bool inside(const Ball& ball, const Triangle& t) {
  const double r = ball.radius - kInside;
  for (const Vector3d& p : t) {
    if (!((p - ball.center).squaredNorm() <= r * r)) return false;
  }
  return r > 0.0;
}

// Breadth first, so that a hole is met before the seams between balls are cut ever finer.
bool covered(const std::vector<Ball>& balls, const Triangle& whole) {
  std::vector<Triangle> open{whole};
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Triangle t = open[i];
    if (std::any_of(balls.begin(), balls.end(), [&](const Ball& b) { return inside(b, t); }))
      continue;
    for (const Vector3d& p : t) {
      if (std::none_of(balls.begin(), balls.end(), [&](const Ball& ball) {
            return (p - ball.center).norm() <= ball.radius - kInside;
          }))
        return false;
    }
    if (open.size() > kMostPieces) return false;
    for (const Triangle& half : halves(t)) open.push_back(half);
  }
  return true;
}

class Cover {
 public:
  Cover(TriangleMesh pieces, Hull hull)
      : pieces_(std::move(pieces)), hull_(std::move(hull)), seen_(pieces_.points.size(), 0) {}

  std::vector<Ball> balls(double wanted, int most) {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(pieces_.triangles.size()); ++i) all.push_back(i);
    groups_ = {all};
    balls_ = {fit(all)};
    while (static_cast<int>(balls_.size()) < most) {
      const std::size_t worst = worst_ball();
      if (excess(hull_, balls_[worst]) <= wanted || !split(worst)) break;
      if (balls_.size() % 4 == 0) share_again();
    }
    for (int round = 0; round < kRounds; ++round) share_again();
    std::vector<Ball> result = balls_;
    for (Ball& ball : result) ball.radius += kGrowth;
    return result;
  }

 private:
  // A ball around the pieces; its centre goes where it sticks out of the hull least.
  Ball fit(const std::vector<int>& group) {
    std::vector<Vector3d> points;
    ++stamp_;
    for (const int i : group) {
      for (const int p : pieces_.triangles[at(i)]) {
        if (seen_[at(p)] == stamp_) continue;
        seen_[at(p)] = stamp_;
        points.push_back(pieces_.points[at(p)]);
      }
    }
    Ball best = ball_around(points, 100);
    double least = excess(hull_, best);
    double step = 0.3 * best.radius;
    while (step > 1e-3 * best.radius) {
      bool better = false;
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {step, -step}) {
          Ball tried = best;
          tried.center[axis] += sign;
          tried.radius = 0.0;
          for (const Vector3d& p : points)
            tried.radius = std::max(tried.radius, (p - tried.center).squaredNorm());
          tried.radius = std::sqrt(tried.radius);
          const double value = excess(hull_, tried);
          if (!(value < least)) continue;
          least = value;
          best = tried;
          better = true;
        }
      }
      if (!better) step *= 0.5;
    }
    return best;
  }

  std::size_t worst_ball() const {
    std::size_t worst = 0;
    double most = -1e300;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const double value = groups_[i].size() > 1 ? excess(hull_, balls_[i]) : -1e299;
      if (value > most) {
        most = value;
        worst = i;
      }
    }
    return worst;
  }

  Vector3d middle(int piece) const {
    const Triangle t = corners(pieces_, pieces_.triangles[at(piece)]);
    return (t[0] + t[1] + t[2]) / 3.0;
  }

  bool split(std::size_t which) {
    std::vector<int> group = groups_[which];
    if (group.size() < 2) return false;
    double least = 1e300;
    Ball first, second;
    std::vector<int> left, right;
    for (int axis = 0; axis < 3; ++axis) {
      double low = 1e300, high = -1e300;
      for (const int i : group) {
        low = std::min(low, middle(i)[axis]);
        high = std::max(high, middle(i)[axis]);
      }
      std::vector<int> a, b;
      for (const int i : group) (middle(i)[axis] < 0.5 * (low + high) ? a : b).push_back(i);
      if (a.empty() || b.empty()) continue;
      const Ball ball_a = fit(a), ball_b = fit(b);
      const double value = std::max(excess(hull_, ball_a), excess(hull_, ball_b));
      if (!(value < least)) continue;
      least = value;
      first = ball_a;
      second = ball_b;
      left = a;
      right = b;
    }
    if (left.empty()) return false;
    balls_[which] = first;
    groups_[which] = left;
    balls_.push_back(second);
    groups_.push_back(right);
    return true;
  }

  // Every piece goes to the ball it is deepest in; kept when the worst ball gets better.
  void share_again() {
    std::vector<std::vector<int>> groups(balls_.size());
    for (int i = 0; i < static_cast<int>(pieces_.triangles.size()); ++i) {
      std::size_t best = 0;
      double least = 1e300;
      for (std::size_t b = 0; b < balls_.size(); ++b) {
        double far = 0.0;
        for (const Vector3d& p : corners(pieces_, pieces_.triangles[at(i)]))
          far = std::max(far, (p - balls_[b].center).squaredNorm());
        const double power = far - balls_[b].radius * balls_[b].radius;
        if (power < least) {
          least = power;
          best = b;
        }
      }
      groups[best].push_back(i);
    }
    std::vector<Ball> balls;
    std::vector<std::vector<int>> kept;
    double now = 0.0, before = 0.0;
    for (const auto& group : groups) {
      if (group.empty()) continue;
      balls.push_back(fit(group));
      kept.push_back(group);
      now = std::max(now, excess(hull_, balls.back()));
    }
    for (const Ball& ball : balls_) before = std::max(before, excess(hull_, ball));
    if (now > before || (now == before && balls.size() == balls_.size())) return;
    balls_ = std::move(balls);
    groups_ = std::move(kept);
  }

  TriangleMesh pieces_;
  Hull hull_;
  std::vector<int> seen_;  // per point: the fit that has taken it
  int stamp_ = 0;
  std::vector<std::vector<int>> groups_;
  std::vector<Ball> balls_;
};

}  // namespace

std::vector<Ball> cover_with_balls(const TriangleMesh& mesh, const TriangleMesh& hull,
                                   double excess_wanted, int most) {
  if (mesh.triangles.empty() || most < 1) return {};
  Vector3d low = mesh.points.front(), high = low;
  for (const Vector3d& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Small enough for a good fit, and not too many of them.
  double edge = std::max((high - low).norm() / 16.0, 1e-4);
  std::vector<Triangle> pieces;
  for (const auto& t : mesh.triangles) cut(corners(mesh, t), edge, pieces);
  TriangleMesh tiled;
  for (const Triangle& t : pieces) {
    const int first = static_cast<int>(tiled.points.size());
    tiled.points.insert(tiled.points.end(), t.begin(), t.end());
    tiled.triangles.push_back({first, first + 1, first + 2});
  }
  std::vector<Ball> balls = Cover(welded(tiled), look_at(hull.points)).balls(excess_wanted, most);
  // What the others hold as well is left out.
  for (std::size_t i = balls.size(); i-- > 0;) {
    std::vector<Ball> fewer = balls;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (covers(fewer, mesh)) balls = std::move(fewer);
  }
  return balls;
}

bool covers(const std::vector<Ball>& balls, const TriangleMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return covered(balls, corners(mesh, t)); });
}

double excess_over_hull(const std::vector<Ball>& balls, const TriangleMesh& hull) {
  const Hull seen = look_at(hull.points);
  double most = 0.0;
  for (const Ball& ball : balls) most = std::max(most, excess(seen, ball));
  return most;
}

}  // namespace twinbus
