#include "sim/objects/rigid_object_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/bounds/convex_hull.h"
#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "sim/contact/bristle.h"
#include "geometry/mesh_contact/hull_overlap.h"
#include "sim/objects/rigid_object_contacts.h"
#include "sim/world/link_hull.h"

namespace twinbus::inline sim {

namespace {

constexpr int kCapPoints = 16;  // round a capsule, and of each cap's rings
constexpr int kCapRings = 4;

// So much of the number of a corner or edge as tells it from its neighbours.
int short_name(std::int64_t feature) noexcept {
  return static_cast<int>(static_cast<std::uint64_t>(feature) * 0x9E3779B97F4A7C15ULL >> 52);
}

TriangleMesh capsule(const Eigen::Vector3d& size) {
  std::vector<Eigen::Vector3d> points;
  for (const double side : {-1.0, 1.0}) {
    for (int ring = 0; ring <= kCapRings; ++ring) {
      const double up = 0.5 * std::numbers::pi * ring / kCapRings;
      for (int i = 0; i < kCapPoints; ++i) {
        const double round = 2.0 * std::numbers::pi * i / kCapPoints;
        points.push_back({size.x() * std::cos(up) * std::cos(round),
                          size.x() * std::cos(up) * std::sin(round),
                          side * (0.5 * size.y() + size.x() * std::sin(up))});
      }
    }
  }
  return convex_hull(points);
}

Eigen::Isometry3d pose_of(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& middle) noexcept {
  Eigen::Isometry3d pose;
  pose.linear() = rotation;
  pose.translation() = middle;
  return pose;
}

Eigen::Isometry3d after(const Eigen::Isometry3d& pose, const Eigen::Vector3d& velocity,
                        const Eigen::Vector3d& spin, double h) noexcept {
  Eigen::Isometry3d end = pose;
  end.translation() += h * velocity;
  const double angle = h * spin.norm();
  if (angle > 0.0) {
    end.linear() =
        Eigen::AngleAxisd(angle, spin.normalized()).toRotationMatrix() * pose.linear();
  }
  return end;
}

}  // namespace

void give_mesh(const TriangleMesh& triangles, LooseBody& body) {
  const ContactMesh as_given(triangles);
  if (!as_given.closed() || !(as_given.volume() > 0.0)) {
    throw std::runtime_error("the triangles of '" + body.name + "' do not enclose a volume");
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(as_given.inertia());
  Eigen::Matrix3d turn = axes.eigenvectors();
  if (turn.determinant() < 0.0) turn.col(2) = -turn.col(2);
  // A body whose axes are principal already keeps them.
  const Eigen::Matrix3d& inertia = as_given.inertia();
  const Eigen::Matrix3d aside = inertia - Eigen::Matrix3d(inertia.diagonal().asDiagonal());
  if (aside.norm() < 1e-9 * inertia.norm()) turn.setIdentity();
  TriangleMesh own = triangles;
  for (Eigen::Vector3d& point : own.points) {
    point = turn.transpose() * (point - as_given.middle());
  }
  body.mesh = std::make_shared<const ContactMesh>(own);
  body.start.pose.linear() = body.start.pose.linear() * turn;
  body.solid = {SolidShape::kBox, as_given.box().sizes()};
  body.solid_pose.linear() = turn.transpose();
  body.solid_pose.translation() =
      turn.transpose() * (as_given.box().center() - as_given.middle());
}

Eigen::Matrix3d inertia_of(const LooseBody& body) noexcept {
  if (body.mesh == nullptr) return inertia_of(body.solid, body.mass);
  return body.mass / body.mesh->volume() * body.mesh->inertia();
}

std::shared_ptr<const ContactMesh> mesh_of(const Solid& solid) {
  if (solid.shape == SolidShape::kCapsule) {
    return std::make_shared<const ContactMesh>(capsule(solid.size));
  }
  Shape shape;
  shape.kind = solid.shape == SolidShape::kBox      ? ShapeKind::kBox
               : solid.shape == SolidShape::kSphere ? ShapeKind::kSphere
                                                    : ShapeKind::kCylinder;
  shape.size = solid.size;
  double outside = 0.0;
  return std::make_shared<const ContactMesh>(shape_mesh(shape, outside));
}

void LooseContacts::give_meshes() {
  for (Piece& piece : pieces_) {
    if (piece.mesh == nullptr && piece.solid_too) piece.mesh = mesh_of(piece.solid);
    if (piece.mesh == nullptr) continue;
    finder_.reserve(*piece.mesh);
    piece.hull = patches_ && is_hull(*piece.mesh);
  }
}

Eigen::Isometry3d LooseContacts::end_of(const Piece& piece, const Search& search) const noexcept {
  const Eigen::Isometry3d pose = pose_of(piece.rotation, piece.center);
  if (piece.system < 0) return pose;
  const ArticulatedBody& body = *search.systems[at(piece.system)];
  const Screw& velocity = body.velocity(piece.link);
  return after(pose, at_point(velocity, piece.center - body.origin()), angular(velocity), search.h);
}

void LooseContacts::meet_mesh(std::size_t own, int other, Search& search) noexcept {
  const Piece& a = pieces_[own];
  const Piece* b = other >= 0 ? &pieces_[at(other)] : nullptr;
  if (a.mesh == nullptr || (b != nullptr && b->mesh == nullptr)) return;
  if (patches_ && meet_patch(own, other, search)) return;
  const Eigen::Isometry3d pose_a = pose_of(a.rotation, a.center), end_a = end_of(a, search);
  const Eigen::Isometry3d back = pose_a * end_a.inverse(Eigen::Isometry);
  if (b == nullptr) {
    if (!finder_.with_ground(*a.mesh, end_a, manifold_)) return;
  } else if (!finder_.between(*a.mesh, end_a, *b->mesh, end_of(*b, search), manifold_)) {
    return;
  }
  Contact found;
  found.params = b != nullptr ? together(a.params, b->params) : together(a.params, ground_);
  found.system = a.system;
  found.link = a.link;
  found.other_system = b != nullptr ? b->system : -1;
  found.other = b != nullptr && b->system >= 0 ? b->link : -1;
  const ArticulatedBody& body = *search.systems[at(a.system)];
  const int pair = static_cast<int>(own) * (static_cast<int>(pieces_.size()) + 1) + other + 1;
  for (int i = 0; i < manifold_.count; ++i) {
    const ManifoldPoint& point = manifold_.point[at(i)];
    found.point = back * point.position;
    found.normal = point.normal;
    Eigen::Vector3d v = at_point(body.velocity(a.link), found.point - body.origin());
    if (found.other_system >= 0) {
      const ArticulatedBody& against = *search.systems[at(found.other_system)];
      v -= at_point(against.velocity(found.other), found.point - against.origin());
    }
    found.depth = point.depth + search.h * found.normal.dot(v);
    found.material = (point.feature & 3) == CrossingPoint::kVertexA;
    found.key = kFirstMeshKey + pair * kMeshKeysPerPair + short_name(point.feature);
    consider(found, search);
  }
}

// Of a foot only what is above its sole: near it, it touches with the sole's corners.
void LooseContacts::add_hull(const Shape& shape, const Model& model, const ContactParams& params,
                             Piece piece) {
  TriangleMesh hull = link_hull(shape);
  for (const Sole& sole : model.soles) {
    if (sole.link != piece.link) continue;
    const Eigen::Isometry3d in_sole = sole.frame.inverse();
    for (Eigen::Vector3d& point : hull.points) {
      Eigen::Vector3d p = in_sole * point;
      p.z() = std::max(p.z(), kSoleSkin);
      point = sole.frame * p;
    }
    hull = convex_hull(hull.points);
  }
  if (hull.triangles.empty()) return;
  // About its middle, where a piece has its bounding sphere.
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : hull.points) box.extend(point);
  for (Eigen::Vector3d& point : hull.points) point -= box.center();
  piece.in_link.translation() = box.center();
  piece.mesh = std::make_shared<const ContactMesh>(hull);
  piece.only_mesh = true;
  piece.solid_too = false;
  piece.params = params;
  add(std::move(piece));
}

}  // namespace twinbus::sim
