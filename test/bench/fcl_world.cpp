#include "test/bench/fcl_world.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include "robot/collision/links/link_geometry.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

namespace {
using Object = fcl::CollisionObjectd;
using Mesh = fcl::BVHModel<fcl::OBBRSSd>;

bool touch(const Object& a, const Object& b) {
  if (!a.getAABB().overlap(b.getAABB())) return false;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, fcl::CollisionRequestd(), result) > 0;
}
}  // namespace

struct FclWorld::Impl {
  // What FCL sees of a group: its mesh, or one ball of it.
  struct Piece {
    std::size_t group = 0;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  // in the link frame [m]
    Object object;
  };
  const Model* model = nullptr;
  RobotParts parts;
  Configuration posture;
  Kinematics kinematics;
  std::vector<Piece> pieces;         // of the groups, one after the other
  std::vector<std::size_t> first{};  // per group and one more, into pieces
  std::vector<Object> obstacles;

  std::vector<int> planned;

  Impl(const Model& m, const RobotParts& p) : model(&m), parts(p), posture(m), kinematics(m) {}

  bool groups_touch(std::size_t i, std::size_t k) {
    for (std::size_t a = first[i]; a < first[i + 1]; ++a) {
      for (std::size_t b = first[k]; b < first[k + 1]; ++b) {
        if (touch(pieces[a].object, pieces[b].object)) return true;
      }
    }
    return false;
  }
};

FclWorld::FclWorld(const Model& model, const RobotParts& parts, const std::vector<int>& planned)
    : impl_(std::make_unique<Impl>(model, parts)) {
  impl_->planned = planned;
  for (std::size_t g = 0; g < parts.groups.size(); ++g) {
    impl_->first.push_back(impl_->pieces.size());
    for (const Ball& ball : parts.groups[g].balls)
      impl_->pieces.push_back(
          {g, ball.center, Object(std::make_shared<fcl::Sphered>(ball.radius))});
    if (!parts.groups[g].balls.empty()) continue;
    const TriangleMesh mesh = link_geometry(parts.shapes[g]).mesh;
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles)
      triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                             static_cast<std::size_t>(t[2]));
    auto model_of = std::make_shared<Mesh>();
    model_of->beginModel();
    model_of->addSubModel(mesh.points, triangles);
    model_of->endModel();
    impl_->pieces.push_back({g, Eigen::Vector3d::Zero(), Object(model_of)});
  }
  impl_->first.push_back(impl_->pieces.size());
}

FclWorld::~FclWorld() = default;

void FclWorld::set_obstacles(const std::vector<Obstacle>& obstacles) {
  impl_->obstacles.clear();
  for (const Obstacle& o : obstacles) {
    std::shared_ptr<fcl::CollisionGeometryd> shape;
    if (o.shape == ObstacleShape::kBox)
      shape = std::make_shared<fcl::Boxd>(o.size.x(), o.size.y(), o.size.z());
    else if (o.shape == ObstacleShape::kSphere)
      shape = std::make_shared<fcl::Sphered>(o.size.x());
    else
      shape = std::make_shared<fcl::Cylinderd>(o.size.x(), o.size.y());
    impl_->obstacles.emplace_back(shape, o.pose);
    impl_->obstacles.back().computeAABB();
  }
}

bool FclWorld::free(const float* q, std::string* touching) {
  Impl& in = *impl_;
  for (std::size_t j = 0; j < in.planned.size(); ++j) in.posture.q[in.planned[j]] = static_cast<double>(q[j]);
  in.kinematics.update(in.posture);
  for (Impl::Piece& piece : in.pieces) {
    piece.object.setTransform(in.kinematics.link_in_world(in.parts.groups[piece.group].link) *
                              Eigen::Translation3d(piece.at));
    piece.object.computeAABB();
  }
  for (std::size_t i = in.pieces.size(); i-- > 0;) {
    const std::size_t group = in.pieces[i].group;
    if (in.parts.groups[group].link == 0) continue;  // what stands still is no matter of the path
    for (std::size_t k = 0; k < in.obstacles.size(); ++k) {
      if (!touch(in.pieces[i].object, in.obstacles[k])) continue;
      if (touching != nullptr)
        *touching = in.parts.names[group] + " and obstacle " + std::to_string(k);
      return false;
    }
  }
  for (const auto& [a, b] : in.parts.pairs) {
    const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
    if (in.parts.groups[i].link == in.parts.groups[k].link || !in.groups_touch(i, k)) continue;
    if (touching != nullptr) *touching = in.parts.names[i] + " and " + in.parts.names[k];
    return false;
  }
  return true;
}

}  // namespace twinbus
