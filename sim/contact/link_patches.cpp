#include "sim/contact/link_patches.h"

#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "geometry/mesh_contact/hull_overlap.h"
#include "sim/contact/ground_contacts.h"
#include "sim/world/link_hull.h"

namespace twinbus::inline sim {

namespace {

constexpr double kDeeper = 1.5;  // than it is out the soonest, at most, is what touches
constexpr double kSlack = 1e-4;  // [m]

Shape shape_of(const Solid& solid) {
  Shape shape;
  shape.kind = solid.shape == SolidShape::kBox      ? ShapeKind::kBox
               : solid.shape == SolidShape::kSphere ? ShapeKind::kSphere
                                                    : ShapeKind::kCylinder;
  shape.size = solid.size;
  return shape;
}

// Triangles of a shape in the link frame, convex.
TriangleMesh hull_of(const Shape& shape) {
  double outside = 0.0;
  return shape.kind == ShapeKind::kMesh ? link_hull(shape) : shape_mesh(shape, outside);
}

double mean_face(const Eigen::Vector3d& size) {
  return (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) / 3.0;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin,
                        double h) noexcept {
  Eigen::Isometry3d end = pose;
  end.translation() += h * velocity;
  const double angle = h * spin.norm();
  if (angle > 0.0) end.linear() = Eigen::AngleAxisd(angle, spin.normalized()).toRotationMatrix() * pose.linear();
  return end;
}

}  // namespace

LinkPatches::LinkPatches(const Model& model, const WorldConfig& config) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const int link = static_cast<int>(i);
    if (link == model.soles[0].link || link == model.soles[1].link) continue;
    for (std::size_t s = 0; s < model.links[i].collision.size(); ++s) {
      const Shape& shape = model.links[i].collision[s];
      Piece piece;
      piece.link = link;
      piece.shape = static_cast<int>(s);
      if (shape.kind == ShapeKind::kSphere) {
        piece.in_link = shape.pose;
        piece.radius = shape.size.x();
        piece.face = mean_face(Eigen::Vector3d::Constant(2.0 * piece.radius));
      } else {
        TriangleMesh hull = hull_of(shape);
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& point : hull.points) box.extend(point);
        for (Eigen::Vector3d& point : hull.points) point -= box.center();
        piece.in_link.translation() = box.center();
        piece.mesh.emplace(hull);
        if (!is_hull(*piece.mesh)) continue;
        const Eigen::Vector3d round(2.0 * shape.size.x(), 2.0 * shape.size.x(), shape.size.y());
        piece.face = mean_face(shape.kind == ShapeKind::kBox        ? shape.size
                               : shape.kind == ShapeKind::kCylinder ? round
                                                                    : Eigen::Vector3d(box.sizes()));
      }
      pieces_.push_back(std::move(piece));
    }
  }
  for (const Obstacle& obstacle : config.obstacles) {
    if (obstacle.shape == ObstacleShape::kNone) continue;
    const Solid solid = solid_of(obstacle);
    double outside = 0.0;
    fixed_.push_back({obstacle.pose, solid, ContactMesh(shape_mesh(shape_of(solid), outside))});
  }
}

int LinkPatches::of(int link, int shape) const noexcept {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (pieces_[i].link == link && pieces_[i].shape == shape) return static_cast<int>(i);
  }
  return -1;
}

bool LinkPatches::presses(const Piece& piece, const Eigen::Isometry3d& pose, std::size_t surface, Patch& patch) const noexcept {
  if (!piece.mesh) {
    const Eigen::Vector3d& centre = pose.translation();
    Distance away{centre.z(), Eigen::Vector3d::UnitZ()};
    double other_radius = std::numeric_limits<double>::infinity();
    if (surface > 0) {
      const Fixed& fixed = fixed_[surface - 1];
      away = distance_to(fixed.solid, fixed.pose.inverse(Eigen::Isometry) * centre);
      away.normal = fixed.pose.linear() * away.normal;
      if (fixed.solid.shape == SolidShape::kSphere) other_radius = fixed.solid.size.x();
    }
    const double depth = piece.radius - away.value;
    if (!(depth > 0.0)) return false;
    patch = ball_patch(piece.radius, other_radius, centre, depth, away.normal);
    return true;
  }
  if (surface == 0) return finder_.with_ground(*piece.mesh, pose, patch);
  const Fixed& fixed = fixed_[surface - 1];
  const HullOverlap overlap = hull_overlap(*piece.mesh, pose, fixed.mesh, fixed.pose);
  return overlap.depth > 0.0 &&
         finder_.between(*piece.mesh, pose, fixed.mesh, fixed.pose, overlap.normal, kDeeper * overlap.depth + kSlack, patch);
}

bool LinkPatches::find(int which, const Eigen::Isometry3d& link, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin,
                       double h, std::size_t surface, LinkPress& press) const noexcept {
  const Piece& piece = pieces_[at(which)];
  const Eigen::Isometry3d pose = link * piece.in_link;
  const Eigen::Vector3d middle = velocity + spin.cross(pose.translation() - link.translation());
  // What presses will press at the end of the step; what only does now may still have to, if something holds it.
  for (const double ahead : {h, 0.0}) {
    const Eigen::Isometry3d end = moved(pose, middle, spin, ahead);
    Patch patch;
    if (!presses(piece, end, surface, patch)) continue;
    const Eigen::Isometry3d back = pose * end.inverse(Eigen::Isometry);
    press.count = piece.mesh ? Patch::kPoints : 1;
    press.normal = patch.normal;
    press.weight = kSoleCorners / piece.face * patch.area / press.count;
    press.rough = patch.rough / patch.area;
    for (int i = 0; i < press.count; ++i) {
      LinkPoint& point = press.point[at(i)];
      const PatchPoint& from = patch.point[at(i)];
      point.position = piece.mesh ? Eigen::Vector3d(back * from.position) : Eigen::Vector3d(from.position - ahead * middle);
      const Eigen::Vector3d v = velocity + spin.cross(point.position - link.translation());
      point.depth = from.depth + ahead * press.normal.dot(v);
    }
    return true;
  }
  return false;
}

}  // namespace twinbus::sim
