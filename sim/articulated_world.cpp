#include "sim/articulated_world.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics.h"

namespace twinbus {

namespace {

constexpr std::size_t kMostPushes = 16;
// Passes in which all joints change piece at once without fewer being wrong; then one at a time.
constexpr int kPatience = 3;
constexpr int kMostPasses = 60;
constexpr double kNotARotation = 1e-12;  // beyond it the base's attitude is normalised

}  // namespace

ArticulatedWorld::ArticulatedWorld(const Model& model, const WorldConfig& config)
    : config_(config),
      body_(model, config.fixed_base, config.mass_scale),
      ground_(model, config),
      solve_(body_, kMostContacts),
      rows_(model.joints.size()),
      configuration_(model),
      next_(model) {
  for (const Joint& joint : model.joints) joints_.emplace_back(joint, config);
  contacts_.reserve(kMostContacts);
  reported_.reserve(kMostContacts);
  pushes_.reserve(kMostPushes);
  configuration_.q.setZero();
  configuration_.qd.setZero();
  body_.place(configuration_);
}

Status ArticulatedWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  const Status status = check_configuration(joints_.size(), to);
  if (status != Status::kOk) return status;
  configuration_ = to;
  Eigen::Matrix3d attitude = to.base.linear();
  if (!((attitude * attitude.transpose() - Eigen::Matrix3d::Identity()).norm() < kNotARotation)) {
    attitude = Eigen::Quaterniond(attitude).normalized().toRotationMatrix();
    configuration_.base.linear() = attitude;
  }
  if (config_.fixed_base) {
    configuration_.base_velocity.setZero();
    configuration_.base_angular_velocity.setZero();
  }
  body_.place(configuration_);
  for (int side = 0; side < 2; ++side) {
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      ground_.set_corner_offset(side, corner, 0.0);
    }
  }
  ground_.forget();
  estimate_contact_forces();
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    joints_[j].set_tau(known ? (*tau)[static_cast<Eigen::Index>(j)] : 0.0);
  }
  pushes_.clear();
  frozen_ = false;
  return Status::kOk;
}

Status ArticulatedWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  if (joint < 0 || at(joint) >= joints_.size()) return Status::kWrongSize;
  const Status status = check_target(target);
  if (status != Status::kOk) return status;
  ServoTarget scaled = target;
  scaled.kp *= config_.servo_kp_scale;
  scaled.kd *= config_.servo_kd_scale;
  joints_[at(joint)].set_target(scaled);
  return Status::kOk;
}

Status ArticulatedWorld::push(int link, const Eigen::Vector3d& point,
                              const Eigen::Vector3d& force) noexcept {
  if (link < 0 || link >= body_.link_count()) return Status::kWrongSize;
  if (!point.allFinite() || !force.allFinite()) return Status::kNotFinite;
  if (!(point.cwiseAbs().maxCoeff() <= kMaxDistance) ||
      !(force.cwiseAbs().maxCoeff() <= kMaxPush) || pushes_.size() == kMostPushes) {
    return Status::kOutOfRange;
  }
  pushes_.push_back({link, point, force});
  return Status::kOk;
}

void ArticulatedWorld::set_corner_offset(int sole, int corner, double offset) noexcept {
  if (std::isfinite(offset)) ground_.set_corner_offset(sole, corner, offset);
}

double ArticulatedWorld::corner_offset(int sole, int corner) const noexcept {
  return ground_.corner_offset(sole, corner);
}

Status ArticulatedWorld::step() noexcept {
  if (frozen_) return Status::kDiverged;
  const double h = config_.step;
  next_ = configuration_;
  Momentum momentum = body_.momentum();
  const bool solved = solve_step();
  if (solved) body_.advance(h, next_);
  if (!solved || check_configuration(joints_.size(), next_) != Status::kOk) {
    body_.place(configuration_);
    frozen_ = true;
    return Status::kDiverged;
  }
  configuration_ = next_;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    joints_[j].finish(configuration_.qd[static_cast<Eigen::Index>(j)]);
  }
  ground_.remember(contacts_, h);
  report_contacts();
  body_.place(configuration_);
  if (!config_.fixed_base && in_flight()) {
    momentum.linear.z() -= h * body_.mass() * kGravity;
    for (const Push& push : pushes_) {
      momentum.linear += h * push.force;
      momentum.angular += h * (push.point - momentum.com).cross(push.force);
    }
    momentum.com += h / body_.mass() * momentum.linear;
    body_.keep_momentum(momentum, configuration_);
  }
  pushes_.clear();
  return Status::kOk;
}

