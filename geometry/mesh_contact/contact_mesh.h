// A closed set of triangles as contacts ask about it: corners joined, neighbours known, boxes
// around eight triangles at a time.
//
// The paper's CollisionChecker has lost which triangle is whose neighbour and recovers it from its
// tree of boxes (section 3.3.1); here it is kept from the start.  Triangles must face outwards: a
// set whose volume is negative is turned over as a whole, one with mixed sides is not mended.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline geometry {

struct ContactFace {
  std::array<int, 3> vertex;
  std::array<int, 3> edge;  // from vertex k to vertex k + 1
  Eigen::Vector3d normal;   // unit, outwards
  double offset = 0.0;      // normal.dot(p) of its plane [m]
};

struct ContactEdge {
  int from = 0, to = 0;              // from < to
  std::array<int, 2> face{-1, -1};   // the second is -1 at a rim
  bool flat = false;                 // its two faces lie in one plane
  Eigen::Vector3d direction;         // unit
};

// The other end of an edge from a vertex.
struct ContactNeighbour {
  int vertex = 0, edge = 0;
};

// Boxes around eight triangles, and around them all.
struct FaceBoxes {
  static constexpr int kLanes = 8;
  alignas(32) std::array<std::array<float, kLanes>, 3> low, high;  // a free lane is inside out
  std::array<int, kLanes> face;
  int count = 0;
};

class ContactMesh {
 public:
  // Triangles without area are left out.  Throws std::runtime_error when none is left or a corner
  // is not finite or absurdly far away.
  explicit ContactMesh(const TriangleMesh& mesh);

  const std::vector<Eigen::Vector3d>& vertices() const noexcept { return vertices_; }
  const std::vector<ContactFace>& faces() const noexcept { return faces_; }
  const std::vector<ContactEdge>& edges() const noexcept { return edges_; }
  const std::vector<FaceBoxes>& clusters() const noexcept { return clusters_; }
  const ContactNeighbour* neighbours_begin(int vertex) const noexcept {
    return neighbours_.data() + first_[static_cast<std::size_t>(vertex)];
  }
  const ContactNeighbour* neighbours_end(int vertex) const noexcept {
    return neighbours_.data() + first_[static_cast<std::size_t>(vertex) + 1];
  }
  // Middle and half edges of the boxes around clusters, one axis after the other, padded to a
  // multiple of eight with boxes that meet nothing.
  const std::vector<float>& cluster_middle(int axis) const noexcept {
    return middle_[static_cast<std::size_t>(axis)];
  }
  const std::vector<float>& cluster_half(int axis) const noexcept {
    return half_[static_cast<std::size_t>(axis)];
  }
  const Eigen::AlignedBox3d& box() const noexcept { return box_; }
  bool closed() const noexcept { return closed_; }

  // Of the body inside: volume [m^3], middle [m], inertia about it for density 1 [kg m^2].
  double volume() const noexcept { return volume_; }
  const Eigen::Vector3d& middle() const noexcept { return centre_; }
  const Eigen::Matrix3d& inertia() const noexcept { return inertia_; }

  // Whether a point is inside, by the crossings of a ray.
  bool contains(const Eigen::Vector3d& point) const noexcept;

 private:
  void add_faces(const TriangleMesh& mesh);
  void add_edges();
  void add_clusters();
  void weigh() noexcept;

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<ContactFace> faces_;
  std::vector<ContactEdge> edges_;
  std::vector<int> first_;
  std::vector<ContactNeighbour> neighbours_;
  std::vector<FaceBoxes> clusters_;
  std::array<std::vector<float>, 3> middle_, half_;
  Eigen::AlignedBox3d box_;
  bool closed_ = true;
  double volume_ = 0.0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_ = Eigen::Matrix3d::Zero();
};

}  // namespace twinbus::geometry
