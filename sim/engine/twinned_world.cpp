#include "sim/engine/twinned_world.h"

#include <cmath>

#include "common/math/index.h"
#include "sim/engine/make_world.h"

namespace twinbus::inline sim {

namespace {

WorldConfig without_twin(WorldConfig config, double times) {
  config.twin = false;
  config.step *= times;
  return config;
}

// Of the distance of a world from one of half its step: its error.
double error_share(const WorldConfig& config) {
  const int order = config.engine == Engine::kArticulated ? config.order : 1;
  return 1.0 / (1.0 - std::pow(0.5, order));
}

bool same(const ServoTarget& a, const ServoTarget& b) noexcept {
  return a.q == b.q && a.qd == b.qd && a.tau == b.tau && a.kp == b.kp && a.kd == b.kd;
}

}  // namespace

TwinnedWorld::TwinnedWorld(const Model& model, const WorldConfig& config)
    : world_(make_world(model, without_twin(config, 1.0))),
      twin_(make_world(model, without_twin(config, 0.5))),
      allowed_(config.accuracy / error_share(config)),
      targets_(model.joints.size()),
      tau_(model.joint_count()) {
  for (const Link& link : model.links) coms_.push_back(link.com);
  pushes_.reserve(kMostPushes);
}

Status TwinnedWorld::set(const Configuration& configuration, const Eigen::VectorXd* tau) noexcept {
  const Status status = world_->set(configuration, tau);
  if (status != Status::kOk) return status;
  watched_ = twin_->set(configuration, tau) == Status::kOk;
  pushes_.clear();
  stepped_ = driven_ = false;
  return status;
}

Status TwinnedWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  const Status status = world_->set_servo(joint, target);
  if (status != Status::kOk) return status;
  driven_ = driven_ || (stepped_ && !same(target, targets_[at(joint)]));
  targets_[at(joint)] = target;
  (void)twin_->set_servo(joint, target);
  return status;
}

Status TwinnedWorld::push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  const Status status = world_->push(link, point, force);
  if (status == Status::kOk && pushes_.size() < kMostPushes) pushes_.push_back({link, point, force});
  return status;
}

void TwinnedWorld::set_corner_offset(int sole, int corner, double offset) noexcept {
  world_->set_corner_offset(sole, corner, offset);
  twin_->set_corner_offset(sole, corner, offset);
}

Status TwinnedWorld::set_loose(int body, const LooseState& state) noexcept {
  const Status status = world_->set_loose(body, state);
  if (status == Status::kOk) (void)twin_->set_loose(body, state);
  return status;
}

Status TwinnedWorld::hold(int tie, bool holds) noexcept {
  const Status status = world_->hold(tie, holds);
  if (status == Status::kOk) (void)twin_->hold(tie, holds);
  return status;
}

Status TwinnedWorld::step() noexcept {
  for (int half = 0; half < 2 && watched_; ++half) {
    for (const Push& push : pushes_) (void)twin_->push(push.link, push.point, push.force);
    watched_ = twin_->step() == Status::kOk;
  }
  pushes_.clear();
  const Status status = world_->step();
  trust_ = world_->trust();
  stepped_ = true;
  if (status != Status::kOk) return status;
  trust_[Doubt::kCoarse] = !watched_ || !(apart() <= allowed_);
  if (driven_ && trust_[Doubt::kCoarse]) meet();
  return status;
}

// The twin goes on from where the world is.
void TwinnedWorld::meet() noexcept {
  for (Eigen::Index j = 0; j < tau_.size(); ++j) tau_[j] = world_->tau(static_cast<int>(j));
  watched_ = twin_->set(world_->configuration(), &tau_) == Status::kOk;
  for (int i = 0; i < world_->loose_count(); ++i) watched_ = twin_->set_loose(i, world_->loose(i)) == Status::kOk && watched_;
}

// The largest distance of a centre of mass of the two.
double TwinnedWorld::apart() const noexcept {
  double most = 0.0;
  const auto look = [&most](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double distance = (a - b).norm();
    if (!(distance <= most)) most = distance;
  };
  for (std::size_t i = 0; i < coms_.size(); ++i) {
    const auto link = static_cast<int>(i);
    look(world_->link_in_world(link) * coms_[i], twin_->link_in_world(link) * coms_[i]);
  }
  for (int i = 0; i < world_->loose_count(); ++i) look(world_->loose(i).pose.translation(), twin_->loose(i).pose.translation());
  return most;
}

}  // namespace twinbus::sim
