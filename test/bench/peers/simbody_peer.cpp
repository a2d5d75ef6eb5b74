// Simbody in free motion: see tree_peer.h.
//
// METHOD: euler (its semi-explicit Euler, one evaluation a step) or merson (Runge-Kutta-Merson, order 4, the integrator that its
// documentation recommends).  Steps are fixed: on motions as smooth as these choosing them would gain it little, and a step
// means the same for every engine.

#include <Simbody.h>

#include "tree_peer.h"

namespace {

namespace sim = SimTK;  // named each time: its comparisons would catch Eigen's

sim::Vec3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

sim::Transform pose(const Eigen::Isometry3d& at) {
  const Eigen::Quaterniond q(at.linear());
  return {sim::Rotation(sim::Quaternion(q.w(), q.x(), q.y(), q.z())), vec(at.translation())};
}

sim::Body::Rigid body(const TreeLink& link) {
  const Eigen::Matrix3d& i = link.inertia;
  const sim::Inertia central(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
  return sim::Body::Rigid(sim::MassProperties(
      link.mass, vec(link.com), central.shiftFromMassCenter(vec(link.com), link.mass)));
}

class Engine {
 public:
  Engine(const Tree& tree, const std::string& method, double h) {
    sim::Force::UniformGravity(forces_, matter_, sim::Vec3(0.0, 0.0, -kTreeGravity));
    for (const TreeLink& link : tree.links) links_.push_back(mobilized(tree.fixed, link));
    sim::State state = system_.realizeTopology();
    if (!tree.fixed) {
      links_[0].setQToFitTransform(state, pose(tree.links[0].placement));
      links_[0].setUToFitVelocity(state,
                                  sim::SpatialVec(vec(tree.angular_velocity), vec(tree.velocity)));
    }
    for (std::size_t i = 1; i < links_.size(); ++i) {
      links_[i].setOneQ(state, 0, tree.links[i].q);
      links_[i].setOneU(state, 0, tree.links[i].qd);
    }
    if (method == "euler") {
      integrator_ = std::make_unique<sim::SemiExplicitEulerIntegrator>(system_, h);
    } else if (method == "merson") {
      integrator_ = std::make_unique<sim::RungeKuttaMersonIntegrator>(system_);
      integrator_->setFixedStepSize(h);
    } else {
      throw std::runtime_error("Simbody: no method " + method);
    }
    integrator_->setReturnEveryInternalStep(true);
    integrator_->initialize(state);
    (void)integrator_->stepTo(sim::Infinity);  // comes back at once, with the start
  }

  void step() { (void)integrator_->stepTo(sim::Infinity); }

  Eigen::Vector3d com(int link) {
    const sim::State& state = integrator_->getState();
    system_.realize(state, sim::Stage::Position);
    const sim::Vec3 at = links_[link].findMassCenterLocationInGround(state);
    return {at[0], at[1], at[2]};
  }

 private:
  sim::MobilizedBody mobilized(bool fixed, const TreeLink& link) {
    if (link.parent < 0) {
      if (fixed)
        return sim::MobilizedBody::Weld(matter_.Ground(), pose(link.placement), body(link),
                                        sim::Transform());
      return sim::MobilizedBody::Free(matter_.Ground(), sim::Transform(), body(link),
                                      sim::Transform());
    }
    const sim::Rotation along(sim::UnitVec3(vec(link.axis)), sim::ZAxis);  // its pins turn about z
    return sim::MobilizedBody::Pin(links_[link.parent],
                                   pose(link.placement) * sim::Transform(along), body(link),
                                   sim::Transform(along));
  }

  sim::MultibodySystem system_;
  sim::SimbodyMatterSubsystem matter_{system_};
  sim::GeneralForceSubsystem forces_{system_};
  std::vector<sim::MobilizedBody> links_;
  std::unique_ptr<sim::Integrator> integrator_;
};

}  // namespace

int main(int argc, char** argv) {
  int major = 0, minor = 0, build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return peer_main<Engine>(argc, argv, std::to_string(major) + "." + std::to_string(minor));
}
