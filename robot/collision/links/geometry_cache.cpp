#include "robot/collision/links/geometry_cache.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "geometry/bounds/bounds.h"
#include "geometry/bounds/coarse_mesh.h"
#include "geometry/bounds/convex_hull.h"
#include "common/file/disk_cache.h"
#include "common/math/index.h"
#include "robot/collision/links/inscribed_spheres.h"
#include "common/file/byte_pack.h"
#include "geometry/bounds/triangle_clusters.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

constexpr double kHullSlack = 3e-6;  // of the extent: what convex_hull itself allows

struct PlainBall {
  double center[3], radius;
};

PlainBall plain(const Ball& ball) {
  return {{ball.center.x(), ball.center.y(), ball.center.z()}, ball.radius};
}
Ball ball_of(const PlainBall& b) {
  return {Vector3d(b.center[0], b.center[1], b.center[2]), b.radius};
}
std::vector<PlainBall> plain(const std::vector<Ball>& balls) {
  std::vector<PlainBall> all;
  for (const Ball& ball : balls) all.push_back(plain(ball));
  return all;
}
std::vector<Ball> balls_of(const std::vector<PlainBall>& plain_ones) {
  std::vector<Ball> all;
  for (const PlainBall& ball : plain_ones) all.push_back(ball_of(ball));
  return all;
}

// As nearly as capsule_around makes sure of it.
bool holds(const Capsule& capsule, const std::vector<Vector3d>& points) {
  constexpr double kRounding = 1e-12;
  const Vector3d along = capsule.b - capsule.a;
  const double length2 = std::max(along.squaredNorm(), 1e-30);
  double most = 0.0;
  for (const Vector3d& p : points) {
    const double t = std::clamp((p - capsule.a).dot(along) / length2, 0.0, 1.0);
    if (!((p - capsule.a - t * along).norm() <= capsule.radius + kRounding)) return false;
    most = std::max(most, (p - points.front()).norm());
  }
  return capsule.radius <= most + 1.0;  // no more is ever needed
}

[[noreturn]] void wrong(const char* what) { throw std::runtime_error(what); }

std::vector<int> corners_in(const TriangleMesh& mesh, const TriangleMesh& hull) {
  std::vector<int> corners;
  for (const Vector3d& p : hull.points) {
    const auto at_point = std::find(mesh.points.begin(), mesh.points.end(), p);
    corners.push_back(static_cast<int>(at_point - mesh.points.begin()));
  }
  return corners;
}

// Closed, with every point of the mesh below every face.
TriangleMesh hull_of(const TriangleMesh& mesh, const std::vector<int>& corners,
                     std::vector<std::array<int, 3>> triangles) {
  TriangleMesh hull;
  for (const int c : corners) {
    if (c < 0 || at(c) >= mesh.points.size()) wrong("a corner of its hull is none of the mesh");
    hull.points.push_back(mesh.points[at(c)]);
  }
  if (triangles.size() < 4) wrong("its hull has no volume");
  const double slack = kHullSlack * box_around(mesh.points).sizes().norm();
  std::set<std::pair<int, int>> edges;
  std::vector<char> used(corners.size(), 0);
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] < 0 || at(t[k]) >= hull.points.size()) wrong("a face of its hull has no corner");
      used[at(t[k])] = 1;
      if (!edges.emplace(t[k], t[(k + 1) % 3]).second) wrong("its hull is folded");
    }
    const Vector3d& a = hull.points[at(t[0])];
    const Vector3d across = (hull.points[at(t[1])] - a).cross(hull.points[at(t[2])] - a);
    if (!(across.norm() > 0.0)) wrong("a face of its hull has no area");
    const Vector3d normal = across.normalized();
    const double offset = normal.dot(a) + slack;
    for (const Vector3d& p : mesh.points) {
      if (!(normal.dot(p) <= offset)) wrong("its hull does not hold the mesh");
    }
  }
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a})) wrong("its hull is open");
  }
  if (std::count(used.begin(), used.end(), 0) > 0) wrong("its hull has a corner without a face");
  hull.triangles = std::move(triangles);
  return hull;
}

