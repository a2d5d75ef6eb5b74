#include "test/oracles/fcl_oracle.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <optional>

#include "common/math/index.h"
#include "geometry/mesh/mesh_file.h"
#include "robot/collision/links/geometry_cache.h"
#include "robot/description/model.h"

namespace twinbus {

using Eigen::Vector3d;
using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

struct FclOracle::Body {
  struct Part {
    Geometry geometry;
    Eigen::Isometry3d pose;  // in the link, or the world
  };
  int link = -1;  // that moves it; -1: it stands still in the world
  std::vector<Part> parts;
};

namespace {

Geometry of_mesh(const Shape& shape) {
  const TriangleMesh mesh = load_mesh(shape.mesh, shape.size);
  if (const std::optional<TriangleMesh> hull = kept_coarse_hull(mesh)) {
    auto faces = std::make_shared<std::vector<int>>();
    for (const auto& t : hull->triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
    return std::make_shared<fcl::Convexd>(std::make_shared<std::vector<Vector3d>>(hull->points),
                                          static_cast<int>(hull->triangles.size()), faces);
  }
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel(static_cast<int>(mesh.triangles.size()), static_cast<int>(3 * mesh.triangles.size()));
  for (const auto& t : mesh.triangles) model->addTriangle(mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

Geometry geometry_of(const Shape& shape) {
  if (shape.kind == ShapeKind::kMesh) return of_mesh(shape);
  const Vector3d& size = shape.size;
  if (shape.kind == ShapeKind::kBox) return std::make_shared<fcl::Boxd>(size.x(), size.y(), size.z());
  if (shape.kind == ShapeKind::kSphere) return std::make_shared<fcl::Sphered>(size.x());
  return std::make_shared<fcl::Cylinderd>(size.x(), size.y());
}

bool touching(const Geometry& a, const Eigen::Isometry3d& pose_a, const Geometry& b, const Eigen::Isometry3d& pose_b) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;  // collide() appends: a fresh one each time
  return fcl::collide(a.get(), pose_a, b.get(), pose_b, request, result) > 0;
}

}  // namespace

FclOracle::FclOracle(const Model& model) : model_(model) {
  for (int link = 0; link < model.link_count(); ++link) {
    bodies_.push_back({link, {}});
    for (const Shape& shape : model.links[at(link)].collision) bodies_.back().parts.push_back({geometry_of(shape), shape.pose});
  }
}

FclOracle::~FclOracle() = default;

void FclOracle::set_obstacles(const std::vector<Obstacle>& obstacles) {
  bodies_.resize(at(model_.link_count()));
  for (const Obstacle& obstacle : obstacles) {
    if (!takes_part(obstacle, model_)) continue;
    const Hand* hand = obstacle.hand < 0 ? nullptr : hand_of(model_, obstacle.hand);
    const Shape shape = shape_of(obstacle, model_);
    bodies_.push_back({hand != nullptr ? hand->link : -1, {{geometry_of(shape), shape.pose}}});
  }
}

template <class Take>
void FclOracle::each(const Kinematics& kinematics, const CollisionPair& pair, const Take& take) const {
  const Body &a = bodies_[at(pair.link_a)], &b = bodies_[at(pair.link_b)];
  const auto placed = [&](const Body& body, const Body::Part& part) {
    return body.link < 0 ? part.pose : Eigen::Isometry3d(kinematics.link_in_world(body.link) * part.pose);
  };
  for (const Body::Part& one : a.parts) {
    for (const Body::Part& other : b.parts) take(one.geometry, placed(a, one), other.geometry, placed(b, other));
  }
}

bool FclOracle::touches(const Kinematics& kinematics, const CollisionPair& pair) const {
  bool any = false;
  each(kinematics, pair, [&](const Geometry& a, const Eigen::Isometry3d& pose_a, const Geometry& b, const Eigen::Isometry3d& pose_b) {
    any = any || touching(a, pose_a, b, pose_b);
  });
  return any;
}

FclGap FclOracle::gap(const Kinematics& kinematics, const CollisionPair& pair) const {
  FclGap least{.distance = 1e9};
  each(kinematics, pair, [&](const Geometry& a, const Eigen::Isometry3d& pose_a, const Geometry& b, const Eigen::Isometry3d& pose_b) {
    if (touching(a, pose_a, b, pose_b)) {  // distance() of touching shapes is not to be relied on
      least = {};
      return;
    }
    fcl::DistanceRequestd request(true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::DistanceResultd result;
    const double distance = fcl::distance(a.get(), pose_a, b.get(), pose_b, request, result);
    if (distance < least.distance) least = {distance, result.nearest_points[0], result.nearest_points[1]};
  });
  return least;
}

}  // namespace twinbus
