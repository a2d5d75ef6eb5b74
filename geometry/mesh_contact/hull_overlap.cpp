#include "geometry/mesh_contact/hull_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/math/index.h"

namespace twinbus::inline geometry {

namespace {

constexpr double kBeyondFace = 1e-6;          // of the size, a corner may lie beyond a face
constexpr double kParallel = 1e-3;      // sine of two edges that span no direction of their own
constexpr double kFaceFirst = 0.95;     // of a face's depth: only an edge's that is less is taken instead
constexpr std::size_t kMostEdges = 64;  // of each body in what overlaps
constexpr double kNoBound = std::numeric_limits<double>::infinity();

using Points = std::array<Eigen::Vector3d, HullOverlap::kMost>;

struct Body {
  const ContactMesh& mesh;
  Points at;  // its corners
  std::size_t count;
  Eigen::Isometry3d pose;

  Body(const ContactMesh& of, const Eigen::Isometry3d& where) noexcept
      : mesh(of), count(std::min(of.vertices().size(), HullOverlap::kMost)), pose(where) {
    for (std::size_t i = 0; i < count; ++i) at[i] = pose * of.vertices()[i];
  }
  double lowest(const Eigen::Vector3d& n) const noexcept {
    double low = kNoBound;
    for (std::size_t i = 0; i < count; ++i) low = std::min(low, n.dot(at[i]));
    return low;
  }
};

// An edge of what overlaps, and the normals of its faces.
struct Edge {
  Eigen::Vector3d from, along, left, right;
};

struct Edges {
  std::array<Edge, kMostEdges> edge;
  std::size_t count = 0;
};

// The least depth under a face of `of`; false: apart.  sign: of the face's normal as the way from B to A.
bool under_faces(const Body& of, const Body& other, double sign, HullOverlap& best) noexcept {
  for (const ContactFace& face : of.mesh.faces()) {
    const Eigen::Vector3d n = of.pose.linear() * face.normal;
    const double top = face.offset + n.dot(of.pose.translation());
    const double depth = top - other.lowest(n);
    if (!(depth < best.depth)) continue;
    best.depth = depth;
    best.normal = sign * n;
    if (!(depth > 0.0)) return false;
  }
  return true;
}

// Those that reach below `top` along n.
void gather(const Body& body, const Eigen::Vector3d& n, double top, Edges& edges) noexcept {
  for (const ContactEdge& edge : body.mesh.edges()) {
    if (edge.flat || edge.face[1] < 0 || edges.count >= kMostEdges) continue;
    if (at(edge.from) >= body.count || at(edge.to) >= body.count) continue;
    const Eigen::Vector3d &from = body.at[at(edge.from)], &to = body.at[at(edge.to)];
    if (!(std::min(n.dot(from), n.dot(to)) < top)) continue;
    const auto normal = [&](std::size_t side) -> Eigen::Vector3d {
      return body.pose.linear() * body.mesh.faces()[at(edge.face[side])].normal;
    };
    edges.edge[edges.count++] = {from, (to - from).normalized(), normal(0), normal(1)};
  }
}

// Whether the arcs between the normals of both edges cross, those of B turned round: then they build a face of the difference.
bool build_a_face(const Edge& a, const Edge& b) noexcept {
  const Eigen::Vector3d of_a = a.right.cross(a.left), of_b = b.right.cross(b.left);
  const double first = -b.left.dot(of_a), second = -b.right.dot(of_a), third = a.left.dot(of_b), fourth = a.right.dot(of_b);
  return first * second < 0.0 && third * fourth < 0.0 && first * fourth > 0.0;
}

void under_crossings(const Body& a, const Body& b, HullOverlap& best) noexcept {
  Edges of_a, of_b;
  const Eigen::Vector3d n = best.normal;
  const double low = a.lowest(n), high = -b.lowest(-n);
  gather(a, n, high, of_a);
  gather(b, -n, -low, of_b);
  double limit = kFaceFirst * best.depth;
  for (std::size_t i = 0; i < of_a.count; ++i) {
    const Edge& one = of_a.edge[i];
    for (std::size_t k = 0; k < of_b.count; ++k) {
      const Edge& other = of_b.edge[k];
      if (!build_a_face(one, other)) continue;
      Eigen::Vector3d out = one.along.cross(other.along);
      const double sine = out.norm();
      if (!(sine > kParallel)) continue;
      out *= (out.dot(one.left + one.right) < 0.0 ? -1.0 : 1.0) / sine;  // from A to B
      const double depth = out.dot(one.from - other.from);
      if (!(depth < limit)) continue;
      limit = depth;
      best.depth = depth;
      best.normal = -out;
    }
  }
}

}  // namespace

bool is_hull(const ContactMesh& mesh) {
  if (!mesh.closed() || mesh.vertices().size() > HullOverlap::kMost) return false;
  const double most = kBeyondFace * mesh.box().sizes().maxCoeff();
  return std::all_of(mesh.faces().begin(), mesh.faces().end(), [&](const ContactFace& face) {
    return std::all_of(mesh.vertices().begin(), mesh.vertices().end(),
                       [&](const Eigen::Vector3d& vertex) { return face.normal.dot(vertex) <= face.offset + most; });
  });
}

HullOverlap hull_overlap(const ContactMesh& a, const Eigen::Isometry3d& pose_a, const ContactMesh& b,
                         const Eigen::Isometry3d& pose_b) noexcept {
  const Body one(a, pose_a), other(b, pose_b);
  HullOverlap best;
  best.depth = kNoBound;
  if (under_faces(one, other, -1.0, best) && under_faces(other, one, 1.0, best)) under_crossings(one, other, best);
  return best;
}

}  // namespace twinbus::geometry