// False: an inertia was not positive.
bool ArticulatedWorld::solve_step() noexcept {
  const double h = config_.step;
  ground_.find(body_, h, contacts_);
  for (const Push& push : pushes_) {
    body_.add_force(push.link, push.point - body_.origin(), push.force);
  }
  solve_.fold(body_, contacts_, h);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    joints_[j].begin(configuration_.q[index], configuration_.qd[index], h);
  }
  // Block pivoting (Judice and Pires 1994): all joints that are wrong change piece at once while
  // that makes fewer of them; else the last one alone does, which cannot cycle.
  int fewest = static_cast<int>(joints_.size()) + 1;
  int patience = kPatience;
  for (int pass = 0;; ++pass) {
    for (std::size_t j = 0; j < joints_.size(); ++j) rows_[j] = joints_[j].row();
    if (!body_.inward(rows_, h)) return false;
    body_.outward();
    solve_.solve(body_, contacts_, h);
    int wrong = 0;
    std::size_t last = 0;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].holds(end_speed(j))) continue;
      ++wrong;
      last = j;
    }
    if (wrong == 0) return true;
    if (pass == kMostPasses) {
      ++unsettled_;
      return true;
    }
    ++joint_passes_;
    if (wrong < fewest) {
      fewest = wrong;
      patience = kPatience;
    } else if (patience > 0) {
      --patience;
    }
    for (std::size_t j = patience > 0 ? 0 : last; j <= last; ++j) joints_[j].approach(end_speed(j));
  }
}

bool ArticulatedWorld::in_flight() const noexcept {
  return std::all_of(contacts_.begin(), contacts_.end(),
                     [](const Contact& c) { return c.now.mode == ContactMode::kOpen; });
}

double ArticulatedWorld::end_speed(std::size_t joint) const noexcept {
  return configuration_.qd[static_cast<Eigen::Index>(joint)] +
         config_.step * body_.link(static_cast<int>(joint) + 1).qdd;
}

void ArticulatedWorld::report_contacts() noexcept {
  reported_.clear();
  for (const Contact& c : contacts_) {
    if (c.now.mode == ContactMode::kOpen && !(c.depth > 0.0)) continue;
    reported_.push_back({.link = c.link,
                         .sole = c.sole,
                         .point = c.point,
                         .force = c.now.force,
                         .depth = std::max(0.0, c.depth)});
  }
}

void ArticulatedWorld::estimate_contact_forces() noexcept {
  ground_.find(body_, 0.0, contacts_);
  for (Contact& c : contacts_) {
    const double fn = c.params.stiffness * c.depth -
                      (c.params.damping + config_.step * c.params.stiffness) * c.normal.dot(c.v0);
    c.now.force = std::max(0.0, fn) * c.normal;
    c.now.mode = ContactMode::kStick;
  }
  report_contacts();
}

double ArticulatedWorld::encoder(int joint) const noexcept {
  return configuration_.q[joint] + joints_[at(joint)].play();
}

double ArticulatedWorld::tau(int joint) const noexcept { return joints_[at(joint)].tau(); }

Eigen::Isometry3d ArticulatedWorld::link_in_world(int link) const noexcept {
  const LinkWork& l = body_.link(link);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = l.rotation;
  pose.translation() = body_.origin() + l.origin;
  return pose;
}

Eigen::Vector3d ArticulatedWorld::point_velocity(int link,
                                                 const Eigen::Vector3d& point) const noexcept {
  return at_point(body_.link(link).velocity, point - body_.origin());
}

Eigen::Vector3d ArticulatedWorld::angular_velocity(int link) const noexcept {
  return angular(body_.link(link).velocity);
}

Eigen::Vector3d ArticulatedWorld::com() const noexcept {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < body_.link_count(); ++i) sum += body_.link_mass(i) * body_.link(i).com;
  return body_.origin() + sum / body_.mass();
}

Eigen::Vector3d ArticulatedWorld::com_velocity() const noexcept {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < body_.link_count(); ++i) {
    sum += body_.link_mass(i) * at_point(body_.link(i).velocity, body_.link(i).com);
  }
  return sum / body_.mass();
}

double ArticulatedWorld::corner_stiffness(int sole) const noexcept {
  return ground_.sole_params(sole).stiffness;
}

double ArticulatedWorld::corner_damping(int sole) const noexcept {
  return ground_.sole_params(sole).damping;
}

}  // namespace twinbus
