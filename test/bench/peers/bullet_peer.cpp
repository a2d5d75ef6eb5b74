// Bullet's btMultiBody, in double precision, in free motion: see tree_peer.h.
//
// METHOD: euler (its own, semi-implicit) or rk4, which is of order 4 on a fixed base and of order 1 on a floating one.
// The damping that it adds by itself is taken away.

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletCollisionCommon.h>

#include <Eigen/Eigenvalues>

#include "tree_peer.h"

namespace {

btVector3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

btQuaternion quat(const Eigen::Matrix3d& turn) {
  const Eigen::Quaterniond q(turn);
  return {q.x(), q.y(), q.z(), q.w()};
}

// Its links stand in their centres of mass, along their principal axes.
struct Principal {
  explicit Principal(const TreeLink& link) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(link.inertia);
    moments = solver.eigenvalues();
    axes = solver.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  }
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;  // columns, in the link's frame
};

class Engine {
 public:
  Engine(const Tree& tree, const std::string& method, double h) : h_(h) {
    if (method != "euler" && method != "rk4") throw std::runtime_error("Bullet has no " + method);
    const TreeLink& base = tree.links[0];
    std::vector<Principal> own(tree.links.begin(), tree.links.end());
    const int joints = static_cast<int>(tree.links.size()) - 1;
    body_ =
        std::make_unique<btMultiBody>(joints, base.mass, vec(own[0].moments), tree.fixed, false);
    for (int j = 0; j < joints; ++j) {
      const TreeLink& link = tree.links[j + 1];
      const Eigen::Matrix3d to_parent = own[link.parent].axes.transpose();
      const Eigen::Matrix3d to_own = own[j + 1].axes.transpose();
      const Eigen::Vector3d pivot = link.placement.translation() - tree.links[link.parent].com;
      body_->setupRevolute(
          j, link.mass, vec(own[j + 1].moments), link.parent - 1,
          quat(to_own * link.placement.linear().transpose() * to_parent.transpose()),
          vec(to_own * link.axis), vec(to_parent * pivot), vec(to_own * link.com), true);
    }
    body_->finalizeMultiDof();
    body_->setLinearDamping(0.0);
    body_->setAngularDamping(0.0);
    body_->setMaxCoordinateVelocity(1e9);
    body_->useRK4Integration(method == "rk4");
    body_->setBasePos(vec(base.placement * base.com));
    body_->setWorldToBaseRot(quat((base.placement.linear() * own[0].axes).transpose()));
    const Eigen::Vector3d arm = base.placement.linear() * base.com;
    body_->setBaseVel(vec(tree.velocity + tree.angular_velocity.cross(arm)));
    body_->setBaseOmega(vec(tree.angular_velocity));
    for (int j = 0; j < joints; ++j) {
      body_->setJointPos(j, tree.links[j + 1].q);
      body_->setJointVel(j, tree.links[j + 1].qd);
    }
    world_.setGravity({0.0, 0.0, -kTreeGravity});
    world_.addMultiBody(body_.get());
  }
  ~Engine() { world_.removeMultiBody(body_.get()); }

  void step() { world_.stepSimulation(h_, 0); }

  Eigen::Vector3d com(int link) {
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    body_->forwardKinematics(turns, places);
    const btVector3 at = link == 0 ? body_->getBasePos()
                                   : body_->getLink(link - 1).m_cachedWorldTransform.getOrigin();
    return {at.x(), at.y(), at.z()};
  }

 private:
  double h_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::unique_ptr<btMultiBody> body_;
};

}  // namespace

int main(int argc, char** argv) {
  const int version = btGetVersion();
  return peer_main<Engine>(argc, argv,
                           std::to_string(version / 100) + "." + std::to_string(version % 100));
}
