#include "robot/collision/links/inscribed_spheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/collision/links/geometry_cache.h"
#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr int kColumns = 12;        // of candidates along the longer edges of the link's box
constexpr double kSmallest = 1e-3;  // radius [m]
constexpr double kCornerRounding = 1e-6;  // of distances, corners being in single precision [m]
constexpr double kNewGround =
    0.75;  // a centre is at least so far out of the balls before, in radii

bool closed(const TriangleMesh& mesh) {
  std::vector<std::pair<int, int>> one_way, other_way;  // edges
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (a < b) one_way.emplace_back(a, b);
      if (b < a) other_way.emplace_back(b, a);
    }
  }
  std::sort(one_way.begin(), one_way.end());
  std::sort(other_way.begin(), other_way.end());
  return one_way == other_way;
}

double to_segment2(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d way = b - a;
  const double share = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-30), 0.0, 1.0);
  return (p - a - share * way).squaredNorm();
}

double to_triangle2(const Vector3d& p, const std::array<Vector3d, 3>& t) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  bool over = normal.squaredNorm() > 1e-24;  // its face, not an edge, is nearest
  for (std::size_t k = 0; over && k < 3; ++k)
    over = (t[(k + 1) % 3] - t[k]).cross(p - t[k]).dot(normal) >= 0.0;
  if (over) return std::pow((p - t[0]).dot(normal), 2) / normal.squaredNorm();
  return std::min(
      {to_segment2(p, t[0], t[1]), to_segment2(p, t[1], t[2]), to_segment2(p, t[2], t[0])});
}

Vector3d corner(const TriangleCluster& cluster, std::size_t k, int lane) {
  const auto number = [&](std::size_t d) {
    return static_cast<double>(cluster.corner[k][d][lane]);
  };
  return {number(0), number(1), number(2)};
}

// No triangle is nearer to p than this.
double clearance(const std::vector<TriangleCluster>& clusters, const Vector3d& p) {
  std::vector<std::pair<double, const TriangleCluster*>> order;  // by the nearest they can have
  for (const TriangleCluster& c : clusters) {
    const Vector3d center(static_cast<double>(c.center[0]), static_cast<double>(c.center[1]),
                          static_cast<double>(c.center[2]));
    order.emplace_back((p - center).norm() - static_cast<double>(c.radius), &c);
  }
  std::sort(order.begin(), order.end());
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const auto& [bound, c] : order) {
    if (bound > 0.0 && bound * bound > nearest2) break;
    for (int lane = 0; lane < c->count; ++lane) {
      nearest2 = std::min(nearest2, to_triangle2(p, {corner(*c, 0, lane), corner(*c, 1, lane),
                                                     corner(*c, 2, lane)}));
    }
  }
  return std::sqrt(nearest2) - kCornerRounding;
}

// Heights at which a line along z crosses the mesh.
std::vector<double> crossings(const TriangleMesh& mesh, double x, double y) {
  std::vector<double> heights;
  for (const auto& t : mesh.triangles) {
    double share[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d &a = mesh.points[at(t[(k + 1) % 3])], &b = mesh.points[at(t[(k + 2) % 3])];
      share[k] = (a.x() - x) * (b.y() - y) - (a.y() - y) * (b.x() - x);
    }
    const auto [least, most] = std::minmax({share[0], share[1], share[2]});
    if (least < 0.0 && most > 0.0) continue;
    const double sum = share[0] + share[1] + share[2];
    if (sum == 0.0) continue;
    double height = 0.0;
    for (std::size_t k = 0; k < 3; ++k) height += share[k] / sum * mesh.points[at(t[k])].z();
    heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

// Points of a grid that are inside, as far as one line each can say.
std::vector<Vector3d> grid_inside(const LinkGeometry& g) {
  const Vector3d size = g.high - g.low;
  const double step = size.maxCoeff() / kColumns;
  std::vector<Vector3d> points;
  const auto count = [&](int d) { return std::max(5, static_cast<int>(size[d] / step)); };
  const auto middle = [&](int d, int k) { return g.low[d] + size[d] * (k + 0.5) / count(d); };
  for (int i = 0; i < count(0); ++i) {
    for (int j = 0; j < count(1); ++j) {
      const double x = middle(0, i), y = middle(1, j);
      const std::vector<double> heights = crossings(g.mesh, x, y);
      for (int k = 0; k < count(2); ++k) {
        const double z = middle(2, k);
        const auto below = std::lower_bound(heights.begin(), heights.end(), z) - heights.begin();
        if (below % 2 != 0) points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

// How far the point is out of all balls.
double out_of(const std::vector<Ball>& balls, const Vector3d& point) {
  double out = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) out = std::min(out, (point - ball.center).norm() - ball.radius);
  return out;
}

}  // namespace

double winding_number(const TriangleMesh& mesh, const Vector3d& point) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vector3d a = mesh.points[at(t[0])] - point, b = mesh.points[at(t[1])] - point,
                   c = mesh.points[at(t[2])] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4.0 * kPi);
}

namespace {

std::vector<Ball> find_inner_balls(const LinkGeometry& g, int balls, int points) {
  std::vector<Ball> chosen;
  std::vector<Ball> candidates;
  for (const Vector3d& point : grid_inside(g)) {
    const double radius = clearance(g.clusters, point);
    if (radius > kSmallest) candidates.push_back({point, radius});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  for (const Ball& ball : candidates) {
    if (static_cast<int>(chosen.size()) >= balls) break;
    const auto covered = [&](const Ball& other) {
      return (ball.center - other.center).norm() < kNewGround * other.radius;
    };
    if (std::any_of(chosen.begin(), chosen.end(), covered)) continue;
    if (std::abs(winding_number(g.mesh, ball.center)) > 0.5) chosen.push_back(ball);
  }
  for (int k = 0; k < points; ++k) {  // the corner that sticks out most
    const Vector3d* most = &g.hull.points.front();
    for (const Vector3d& p : g.hull.points) {
      if (out_of(chosen, p) > out_of(chosen, *most)) most = &p;
    }
    if (!(out_of(chosen, *most) > 0.0)) break;
    chosen.push_back({*most, 0.0});
  }
  return chosen;
}

}  // namespace

// Nothing of the surface is in a ball, so balls that overlap are inside together, or outside.
bool are_inside(const LinkGeometry& g, const std::vector<Ball>& balls) {
  if (balls.empty()) return true;
  if (!closed(g.mesh)) return false;
  std::vector<const Ball*> known;
  for (const Ball& ball : balls) {
    if (ball.radius == 0.0) {
      if (std::find(g.hull.points.begin(), g.hull.points.end(), ball.center) == g.hull.points.end())
        return false;
      continue;
    }
    if (!(ball.radius > 0.0 && ball.radius <= clearance(g.clusters, ball.center))) return false;
    const bool beside = std::any_of(known.begin(), known.end(), [&](const Ball* other) {
      return (ball.center - other->center).norm() < ball.radius + other->radius;
    });
    if (!beside && !(std::abs(winding_number(g.mesh, ball.center)) > 0.5)) return false;
    known.push_back(&ball);
  }
  return true;
}

std::vector<Ball> inner_balls(const LinkGeometry& g, int balls, int points) {
  std::vector<Ball> chosen;
  if (g.mesh.triangles.empty() || recall_inner_balls(g, balls, points, chosen)) return chosen;
  if (closed(g.mesh)) chosen = find_inner_balls(g, balls, points);
  keep_inner_balls(g, balls, points, chosen);
  return chosen;
}

}  // namespace twinbus::robot
