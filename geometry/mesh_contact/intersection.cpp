#include "geometry/mesh_contact/intersection.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/math/index.h"
#include "geometry/mesh_contact/box_lanes.h"

namespace twinbus::inline geometry {

namespace {

using box_lanes::all;
using box_lanes::bits;
using box_lanes::F8;
using box_lanes::I8;
using box_lanes::load8;
using box_lanes::meeting;

constexpr float kRounding = 2e-6F;  // of the coordinates, what single precision may lose
constexpr std::size_t kPairSlots = 4 * Intersection::kMostEdges;

// A box in the axes of a set that is turned and shifted.
struct Turned {
  float rotation[3][3], size[3][3], shift[3], low[3], high[3];
};

struct ClusterBoxes {
  explicit ClusterBoxes(const ContactMesh& mesh) : count(mesh.cluster_middle(0).size()) {
    for (int d = 0; d < 3; ++d) {
      middle[d] = mesh.cluster_middle(d).data();
      half[d] = mesh.cluster_half(d).data();
    }
  }
  // Which of eight, once turned, meet it.
  TWINBUS_INLINE unsigned meeting(std::size_t first, const Turned& t) const noexcept {
    I8 apart{};
    const F8 x = load8(middle[0] + first), y = load8(middle[1] + first),
             z = load8(middle[2] + first);
    const F8 hx = load8(half[0] + first), hy = load8(half[1] + first), hz = load8(half[2] + first);
    for (int d = 0; d < 3; ++d) {
      const F8 at = x * t.rotation[d][0] + y * t.rotation[d][1] + z * t.rotation[d][2] + t.shift[d];
      const F8 reach = hx * t.size[d][0] + hy * t.size[d][1] + hz * t.size[d][2];
      apart |= (at - reach > all(t.high[d])) | (at + reach < all(t.low[d]));
    }
    return ~bits(apart) & 0xFFU;
  }
  std::size_t count;
  const float* middle[3];
  const float* half[3];
};

// Six times the volume between an edge from p and one from u to v.  From v to u it is the same number
// with the other sign, to the last bit, as nothing is fused: both faces beside an edge see one truth.
TWINBUS_INLINE double volume(const Eigen::Vector3d& along, const Eigen::Vector3d& u,
                             const Eigen::Vector3d& v) noexcept {
  return along.x() * (u.y() * v.z() - u.z() * v.y()) + along.y() * (u.z() * v.x() - u.x() * v.z()) +
         along.z() * (u.x() * v.y() - u.y() * v.x());
}

// Whether the edge goes through the triangle, once its ends are on two sides of the plane.
TWINBUS_INLINE bool goes_through(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 const std::array<Eigen::Vector3d, 3>& corner) noexcept {
  const Eigen::Vector3d along = to - from;
  const Eigen::Vector3d u = corner[0] - from, v = corner[1] - from;
  const double x = volume(along, u, v);
  const Eigen::Vector3d w = corner[2] - from;
  const double y = volume(along, v, w);
  if (x * y < 0.0) return false;
  const double z = volume(along, w, u);
  if (x * z < 0.0 || y * z < 0.0) return false;
  return x != 0.0 || y != 0.0 || z != 0.0;
}

}  // namespace

Intersection::Intersection() {
  points_.reserve(kMostEdges);
  parent_.reserve(kMostEdges);
  pairs_.resize(kPairSlots);
}

void Intersection::reserve(const ContactMesh& mesh) {
  for (Known* known : {&known_a_, &known_b_}) {
    if (known->vertex_stamp.size() < mesh.vertices().size()) {
      known->vertex_stamp.resize(mesh.vertices().size(), 0);
      known->inside.resize(mesh.vertices().size(), 0);
      known->region.resize(mesh.vertices().size(), 0);
    }
    if (known->edge_stamp.size() < mesh.edges().size()) {
      known->edge_stamp.resize(mesh.edges().size(), 0);
      known->cut.resize(mesh.edges().size());
    }
  }
  moved_.reserve(std::max(moved_.capacity(), mesh.faces().size()));
  moved_clusters_.reserve(std::max(moved_clusters_.capacity(), mesh.clusters().size()));
  near_.reserve(std::max(near_.capacity(), mesh.clusters().size()));
  queue_.reserve(std::max(queue_.capacity(), mesh.vertices().size()));
  points_.reserve(kMostEdges + 2 * queue_.capacity());
}

bool Intersection::find(const ContactMesh& a, const ContactMesh& b,
                        const Eigen::Isometry3d& a_in_b) noexcept {
  a_ = &a;
  b_ = &b;
  rotation_ = a_in_b.linear();
  shift_ = a_in_b.translation();
  points_.clear();
  edges_ = regions_ = 0;
  truncated_ = false;
  if (!a_in_b.matrix().allFinite()) return false;
  ++stamp_;
  collect();
  if (moved_.empty()) return false;
  cross_clusters();
  edges_ = static_cast<int>(points_.size());
  if (edges_ == 0) return false;
  join_regions();
  find_inside(true);
  find_inside(false);
  for (CrossingPoint& point : points_) {
    point.region = root(point.region);
  }
  // Regions get numbers from 0 on: those of roots are below zero until they have one.
  for (int i = 0; i < edges_; ++i) {
    if (parent_[at(i)] == i) parent_[at(i)] = -1 - regions_++;
  }
  for (CrossingPoint& point : points_) point.region = -1 - parent_[at(point.region)];
  return true;
}

// The triangles that may meet something of the other set: B's clusters near A's box, then A's near
// those, in B's axes, then of B's triangles those near what is left of A.
TWINBUS_AVX2_CLONES void Intersection::collect() noexcept {
  moved_.clear();
  moved_clusters_.clear();
  near_.clear();
  const auto largest = [](const Eigen::AlignedBox3d& box) {
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  };
  slack_ = kRounding * static_cast<float>(largest(a_->box()) + largest(b_->box()) +
                                          shift_.cwiseAbs().maxCoeff());
  Turned still{}, turned{};
  const Eigen::Vector3d middle = rotation_ * a_->box().center() + shift_;
  const Eigen::Vector3d half = rotation_.cwiseAbs() * (0.5 * a_->box().sizes());
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < 3; ++k) {
      turned.rotation[d][k] = static_cast<float>(rotation_(d, k));
      turned.size[d][k] = std::abs(turned.rotation[d][k]);
    }
    turned.shift[d] = static_cast<float>(shift_[d]);
    still.rotation[d][d] = still.size[d][d] = 1.0F;
    still.low[d] = static_cast<float>(middle[d] - half[d]) - slack_;
    still.high[d] = static_cast<float>(middle[d] + half[d]) + slack_;
    turned.low[d] = span_low_[at(d)] = 1e30F;
    turned.high[d] = span_high_[at(d)] = -1e30F;
  }
  const ClusterBoxes boxes_a(*a_), boxes_b(*b_);
  for (std::size_t first = 0; first < boxes_b.count; first += 8) {
    for (unsigned m = boxes_b.meeting(first, still); m != 0; m &= m - 1) {
      const std::size_t cluster = first + static_cast<unsigned>(std::countr_zero(m));
      near_.push_back({static_cast<int>(cluster), 0});
      for (std::size_t d = 0; d < 3; ++d) {
        const float at = boxes_b.middle[d][cluster], reach = boxes_b.half[d][cluster] + slack_;
        turned.low[d] = std::min(turned.low[d], at - reach);
        turned.high[d] = std::max(turned.high[d], at + reach);
      }
    }
  }
  if (near_.empty()) return;
  for (std::size_t first = 0; first < boxes_a.count; first += 8) {
    for (unsigned m = boxes_a.meeting(first, turned); m != 0; m &= m - 1) {
      move_cluster(a_->clusters()[first + static_cast<unsigned>(std::countr_zero(m))], turned.low,
                   turned.high);
    }
  }
  for (NearCluster& near : near_) {
    near.lanes = meeting(b_->clusters()[at(near.cluster)], span_low_.data(), span_high_.data());
  }
  std::erase_if(near_, [](const NearCluster& near) { return near.lanes == 0; });
}