std::vector<TriangleCluster> clusters_of(const TriangleMesh& mesh, const std::vector<int>& order,
                                         const std::vector<std::uint8_t>& sizes,
                                         const std::vector<PlainBall>& spheres) {
  if (order.size() != mesh.triangles.size() || sizes.size() != spheres.size())
    wrong("its clusters are of another mesh");
  std::vector<char> seen(order.size(), 0);
  for (const int t : order) {
    if (t < 0 || at(t) >= seen.size() || seen[at(t)]++ != 0)
      wrong("a triangle is not in one cluster");
  }
  std::vector<TriangleCluster> clusters;
  std::size_t next = 0;
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    const std::size_t count = sizes[c];
    if (count < 1 || count > TriangleCluster::kLanes || count > order.size() - next)
      wrong("a cluster has no triangle, or too many");
    const Ball sphere = ball_of(spheres[c]);
    clusters.push_back(
        triangle_cluster(mesh, order.data() + next, static_cast<int>(count), &sphere));
    next += count;
  }
  if (next != order.size()) wrong("a triangle is in no cluster");
  return clusters;
}

}  // namespace

FingerprintMaker fingerprint_of_code() {
  return FingerprintMaker().add(std::string_view(TWINBUS_GEOMETRY_CODE));
}

FingerprintMaker fingerprint_of(const TriangleMesh& mesh) {
  return fingerprint_of_code().add_all(mesh.points).add_all(mesh.triangles);
}

std::string packed_bounds(const LinkGeometry& g, const std::vector<int>& order) {
  std::vector<std::uint8_t> sizes;
  std::vector<PlainBall> spheres;
  for (const TriangleCluster& c : g.clusters) {
    sizes.push_back(static_cast<std::uint8_t>(c.count));
    PlainBall sphere{};
    for (int k = 0; k < 3; ++k) sphere.center[k] = static_cast<double>(c.center[k]);
    sphere.radius = static_cast<double>(c.radius);
    spheres.push_back(sphere);
  }
  Packer out;
  out.put_all(corners_in(g.mesh, g.hull)).put_all(g.hull.triangles);
  out.put(plain(g.sphere)).put(plain(Ball{g.capsule.a, g.capsule.radius}));
  out.put(plain(Ball{g.capsule.b, g.capsule.radius}));
  out.put_all(order).put_all(sizes).put_all(spheres);
  return out.bytes();
}

bool unpack_bounds(const std::string& bytes, LinkGeometry& link, std::string& why) {
  Unpacker in(bytes);
  const auto corners = in.get_all<int>();
  const auto faces = in.get_all<std::array<int, 3>>();
  const auto sphere = in.get<PlainBall>(), from = in.get<PlainBall>(), to = in.get<PlainBall>();
  const auto order = in.get_all<int>();
  const auto sizes = in.get_all<std::uint8_t>();
  const auto spheres = in.get_all<PlainBall>();
  if (!in.whole()) {
    why = "it has too little or too much in it";
    return false;
  }
  try {
    LinkGeometry g = link;
    g.hull = hull_of(g.mesh, corners, faces);
    g.sphere = ball_of(sphere);
    g.capsule = {ball_of(from).center, ball_of(to).center, from.radius};
    g.clusters = clusters_of(g.mesh, order, sizes, spheres);
    verify(g);
    link = std::move(g);
    return true;
  } catch (const std::runtime_error& error) {
    why = error.what();
    return false;
  }
}

bool recall_bounds(LinkGeometry& link) {
  if (disk_cache().folder().empty()) return false;
  const Fingerprint key = fingerprint_of(link.mesh).value();
  const std::optional<std::string> bytes = disk_cache().find("bounds", key);
  if (!bytes) return false;
  std::string why;
  if (unpack_bounds(*bytes, link, why)) return true;
  disk_cache().refuse("bounds", key, why);
  return false;
}

