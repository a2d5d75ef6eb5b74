#include "sim/engine/twinned_world.h"

#include <algorithm>

#include "common/math/index.h"
#include "sim/engine/make_world.h"

namespace twinbus {

namespace {

WorldConfig without_twin(WorldConfig config, double times) {
  config.twin = false;
  config.step *= times;
  return config;
}

bool same(const ServoTarget& a, const ServoTarget& b) noexcept {
  return a.q == b.q && a.qd == b.qd && a.tau == b.tau && a.kp == b.kp && a.kd == b.kd;
}

}  // namespace

TwinnedWorld::TwinnedWorld(const Model& model, const WorldConfig& config)
    : world_(make_world(model, without_twin(config, 1.0))),
      twin_(make_world(model, without_twin(config, 2.0))),
      step_(config.step),
      before_(model.links.size() + config.loose.size()),
      after_(before_.size()),
      points_(before_.size()),
      targets_(model.joints.size()) {
  for (const Link& link : model.links) coms_.push_back(link.com);
}

Status TwinnedWorld::set(const Configuration& configuration, const Eigen::VectorXd* tau) noexcept {
  const Status status = world_->set(configuration, tau);
  if (status != Status::kOk) return status;
  if (!watched_) {  // it stood still meanwhile
    for (std::size_t j = 0; j < targets_.size(); ++j) (void)twin_->set_servo(static_cast<int>(j), targets_[j]);
    for (int i = 0; i < world_->loose_count(); ++i) (void)twin_->set_loose(i, world_->loose(i));
  }
  watched_ = twin_->set(configuration, tau) == Status::kOk;
  halfway_ = stepped_ = false;
  return status;
}

Status TwinnedWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  const Status status = world_->set_servo(joint, target);
  if (status != Status::kOk) return status;
  if (stepped_ && !same(target, targets_[at(joint)])) watched_ = false;
  targets_[at(joint)] = target;
  if (watched_) (void)twin_->set_servo(joint, target);
  return status;
}

// Of one step of the world, which is half of one of the twin.
Status TwinnedWorld::push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  const Status status = world_->push(link, point, force);
  if (status == Status::kOk && watched_) (void)twin_->push(link, point, 0.5 * force);
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
  bool coarse = false;
  if (watched_ && !halfway_) {
    look(*twin_, before_);
    coarse = twin_->step() != Status::kOk;
    watched_ = !coarse;
    look(*twin_, after_);
  }
  const Status status = world_->step();
  trust_ = world_->trust();
  stepped_ = true;
  if (status != Status::kOk) return status;
  if (watched_) {
    look(*world_, points_);
    halfway_ = !halfway_;
    coarse = !(apart() <= kApart);
  }
  trust_[Doubt::kCoarse] = coarse;
  return status;
}

void TwinnedWorld::look(const World& world, std::vector<Point>& points) const noexcept {
  const int links = static_cast<int>(coms_.size());
  for (int i = 0; i < links; ++i) {
    const Eigen::Vector3d place = world.link_in_world(i) * coms_[at(i)];
    points[at(i)] = {place, world.point_velocity(i, place)};
  }
  for (int i = 0; i < world.loose_count(); ++i) {
    const LooseState body = world.loose(i);
    points[at(links + i)] = {body.pose.translation(), body.velocity};
  }
}

// The largest distance of the two; halfway through the twin's step, from the cubic with its ends' places and speeds.
double TwinnedWorld::apart() const noexcept {
  double most = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Eigen::Vector3d twin = after_[i].place;
    if (halfway_)
      twin = 0.5 * (before_[i].place + after_[i].place) + 0.25 * step_ * (before_[i].velocity - after_[i].velocity);
    const double distance = (points_[i].place - twin).norm();
    if (!(distance <= most)) most = distance;
  }
  return most;
}

}  // namespace twinbus