void Intersection::move_cluster(const FaceBoxes& cluster, const float* least,
                                const float* most) noexcept {
  MovedCluster moved;
  for (std::size_t d = 0; d < 3; ++d) {
    moved.boxes.low[d].fill(1e30F);
    moved.boxes.high[d].fill(-1e30F);
    moved.low[d] = 1e30F;
    moved.high[d] = -1e30F;
  }
  moved.boxes.face.fill(-1);
  for (int lane = 0; lane < cluster.count; ++lane) {
    const ContactFace& face = a_->faces()[at(cluster.face[at(lane)])];
    MovedFace own;
    for (std::size_t k = 0; k < 3; ++k) {
      own.corner[k] = rotation_ * a_->vertices()[at(face.vertex[k])] + shift_;
    }
    const Eigen::Vector3d low = own.corner[0].cwiseMin(own.corner[1]).cwiseMin(own.corner[2]);
    const Eigen::Vector3d high = own.corner[0].cwiseMax(own.corner[1]).cwiseMax(own.corner[2]);
    bool apart = false;
    for (int d = 0; d < 3; ++d) {
      apart = apart || static_cast<float>(low[d]) > most[d] || static_cast<float>(high[d]) < least[d];
    }
    if (apart) continue;
    own.face = cluster.face[at(lane)];
    own.normal = rotation_ * face.normal;
    own.offset = face.offset + own.normal.dot(shift_);
    const auto place = static_cast<std::size_t>(moved.boxes.count++);
    moved.boxes.face[place] = static_cast<int>(moved_.size());
    for (std::size_t d = 0; d < 3; ++d) {
      const auto axis = static_cast<Eigen::Index>(d);
      moved.boxes.low[d][place] = static_cast<float>(low[axis]) - slack_;
      moved.boxes.high[d][place] = static_cast<float>(high[axis]) + slack_;
      moved.low[d] = std::min(moved.low[d], moved.boxes.low[d][place]);
      moved.high[d] = std::max(moved.high[d], moved.boxes.high[d][place]);
    }
    moved_.push_back(own);
  }
  if (moved.boxes.count == 0) return;
  for (std::size_t d = 0; d < 3; ++d) {
    span_low_[d] = std::min(span_low_[d], moved.low[d]);
    span_high_[d] = std::max(span_high_[d], moved.high[d]);
  }
  moved_clusters_.push_back(moved);
}

