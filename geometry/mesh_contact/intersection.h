// Where two sets of triangles cross: every edge that goes through a face of the other set, and
// every corner that is inside of the other set.
//
// Together they are the corners of the body that both share.  The paper's CollisionChecker (section
// 3.3.1) finds crossing triangles with RAPID; here boxes around eight triangles go before, and an
// edge is tried once for both of its triangles, so that nothing is found twice.  Corners inside are
// reached from the edges that cross, from neighbour to neighbour, without crossing the other set.

#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh_contact/contact_mesh.h"

namespace twinbus::inline geometry {

// All points and directions are in B's axes.
struct CrossingPoint {
  enum Kind { kVertexA, kVertexB, kEdgeA, kEdgeB };
  Kind kind = kVertexA;
  int id = 0;       // of the vertex or edge
  int face = -1;    // of the other set, that the edge goes through
  int region = 0;   // points of one region are joined by a line of crossing or by corners inside
  Eigen::Vector3d point;
  Eigen::Vector3d normal;    // of that face, outwards
  Eigen::Vector3d leaves;    // along the edge, out of the other set
  bool sharp = false;        // the edge lies between two faces that differ
};

class Intersection {
 public:
  static constexpr int kMostEdges = 4096;  // that cross; further ones are left out, truncated()

  Intersection();
  // Makes room for this set; before it is asked about.
  void reserve(const ContactMesh& mesh);

  // False when nothing crosses.
  bool find(const ContactMesh& a, const ContactMesh& b, const Eigen::Isometry3d& a_in_b) noexcept;

  // In no order that means anything, but always in the same one.
  const std::vector<CrossingPoint>& points() const noexcept { return points_; }
  int regions() const noexcept { return regions_; }
  bool truncated() const noexcept { return truncated_; }

 private:
  // A triangle of A in B's axes.
  struct MovedFace {
    int face;
    std::array<Eigen::Vector3d, 3> corner;
    Eigen::Vector3d normal;
    double offset;
  };
  struct MovedCluster {
    FaceBoxes boxes;  // its faces are numbers of moved_
    std::array<float, 3> low, high;
  };
  struct NearCluster {
    int cluster;
    unsigned lanes;  // those near anything of A
  };
  struct Cut {
    double first = 0.0, last = 0.0;  // along the edge from 0 to 1
    bool from_inside = false, to_inside = false;
    int first_point = 0, last_point = 0;
  };
  // What is known of one of the sets in this search: where a stamp is the present one.
  struct Known {
    std::vector<int> vertex_stamp, edge_stamp;
    std::vector<char> inside;
    std::vector<int> region;
    std::vector<Cut> cut;
  };

  void collect() noexcept;
  void move_cluster(const FaceBoxes& cluster, const float* least, const float* most) noexcept;
  void cross_clusters() noexcept;
  void cross(const MovedFace& a, int face_b) noexcept;
  void add(CrossingPoint::Kind kind, int edge, double from_side, double to_side,
           const Eigen::Vector3d& from, const Eigen::Vector3d& to, int face,
           const Eigen::Vector3d& normal) noexcept;
  void cut(Known& known, int edge, double at, bool from_inside, int point) noexcept;
  void join_regions() noexcept;
  void join_pair(int face_a, int face_b, int point) noexcept;
  int root(int point) noexcept;
  void unite(int a, int b) noexcept;
  void find_inside(bool of_a) noexcept;
  void say(bool of_a, int vertex, bool inside, int region) noexcept;
  bool in_box(bool of_a, const Eigen::Vector3d& point) const noexcept;
  Eigen::Vector3d place(bool of_a, int vertex) const noexcept;

  const ContactMesh* a_ = nullptr;
  const ContactMesh* b_ = nullptr;
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
  float slack_ = 0.0F;
  int stamp_ = 0;
  Known known_a_, known_b_;
  std::vector<MovedFace> moved_;
  std::vector<MovedCluster> moved_clusters_;
  std::vector<NearCluster> near_;
  std::array<float, 3> span_low_{}, span_high_{};  // of all moved faces
  std::vector<CrossingPoint> points_;
  std::vector<int> parent_;
  struct PairSlot {
    std::uint64_t key = 0;
    int stamp = 0, point = 0;
  };
  std::vector<PairSlot> pairs_;
  std::vector<int> queue_;
  int edges_ = 0;  // of points_
  int regions_ = 0;
  bool truncated_ = false;
};

}  // namespace twinbus::geometry
