#include "sim/engine/welded_world.h"

#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "sim/engine/make_world.h"

namespace twinbus::inline sim {

namespace {

// Held joints that stand this near to where they were welded are left there [rad or m].
constexpr double kSamePlace = 1e-12;

OtherRobot rigid_robot(const OtherRobot& robot, const WeldedModel& welded, bool still) {
  OtherRobot rigid;
  rigid.name = robot.name;
  auto model = std::make_shared<Model>(welded.model);
  model->floating_base = model->floating_base && !still;
  rigid.model = std::move(model);
  rigid.start = Configuration(welded.model);
  rigid.start.base = robot.start.base;
  return rigid;
}

}  // namespace

WeldedWorld::WeldedWorld(const Model& model, const WorldConfig& config) : model_(model), config_(config), now_(model) {
  const Eigen::Index joints = model.joint_count();
  held_ = config.held;
  held_.resize(model.joints.size() + 1 + config.robots.size(), false);
  const std::vector<bool> still(held_.begin() + joints, held_.end());
  held_.resize(model.joints.size());
  still_ = still[0] && !config.fixed_base;
  hold_followers(model, held_);
  config_.held.clear();
  config_.rigid_robots.clear();
  robots_.resize(config.robots.size());
  for (std::size_t i = 0; i < config.robots.size(); ++i) {
    if (!still[i + 1] && (i >= config.rigid_robots.size() || !config.rigid_robots[i])) continue;
    const OtherRobot& robot = config.robots[i];
    robots_[i] = std::make_unique<WeldedModel>(
        weld(*robot.model, std::vector<bool>(robot.model->joints.size(), true), robot.start.q));
    config_.robots[i] = rigid_robot(robot, *robots_[i], still[i + 1]);
  }
  held_tau_ = Eigen::VectorXd::Zero(joints);
  build(Eigen::VectorXd::Zero(joints));
  look();
}

TieEnd WeldedWorld::end_of(TieEnd end, const WeldedModel& welded) const {
  if (end.link < 0) return end;
  const WeldedModel* whose = end.robot < 0 ? &welded : robots_[at(end.robot)].get();
  if (whose == nullptr) return end;
  end.point = whose->in_link[at(end.link)] * end.point;
  end.link = whose->link[at(end.link)];
  return end;
}

void WeldedWorld::build(const Eigen::VectorXd& q) {
  auto welded = std::make_unique<WeldedModel>(weld(model_, held_, q));
  WorldConfig config = config_;
  config.fixed_base = config.fixed_base || still_;
  for (auto* list : {&config.aloft, &config.untouched}) {
    for (auto& [link, shape] : *list) {
      if (shape < 0) continue;
      shape += welded->first_shape[at(link)];
      link = welded->link[at(link)];
    }
  }
  for (Tie& tie : config.ties) {
    tie.a = end_of(tie.a, *welded);
    tie.b = end_of(tie.b, *welded);
    if (tie.a.link >= 0 && tie.a.link == tie.b.link && tie.a.robot == tie.b.robot)
      throw std::runtime_error("both ends of a loop or grasp are on " +
                               model_.links[at(welded->former_link[at(tie.a.link)])].name +
                               " once its joints are held");
  }
  world_ = make_world(welded->model, config);
  welded_ = std::move(welded);  // the former one's world has ended
  moving_.clear();
  for (int j = 0; j < model_.joint_count(); ++j) {
    if (welded_->joint[at(j)] >= 0) moving_.push_back({j, welded_->joint[at(j)]});
  }
  inner_ = Configuration(welded_->model);
  inner_tau_ = Eigen::VectorXd::Zero(welded_->model.joint_count());
}

void WeldedWorld::stand() {
  WorldConfig alone = config_;
  alone.robots.clear();
  alone.loose.clear();
  alone.ties.clear();
  alone.self_contact = false;
  const auto world = make_world(welded_->model, alone);
  if (world->set(inner_, &inner_tau_) != Status::kOk) throw std::runtime_error("it cannot stand there");
  standing_ = world->contacts();
  std::erase_if(standing_, [](const ContactPoint& contact) { return contact.link != 0; });  // those the engine finds itself
}

Status WeldedWorld::set(const Configuration& configuration, const Eigen::VectorXd* tau) noexcept {
  const Status status = check_configuration(model_.joints.size(), configuration);
  if (status != Status::kOk) return status;
  bool same = true;
  for (int j = 0; j < model_.joint_count(); ++j)
    same = same && !(held_[at(j)] && std::abs(configuration.q[j] - now_.q[j]) > kSamePlace);
  if (!same) {
    try {
      build(configuration.q);
    } catch (const std::exception&) {
      return Status::kOutOfRange;
    }
  }
  inner_.base = configuration.base;
  inner_.base_velocity = configuration.base_velocity;
  inner_.base_angular_velocity = configuration.base_angular_velocity;
  for (int j = 0; j < model_.joint_count(); ++j) {
    const int to = welded_->joint[at(j)];
    if (tau != nullptr) (to < 0 ? held_tau_[j] : inner_tau_[to]) = (*tau)[j];
    if (to < 0) {
      now_.q[j] = configuration.q[j];
      now_.qd[j] = 0.0;
      continue;
    }
    inner_.q[to] = configuration.q[j];
    inner_.qd[to] = configuration.qd[j];
  }
  try {
    if (still_) stand();
  } catch (const std::exception&) {
    return Status::kOutOfRange;
  }
  const Status placed = world_->set(inner_, tau != nullptr ? &inner_tau_ : nullptr);
  look();
  return placed;
}

Status WeldedWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  if (!is_joint(joint)) return Status::kOutOfRange;
  const int to = welded_->joint[at(joint)];
  return to < 0 ? check_target(target) : world_->set_servo(to, target);
}