TWINBUS_AVX2_CLONES void Intersection::cross_clusters() noexcept {
  for (const MovedCluster& own : moved_clusters_) {
    for (const NearCluster& near : near_) {
      const FaceBoxes& other = b_->clusters()[at(near.cluster)];
      unsigned lanes = near.lanes & meeting(other, own.low.data(), own.high.data());
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const float low[3] = {other.low[0][lane], other.low[1][lane], other.low[2][lane]};
        const float high[3] = {other.high[0][lane], other.high[1][lane], other.high[2][lane]};
        for (unsigned m = meeting(own.boxes, low, high); m != 0; m &= m - 1) {
          cross(moved_[at(own.boxes.face[at(std::countr_zero(m))])], other.face[lane]);
        }
      }
    }
  }
}

// The edges that each of two triangles stands for, through the other.
TWINBUS_AVX2_CLONES void Intersection::cross(const MovedFace& own, int face_b) noexcept {
  const ContactFace& a = a_->faces()[at(own.face)];
  const ContactFace& b = b_->faces()[at(face_b)];
  double side[3];
  for (std::size_t k = 0; k < 3; ++k) side[k] = b.normal.dot(own.corner[k]) - b.offset;
  const bool under = side[0] < 0.0;
  if ((side[1] < 0.0) == under && (side[2] < 0.0) == under) return;
  std::array<Eigen::Vector3d, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) corner[k] = b_->vertices()[at(b.vertex[k])];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if ((side[k] < 0.0) == (side[n] < 0.0)) continue;
    const ContactEdge& edge = a_->edges()[at(a.edge[k])];
    if (edge.face[0] != own.face) continue;
    const bool turned = edge.from != a.vertex[k];
    const std::size_t from = turned ? n : k, to = turned ? k : n;
    if (!goes_through(own.corner[from], own.corner[to], corner)) continue;
    add(CrossingPoint::kEdgeA, a.edge[k], side[from], side[to], own.corner[from], own.corner[to],
        face_b, b.normal);
  }
  for (std::size_t k = 0; k < 3; ++k) side[k] = own.normal.dot(corner[k]) - own.offset;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if ((side[k] < 0.0) == (side[n] < 0.0)) continue;
    const ContactEdge& edge = b_->edges()[at(b.edge[k])];
    if (edge.face[0] != face_b) continue;
    const bool turned = edge.from != b.vertex[k];
    const std::size_t from = turned ? n : k, to = turned ? k : n;
    if (!goes_through(corner[from], corner[to], own.corner)) continue;
    add(CrossingPoint::kEdgeB, b.edge[k], side[from], side[to], corner[from], corner[to], own.face,
        own.normal);
  }
}

