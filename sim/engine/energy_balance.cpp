#include "sim/engine/energy_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/articulated_world.h"
#include "sim/objects/rigid_object_mesh.h"

namespace twinbus::inline sim {

namespace {
// A gain is doubted that is more than this share of what moves and is pressed, or that the world has
// risen by so much over the least it had.
constexpr double kGainShare = 0.01, kRise = 0.03;
constexpr double kLeast = 1e-3;  // [J]

// No number leaves a band without a bound.
void widen(double& band, double value) noexcept {
  band = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(band, value);
}
}  // namespace

EnergyBalance::EnergyBalance(const Model& model, const WorldConfig& config)
    : model_(model),
      silent_(!config.robots.empty()),
      estimated_(config.engine == Engine::kMujoco || config.contact == ContactModel::kSoft),
      mass_scale_(config.mass_scale),
      velocity_(model.links.size() + config.loose.size()),
      own_velocity_(model.links.size()),
      q_(model.joints.size()),
      tau_(model.joints.size()),
      most_gain_(config.bands.gain),
      most_rise_(config.bands.rise) {
  for (const LooseBody& body : config.loose) {
    loose_inertia_.push_back(inertia_of(body));
    loose_mass_.push_back(body.mass);
  }
}

EnergyBalance::Energy EnergyBalance::of(const World& world) noexcept {
  Energy energy;
  // Engine articulated knows it all in a fraction of the time: it is asked after every step.
  if (const auto* known = dynamic_cast<const ArticulatedWorld*>(&world); known != nullptr) {
    const BodyEnergy body = known->energy(velocity_.data(), own_velocity_.data());
    energy.kinetic = body.kinetic;
    energy.potential = body.potential;
  } else {
    for (int i = 0; i < model_.link_count(); ++i) {
      const Link& link = model_.links[at(i)];
      const Eigen::Isometry3d pose = world.link_in_world(i);
      const Eigen::Vector3d com = pose * link.com;
      const Eigen::Vector3d velocity = world.point_velocity(i, com);
      const Eigen::Vector3d spin = pose.linear().transpose() * world.angular_velocity(i);
      velocity_[at(i)] = velocity;
      own_velocity_[at(i)] = pose.linear().transpose() * velocity;
      energy.kinetic += 0.5 * mass_scale_ *
                        (link.mass * velocity.squaredNorm() + spin.dot(link.inertia * spin));
      energy.potential += mass_scale_ * link.mass * kGravity * com.z();
    }
  }
  const Configuration& now = world.configuration();
  for (int j = 0; j < model_.joint_count(); ++j)
    energy.kinetic += 0.5 * model_.joints[at(j)].rotor_inertia * now.qd[j] * now.qd[j];
  for (std::size_t i = 0; i < loose_mass_.size(); ++i) {
    const LooseState body = world.loose(static_cast<int>(i));
    const Eigen::Vector3d spin = body.pose.linear().transpose() * body.angular_velocity;
    velocity_[model_.links.size() + i] = body.velocity;
    energy.kinetic += 0.5 * (loose_mass_[i] * body.velocity.squaredNorm() +
                             spin.dot(loose_inertia_[i] * spin));
    energy.potential += loose_mass_[i] * kGravity * body.pose.translation().z();
  }
  energy.elastic = world.elastic_energy();
  return energy;
}

void EnergyBalance::begin(const World& world) noexcept {
  if (silent_) return;
  before_ = of(world);
  for (std::size_t j = 0; j < q_.size(); ++j) {
    q_[j] = world.configuration().q[static_cast<Eigen::Index>(j)];
    tau_[j] = world.tau(static_cast<int>(j));
  }
  gain_ = sum_ = lowest_ = least_ = 0.0;
}

bool EnergyBalance::add(const World& world, double pushed) noexcept {
  if (silent_) return false;
  const Energy now = of(world);
  const Eigen::VectorXd& angles = world.configuration().q;
  double work = 0.0;
  for (std::size_t j = 0; j < q_.size(); ++j) {
    const double q = angles[static_cast<Eigen::Index>(j)];
    const double tau = world.tau(static_cast<int>(j));
    work += std::max(tau * (q - q_[j]), tau_[j] * (q - q_[j]));
    q_[j] = q;
    tau_[j] = tau;
  }
  if (const double known = world.servo_work(); !std::isnan(known)) work = known;
  gain_ = now.all() - before_.all() - pushed - work;
  const double scale = std::max(now.kinetic + now.elastic, before_.kinetic + before_.elastic);
  before_ = now;
  sum_ += gain_;
  lowest_ = std::min(lowest_, sum_);
  least_ = std::min(least_, sum_);
  if (estimated_) return false;
  const double gains = kGainShare * scale + kLeast, rises = kRise * scale + kLeast;
  if (!(gain_ <= gains)) widen(gain_band_, gain_);
  if (!(sum_ - least_ <= rises)) widen(rise_band_, sum_ - least_);
  const bool risen = sum_ - lowest_ > std::max(rises, most_rise_);
  if (risen) lowest_ = sum_;  // said once
  return risen || !(gain_ <= std::max(gains, most_gain_));
}

}  // namespace twinbus::sim
