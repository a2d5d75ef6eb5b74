#include "launcher/figures/loose_watch.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "sim/objects/rigid_object_mesh.h"

namespace twinbus::inline launcher {

namespace {

// A value that is no number stays.
void keep_most(double value, double& most) {
  if (!std::isnan(most) && !(value <= most)) most = value;
}

int middle_axis(const Eigen::Vector3d& inertia) {
  int low = 0, high = 0;
  inertia.minCoeff(&low);
  inertia.maxCoeff(&high);
  return low == high ? 1 : 3 - low - high;
}

}  // namespace

LooseWatch::LooseWatch(const Scene& scene) {
  for (const LooseBody& body : scene.loose) {
    mass_.push_back(body.mass);
    inertia_.push_back(inertia_of(body));
  }
  for (const SpinAsked& asked : scene.criteria.spins) {
    const auto is_it = [&](const LooseBody& body) { return body.name == asked.name; };
    Spin spin;
    spin.body = static_cast<int>(std::find_if(scene.loose.begin(), scene.loose.end(), is_it) -
                                 scene.loose.begin());
    spin.middle = middle_axis(inertia_[at(spin.body)].diagonal());
    spins_.push_back(spin);
  }
}

void LooseWatch::add(const World& world) {
  double energy = 0.0;
  for (int i = 0; i < world.loose_count(); ++i) {
    const LooseState now = world.loose(i);
    const Eigen::Vector3d spin = now.pose.linear().transpose() * now.angular_velocity;
    energy +=
        mass_[at(i)] * (0.5 * now.velocity.squaredNorm() + kGravity * now.pose.translation().z()) +
        0.5 * spin.dot(inertia_[at(i)] * spin);
  }
  if (!begun_) first_ = energy;
  keep_most(std::abs(energy - first_), drift_);
  keep_most(energy - first_, gain_);
  for (Spin& spin : spins_) {
    const LooseState now = world.loose(spin.body);
    const Eigen::Vector3d turn = now.pose.linear().transpose() * now.angular_velocity;
    const Eigen::Vector3d momentum = now.pose.linear() * (inertia_[at(spin.body)] * turn);
    const double turning = 0.5 * momentum.dot(now.angular_velocity);
    if (!begun_) {
      spin.first_energy = turning;
      spin.first_momentum = momentum;
    }
    keep_most(std::abs(turning / spin.first_energy - 1.0), spin.energy_drift);
    keep_most((momentum - spin.first_momentum).norm() / spin.first_momentum.norm(),
              spin.momentum_drift);
    const double side = turn[spin.middle] > 0.0 ? 1.0 : -1.0;
    if (begun_ && side != spin.side) ++spin.flips;
    spin.side = side;
  }
  begun_ = true;
}

}  // namespace twinbus::launcher