void Intersection::add(CrossingPoint::Kind kind, int edge, double from_side, double to_side,
                       const Eigen::Vector3d& from, const Eigen::Vector3d& to, int face,
                       const Eigen::Vector3d& normal) noexcept {
  if (points_.size() >= static_cast<std::size_t>(kMostEdges)) {
    truncated_ = true;
    return;
  }
  const bool from_inside = from_side < 0.0;
  const double along = from_side / (from_side - to_side);
  const bool of_a = kind == CrossingPoint::kEdgeA;
  const ContactEdge& own = of_a ? a_->edges()[at(edge)] : b_->edges()[at(edge)];
  CrossingPoint& added = points_.emplace_back();
  added.kind = kind;
  added.id = edge;
  added.face = face;
  added.point = from + along * (to - from);
  added.normal = normal;
  added.leaves = of_a ? Eigen::Vector3d(rotation_ * own.direction) : own.direction;
  if (!from_inside) added.leaves = -added.leaves;
  added.sharp = !own.flat;
  cut(of_a ? known_a_ : known_b_, edge, along, from_inside, static_cast<int>(points_.size()) - 1);
}

void Intersection::cut(Known& known, int edge, double along, bool from_inside,
                       int point) noexcept {
  Cut& cut = known.cut[at(edge)];
  const bool fresh = known.edge_stamp[at(edge)] != stamp_;
  known.edge_stamp[at(edge)] = stamp_;
  if (fresh || along < cut.first) {
    cut.first = along;
    cut.from_inside = from_inside;
    cut.first_point = point;
  }
  if (fresh || along > cut.last) {
    cut.last = along;
    cut.to_inside = !from_inside;
    cut.last_point = point;
  }
}

// Two triangles cross along a line with two ends: both are of one region.
void Intersection::join_regions() noexcept {
  parent_.resize(at(edges_));
  for (int i = 0; i < edges_; ++i) parent_[at(i)] = i;
  for (int i = 0; i < edges_; ++i) {
    CrossingPoint& point = points_[at(i)];
    const bool of_a = point.kind == CrossingPoint::kEdgeA;
    const ContactEdge& edge = of_a ? a_->edges()[at(point.id)] : b_->edges()[at(point.id)];
    for (const int face : edge.face) {
      if (face < 0) continue;
      join_pair(of_a ? face : point.face, of_a ? point.face : face, i);
    }
    point.region = i;
  }
}

