#include "geometry/mesh_contact/contact_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus::inline geometry {

namespace {

constexpr double kOnePlane = 0.9999;   // cosine between faces of one plane
constexpr double kFarthest = 1e6;  // [m]
constexpr double kSliver = 1e-14;  // area of a triangle against its longest edge squared

float below(double x) { return std::nextafter(static_cast<float>(x), -1e30F); }
float above(double x) { return std::nextafter(static_cast<float>(x), 1e30F); }

// Triangles that lie together come together: halves along the longest side, again and again.
void sort_by_place(const std::vector<Eigen::Vector3d>& middles, std::vector<int>& order,
                   std::size_t begin, std::size_t end) {
  constexpr std::size_t kLanes = FaceBoxes::kLanes;
  if (end - begin <= kLanes) return;
  Eigen::AlignedBox3d box;
  for (std::size_t i = begin; i < end; ++i) box.extend(middles[at(order[i])]);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  // A whole number of clusters on the left.
  const std::size_t half = begin + ((end - begin) / 2 + kLanes - 1) / kLanes * kLanes;
  const auto place = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(place(begin), place(half), place(end), [&](int a, int b) {
    const double x = middles[at(a)][axis], y = middles[at(b)][axis];
    return x < y || (x == y && a < b);
  });
  sort_by_place(middles, order, begin, half);
  sort_by_place(middles, order, half, end);
}

}  // namespace

ContactMesh::ContactMesh(const TriangleMesh& mesh) {
  for (const Eigen::Vector3d& point : mesh.points) {
    if (!(point.cwiseAbs().maxCoeff() <= kFarthest)) {
      throw std::runtime_error("a corner of a mesh is not a number, or more than 1000 km away");
    }
  }
  add_faces(welded(mesh));
  if (faces_.empty()) throw std::runtime_error("no triangle of a mesh has an area");
  for (const Eigen::Vector3d& vertex : vertices_) box_.extend(vertex);
  weigh();
  add_edges();
  add_clusters();
}

void ContactMesh::add_faces(const TriangleMesh& mesh) {
  vertices_ = mesh.points;
  double six_volumes = 0.0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Eigen::Vector3d &a = vertices_[at(t[0])], &b = vertices_[at(t[1])],
                          &c = vertices_[at(t[2])];
    const Eigen::Vector3d across = (b - a).cross(c - a);
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (!(across.norm() > kSliver * longest && longest > 0.0)) continue;
    ContactFace face;
    face.vertex = t;
    face.normal = across.normalized();
    face.edge = {-1, -1, -1};
    face.offset = face.normal.dot(a);
    faces_.push_back(face);
    six_volumes += a.dot(b.cross(c));
  }
  if (six_volumes >= 0.0) return;
  for (ContactFace& face : faces_) {
    std::swap(face.vertex[1], face.vertex[2]);
    face.normal = -face.normal;
    face.offset = -face.offset;
  }
}