void keep_bounds(const LinkGeometry& link, const std::vector<int>& order) {
  if (disk_cache().folder().empty()) return;
  const std::string bytes = packed_bounds(link, order);
  // What would be refused (a hull without volume, or with slivers for faces) is found every time.
  LinkGeometry again = link;
  std::string why;
  if (unpack_bounds(bytes, again, why)) disk_cache().keep("bounds", fingerprint_of(link.mesh).value(), bytes);
}

bool recall_inner_balls(const LinkGeometry& link, int balls, int points, std::vector<Ball>& found) {
  if (disk_cache().folder().empty()) return false;
  const Fingerprint key = fingerprint_of(link.mesh).add(balls).add(points).value();
  const std::optional<std::string> bytes = disk_cache().find("inner", key);
  if (!bytes) return false;
  Unpacker in(*bytes);
  std::vector<Ball> kept = balls_of(in.get_all<PlainBall>());
  if (in.whole() && kept.size() <= at(balls + points) && are_inside(link, kept)) {
    found = std::move(kept);
    return true;
  }
  disk_cache().refuse("inner", key, "a ball is not inside the mesh");
  return false;
}

void keep_inner_balls(const LinkGeometry& link, int balls, int points,
                      const std::vector<Ball>& found) {
  if (disk_cache().folder().empty()) return;
  disk_cache().keep("inner", fingerprint_of(link.mesh).add(balls).add(points).value(),
                    Packer().put_all(plain(found)).bytes());
}

Capsule kept_capsule(const std::vector<Vector3d>& points) {
  if (disk_cache().folder().empty()) return capsule_around(points);
  const Fingerprint key = fingerprint_of_code().add_all(points).value();
  if (const std::optional<std::string> bytes = disk_cache().find("capsule", key)) {
    Unpacker in(*bytes);
    const auto from = in.get<PlainBall>(), to = in.get<PlainBall>();
    const Capsule capsule{ball_of(from).center, ball_of(to).center, from.radius};
    if (in.whole() && holds(capsule, points)) return capsule;
    disk_cache().refuse("capsule", key, "it does not hold its points");
  }
  const Capsule capsule = capsule_around(points);
  if (holds(capsule, points)) {
    Packer out;
    out.put(plain(Ball{capsule.a, capsule.radius})).put(plain(Ball{capsule.b, capsule.radius}));
    disk_cache().keep("capsule", key, out.bytes());
  }
  return capsule;
}

std::optional<TriangleMesh> kept_coarse_hull(const TriangleMesh& mesh) {
  // The corners are kept and their hull is found anew, so that it is the same bits whether it was known or not.
  const auto of_corners = [&](const std::vector<Vector3d>& corners) -> std::optional<TriangleMesh> {
    TriangleMesh hull = convex_hull(corners);
    if (!holds(hull, mesh.points)) return std::nullopt;
    return hull;
  };
  const bool keeps = !disk_cache().folder().empty() && mesh.triangles.size() > at(kFineTriangles);
  const Fingerprint key = keeps ? fingerprint_of(mesh).value() : Fingerprint{};
  if (const auto bytes = keeps ? disk_cache().find("coarse", key) : std::nullopt) {
    Unpacker in(*bytes);
    std::vector<Vector3d> corners;
    for (const PlainBall& corner : in.get_all<PlainBall>()) corners.push_back(ball_of(corner).center);
    const bool sound = in.whole() && corners.size() <= at(kMostCorners) &&
                       std::all_of(corners.begin(), corners.end(), [](const Vector3d& p) { return p.allFinite(); });
    if (auto hull = sound ? of_corners(corners) : std::nullopt) return hull;
    disk_cache().refuse("coarse", key, "its corners do not hold the mesh");
  }
  const std::optional<TriangleMesh> found = coarse_hull(mesh);
  const std::optional<TriangleMesh> hull = found ? of_corners(found->points) : std::nullopt;
  if (!keeps || !hull) return hull;
  std::vector<PlainBall> corners;
  for (const Vector3d& corner : found->points) corners.push_back(plain(Ball{corner, 0.0}));
  disk_cache().keep("coarse", key, Packer().put_all(corners).bytes());
  return hull;
}

}  // namespace twinbus::robot