void Intersection::join_pair(int face_a, int face_b, int point) noexcept {
  const std::uint64_t key = static_cast<std::uint64_t>(face_a) << 32 | static_cast<unsigned>(face_b);
  std::size_t slot = key * 0x9E3779B97F4A7C15ULL >> 40;
  for (;; ++slot) {
    PairSlot& pair = pairs_[slot % kPairSlots];
    if (pair.stamp != stamp_) {
      pair = {key, stamp_, point};
      return;
    }
    if (pair.key != key) continue;
    unite(pair.point, point);
    return;
  }
}

int Intersection::root(int point) noexcept {
  while (parent_[at(point)] != point) {
    parent_[at(point)] = parent_[at(parent_[at(point)])];
    point = parent_[at(point)];
  }
  return point;
}

void Intersection::unite(int a, int b) noexcept {
  const int first = root(a), second = root(b);
  parent_[at(std::max(first, second))] = std::min(first, second);
}

// Corners inside: ends of edges that cross, and from there all that is joined by edges that do not.
void Intersection::find_inside(bool of_a) noexcept {
  const ContactMesh& mesh = of_a ? *a_ : *b_;
  Known& known = of_a ? known_a_ : known_b_;
  const CrossingPoint::Kind edge_kind = of_a ? CrossingPoint::kEdgeA : CrossingPoint::kEdgeB;
  queue_.clear();
  for (int i = 0; i < edges_; ++i) {
    const CrossingPoint& point = points_[at(i)];
    if (point.kind != edge_kind) continue;
    const ContactEdge& edge = mesh.edges()[at(point.id)];
    const Cut& cut = known.cut[at(point.id)];
    if (cut.first_point == i) say(of_a, edge.from, cut.from_inside, i);
    if (cut.last_point == i) say(of_a, edge.to, cut.to_inside, i);
  }
  std::erase_if(queue_, [&](int vertex) { return known.inside[at(vertex)] == 0; });
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const int vertex = queue_[next];
    const int region = known.region[at(vertex)];
    CrossingPoint found;
    found.kind = of_a ? CrossingPoint::kVertexA : CrossingPoint::kVertexB;
    found.id = vertex;
    found.region = region;
    found.point = place(of_a, vertex);
    found.normal.setZero();
    found.leaves.setZero();
    if (points_.size() < points_.capacity()) points_.push_back(found);
    for (const ContactNeighbour* n = mesh.neighbours_begin(vertex);
         n != mesh.neighbours_end(vertex); ++n) {
      if (known.edge_stamp[at(n->edge)] == stamp_) continue;  // crosses: its ends are known
      if (known.vertex_stamp[at(n->vertex)] == stamp_) {
        if (known.inside[at(n->vertex)] != 0) unite(region, known.region[at(n->vertex)]);
        continue;
      }
      // Rounding may have hidden a crossing: nothing outside of the other's box is inside of it.
      if (!in_box(of_a, place(of_a, n->vertex))) continue;
      say(of_a, n->vertex, true, region);
    }
  }
}

// Two edges may disagree about their common corner when it lies in a face: then it is not inside.
void Intersection::say(bool of_a, int vertex, bool inside, int region) noexcept {
  Known& known = of_a ? known_a_ : known_b_;
  const bool fresh = known.vertex_stamp[at(vertex)] != stamp_;
  if (!fresh) {
    if (!inside) known.inside[at(vertex)] = 0;
    if (inside && known.inside[at(vertex)] != 0) unite(region, known.region[at(vertex)]);
    return;
  }
  known.vertex_stamp[at(vertex)] = stamp_;
  known.inside[at(vertex)] = inside ? 1 : 0;
  known.region[at(vertex)] = region;
  if (inside) queue_.push_back(vertex);
}

Eigen::Vector3d Intersection::place(bool of_a, int vertex) const noexcept {
  if (!of_a) return b_->vertices()[at(vertex)];
  return rotation_ * a_->vertices()[at(vertex)] + shift_;
}

bool Intersection::in_box(bool of_a, const Eigen::Vector3d& point) const noexcept {
  if (of_a) return b_->box().contains(point);
  return a_->box().contains(rotation_.transpose() * (point - shift_));
}

}  // namespace twinbus::geometry