Status WeldedWorld::push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  if (!is_link(link)) return Status::kOutOfRange;
  return world_->push(welded_->link[at(link)], point, force);
}

void WeldedWorld::estimate_contact_forces() noexcept {
  world_->estimate_contact_forces();
  look();
}

Status WeldedWorld::step() noexcept {
  const Status status = world_->step();
  look();
  return status;
}

void WeldedWorld::look() noexcept {
  const Configuration& inner = world_->configuration();
  now_.base = inner.base;
  now_.base_velocity = inner.base_velocity;
  now_.base_angular_velocity = inner.base_angular_velocity;
  for (const auto& [to, from] : moving_) {
    now_.q[to] = inner.q[from];
    now_.qd[to] = inner.qd[from];
  }
  contacts_ = world_->contacts();
  contacts_.insert(contacts_.end(), standing_.begin(), standing_.end());
  for (ContactPoint& contact : contacts_) {
    if (contact.link >= 0) contact.link = welded_->former_link[at(contact.link)];
  }
  trust_ = world_->trust();
}

double WeldedWorld::encoder(int joint) const noexcept {
  if (!is_joint(joint)) return 0.0;
  const int from = welded_->joint[at(joint)];
  return from < 0 ? now_.q[joint] : world_->encoder(from);
}

double WeldedWorld::tau(int joint) const noexcept {
  if (!is_joint(joint)) return 0.0;
  const int from = welded_->joint[at(joint)];
  return from < 0 ? held_tau_[joint] : world_->tau(from);
}

Eigen::Isometry3d WeldedWorld::link_in_world(int link) const noexcept {
  if (!is_link(link)) return Eigen::Isometry3d::Identity();
  return world_->link_in_world(welded_->link[at(link)]) * welded_->in_link[at(link)];
}

Eigen::Vector3d WeldedWorld::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  if (!is_link(link)) return Eigen::Vector3d::Zero();
  return world_->point_velocity(welded_->link[at(link)], point);
}

Eigen::Vector3d WeldedWorld::angular_velocity(int link) const noexcept {
  if (!is_link(link)) return Eigen::Vector3d::Zero();
  return world_->angular_velocity(welded_->link[at(link)]);
}

Eigen::Isometry3d WeldedWorld::robot_link(int robot, int link) const noexcept {
  if (robot < 0 || robot >= static_cast<int>(robots_.size())) return world_->robot_link(robot, link);
  const WeldedModel* rigid = robots_[at(robot)].get();
  if (rigid == nullptr || link < 0 || link >= static_cast<int>(rigid->link.size())) return world_->robot_link(robot, link);
  return world_->robot_link(robot, rigid->link[at(link)]) * rigid->in_link[at(link)];
}

}  // namespace twinbus::sim
