// DART in free motion: see tree_peer.h.  METHOD: euler (semi-implicit), the only one that its world has.

#include <dart/config.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "tree_peer.h"

namespace {

using namespace dart::dynamics;

class Engine {
 public:
  Engine(const Tree& tree, const std::string& method, double h) {
    if (method != "euler") throw std::runtime_error("DART has no " + method);
    for (const TreeLink& link : tree.links) {
      BodyNode* const body = link.parent < 0 ? base(tree) : hinge(link);
      body->setInertia(Inertia(link.mass, link.com, link.inertia));
      bodies_.push_back(body);
    }
    world_->setGravity({0.0, 0.0, -kTreeGravity});
    world_->setTimeStep(h);
    world_->addSkeleton(skeleton_);
  }

  void step() { world_->step(); }

  Eigen::Vector3d com(int link) const { return bodies_[link]->getCOM(); }

 private:
  BodyNode* base(const Tree& tree) {
    const Eigen::Isometry3d& at = tree.links[0].placement;
    if (tree.fixed) {
      const auto [joint, body] = skeleton_->createJointAndBodyNodePair<WeldJoint>();
      joint->setTransformFromParentBodyNode(at);
      return body;
    }
    const auto [joint, body] = skeleton_->createJointAndBodyNodePair<FreeJoint>();
    joint->setTransform(at);
    joint->setLinearVelocity(tree.velocity);
    joint->setAngularVelocity(tree.angular_velocity);
    return body;
  }

  BodyNode* hinge(const TreeLink& link) {
    const std::string name =
        std::to_string(bodies_.size());  // it tells of names that it must make up
    RevoluteJoint::Properties properties;
    properties.mName = "joint" + name;
    const auto [joint, body] = skeleton_->createJointAndBodyNodePair<RevoluteJoint>(
        bodies_[link.parent], properties, BodyNode::AspectProperties("link" + name));
    joint->setTransformFromParentBodyNode(link.placement);
    joint->setAxis(link.axis);
    joint->setPosition(0, link.q);
    joint->setVelocity(0, link.qd);
    return body;
  }

  SkeletonPtr skeleton_ = Skeleton::create("robot");
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  std::vector<BodyNode*> bodies_;
};

}  // namespace

int main(int argc, char** argv) { return peer_main<Engine>(argc, argv, DART_VERSION); }