void ContactMesh::add_edges() {
  std::map<std::pair<int, int>, int> known;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int u = faces_[f].vertex[k], v = faces_[f].vertex[(k + 1) % 3];
      const auto [found, fresh] =
          known.try_emplace(std::minmax(u, v), static_cast<int>(edges_.size()));
      if (fresh) {
        ContactEdge edge;
        edge.from = std::min(u, v);
        edge.to = std::max(u, v);
        edge.direction = (vertices_[at(edge.to)] - vertices_[at(edge.from)]).normalized();
        edges_.push_back(edge);
      }
      ContactEdge& edge = edges_[at(found->second)];
      faces_[f].edge[k] = found->second;
      for (int& face : edge.face) {
        if (face >= 0) continue;
        face = static_cast<int>(f);
        break;
      }
    }
  }
  first_.assign(vertices_.size() + 1, 0);
  for (ContactEdge& edge : edges_) {
    closed_ = closed_ && edge.face[1] >= 0;
    edge.flat = edge.face[1] >= 0 &&
                faces_[at(edge.face[0])].normal.dot(faces_[at(edge.face[1])].normal) > kOnePlane;
    ++first_[at(edge.from) + 1];
    ++first_[at(edge.to) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  neighbours_.resize(2 * edges_.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const int from = edges_[e].from, to = edges_[e].to;
    neighbours_[at(next[at(from)]++)] = {to, static_cast<int>(e)};
    neighbours_[at(next[at(to)]++)] = {from, static_cast<int>(e)};
  }
}

void ContactMesh::add_clusters() {
  std::vector<Eigen::Vector3d> middles;
  for (const ContactFace& face : faces_) {
    middles.push_back((vertices_[at(face.vertex[0])] + vertices_[at(face.vertex[1])] +
                       vertices_[at(face.vertex[2])]) /
                      3.0);
  }
  std::vector<int> order(faces_.size());
  std::iota(order.begin(), order.end(), 0);
  sort_by_place(middles, order, 0, order.size());
  for (std::size_t begin = 0; begin < order.size(); begin += FaceBoxes::kLanes) {
    FaceBoxes& cluster = clusters_.emplace_back();
    for (auto& axis : cluster.low) axis.fill(1e30F);
    for (auto& axis : cluster.high) axis.fill(-1e30F);
    cluster.face.fill(-1);
    Eigen::AlignedBox3d around;
    for (std::size_t i = begin; i < std::min(begin + FaceBoxes::kLanes, order.size()); ++i) {
      const auto lane = static_cast<std::size_t>(cluster.count++);
      cluster.face[lane] = order[i];
      Eigen::AlignedBox3d box;
      for (const int vertex : faces_[at(order[i])].vertex) box.extend(vertices_[at(vertex)]);
      around.extend(box);
      for (std::size_t d = 0; d < 3; ++d) {
        cluster.low[d][lane] = below(box.min()[static_cast<Eigen::Index>(d)]);
        cluster.high[d][lane] = above(box.max()[static_cast<Eigen::Index>(d)]);
      }
    }
    for (std::size_t d = 0; d < 3; ++d) {
      const auto axis = static_cast<Eigen::Index>(d);
      middle_[d].push_back(static_cast<float>(around.center()[axis]));
      half_[d].push_back(static_cast<float>(0.5 * around.sizes()[axis]));
    }
  }
  while (middle_[0].size() % FaceBoxes::kLanes != 0) {
    for (std::size_t d = 0; d < 3; ++d) {
      middle_[d].push_back(1e18F);
      half_[d].push_back(0.0F);
    }
  }
}

// Sums over the tetrahedra from one point, near, to each triangle.
void ContactMesh::weigh() noexcept {
  const Eigen::Vector3d near = box_.center();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of p p'
  for (const ContactFace& face : faces_) {
    const Eigen::Vector3d a = vertices_[at(face.vertex[0])] - near,
                          b = vertices_[at(face.vertex[1])] - near,
                          c = vertices_[at(face.vertex[2])] - near;
    const double six = a.dot(b.cross(c));
    const Eigen::Vector3d sum = a + b + c;
    volume_ += six / 6.0;
    moment += six / 24.0 * sum;
    second += six / 120.0 *
              (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  if (!(volume_ > 0.0)) return;
  const Eigen::Vector3d aside = moment / volume_;
  centre_ = near + aside;
  const Eigen::Matrix3d about = second - volume_ * aside * aside.transpose();
  inertia_ = about.trace() * Eigen::Matrix3d::Identity() - about;
}

bool ContactMesh::contains(const Eigen::Vector3d& point) const noexcept {
  if (!box_.contains(point)) return false;
  // A direction that no edge of a hand-made mesh has.
  const Eigen::Vector3d ray(0.0812345, 0.1234567, 0.9890123);
  bool inside = false;
  for (const ContactFace& face : faces_) {
    const double along = face.normal.dot(ray);
    const double t = (face.offset - face.normal.dot(point)) / along;
    if (!(t > 0.0) || !std::isfinite(t)) continue;
    const Eigen::Vector3d hit = point + t * ray;
    bool in = true;
    for (std::size_t k = 0; k < 3 && in; ++k) {
      const Eigen::Vector3d& u = vertices_[at(face.vertex[k])];
      const Eigen::Vector3d& v = vertices_[at(face.vertex[(k + 1) % 3])];
      in = face.normal.dot((v - u).cross(hit - u)) >= 0.0;
    }
    inside ^= in;
  }
  return inside;
}

}  // namespace twinbus::geometry
