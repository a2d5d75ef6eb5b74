#include "robot/collision/collision_fcl.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <vector>

#include "common/math/index.h"

namespace twinbus {

using Eigen::Vector3d;

struct FclShape {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
};

std::shared_ptr<FclShape> fcl_primitive(ShapeKind kind, const Vector3d& size) {
  auto shape = std::make_shared<FclShape>();
  if (kind == ShapeKind::kBox) {
    shape->geometry = std::make_shared<fcl::Boxd>(size.x(), size.y(), size.z());
  } else if (kind == ShapeKind::kSphere) {
    shape->geometry = std::make_shared<fcl::Sphered>(size.x());
  } else {
    shape->geometry = std::make_shared<fcl::Cylinderd>(size.x(), size.y());
  }
  return shape;
}

std::shared_ptr<FclShape> fcl_hull(const TriangleMesh& hull) {
  auto corners = std::make_shared<std::vector<Vector3d>>(hull.points);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& t : hull.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  auto shape = std::make_shared<FclShape>();
  shape->geometry =
      std::make_shared<fcl::Convexd>(corners, static_cast<int>(hull.triangles.size()), faces);
  return shape;
}

std::shared_ptr<FclShape> fcl_mesh(const TriangleMesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel(static_cast<int>(mesh.triangles.size()),
                    static_cast<int>(3 * mesh.triangles.size()));
  for (const auto& t : mesh.triangles)
    model->addTriangle(mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]);
  model->endModel();
  model->computeLocalAABB();
  auto shape = std::make_shared<FclShape>();
  shape->geometry = model;
  return shape;
}

bool fcl_touches(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
                 const Eigen::Isometry3d& pose_b) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;  // collide() appends: a fresh one each time
  return fcl::collide(a.geometry.get(), pose_a, b.geometry.get(), pose_b, request, result) > 0;
}

bool fcl_gap(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
             const Eigen::Isometry3d& pose_b, FclGap& gap) noexcept {
  try {
    // distance() of touching shapes is not to be relied on.
    if (fcl_touches(a, pose_a, b, pose_b)) {
      gap = {};
      return true;
    }
    fcl::DistanceRequestd request(true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::DistanceResultd result;
    gap.distance =
        fcl::distance(a.geometry.get(), pose_a, b.geometry.get(), pose_b, request, result);
    gap.point_a = result.nearest_points[0];
    gap.point_b = result.nearest_points[1];
    return gap.distance > 0.0 && gap.point_a.allFinite() && gap.point_b.allFinite();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace twinbus
