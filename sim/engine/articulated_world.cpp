#include "sim/engine/articulated_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/time/part_clock.h"
#include "robot/description/model.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline sim {

namespace {

constexpr std::size_t kMostPushes = 16;
// Passes in which all joints change piece at once without fewer being wrong; then one at a time.
constexpr int kPatience = 3;
constexpr int kMostPasses = 60;
constexpr double kNewtonWork = 0.3;  // of an iteration of Newton's, in passes over the links
constexpr int kSettleParts = 256;  // of a step, at most
constexpr std::uint64_t kNoContact = 0xcbf29ce484222325ULL;

// Whether it acts on the robot as a whole; whether the other side is fixed.
bool of_robot(const Contact& c) { return (c.system == 0) != (c.other_system == 0); }
bool within_robot(const Contact& c) { return c.system == 0 && c.other_system == 0; }
bool holds_robot(const Contact& c) { return c.system == 0 && c.other_system < 0; }
ContactPoint felt(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) {
  return {.link = link, .sole = -1, .point = point, .force = force, .depth = 0.0, .tie = true};
}
constexpr double kNotARotation = 1e-12;  // beyond it the base's attitude is normalised

}  // namespace

ArticulatedWorld::ArticulatedWorld(const Model& model, const WorldConfig& config)
    : config_(config),
      body_(model, config.fixed_base, config.mass_scale),
      ground_(model, config),
      loose_(model, config, body_),
      ties_(model, config),
      solve_(loose_.systems(), loose_.most_contacts() + ties_.count()),
      flight_(model, config),
      rows_(model.joints.size()),
      configuration_(model),
      start_(model),
      coarse_{Configuration(model), Configuration(model)},
      next_(model) {
  for (const Joint& joint : model.joints) joints_.emplace_back(joint, config);
  for (const PassiveJoint& p : passive_joints_of(model)) joints_[at(p.joint)].make_spring(p.stiffness, p.rest);
  motors_ = MotorLimits(model, joints_);
  contacts_.reserve(at(loose_.most_contacts() + ties_.count()));
  reported_.reserve(at(2 * (loose_.most_contacts() + ties_.count())));
  pushes_.reserve(kMostPushes);
  deep_.reserve(contacts_.capacity());
  begin_apart();
  if (config.contact == ContactModel::kSoft) soft_.emplace(model, config);
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
    for (int corner = 0; corner < kSoleCorners; ++corner) ground_.set_corner_offset(side, corner, 0.0);
  }
  ground_.forget();
  estimate_contact_forces();
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    joints_[j].set_tau(known ? (*tau)[static_cast<Eigen::Index>(j)] : 0.0);
  }
  pushes_.clear();
  flight_.interrupt();
  part_ = apart_.part = most_parts();
  apart_.contacts.clear();
  held_ = 0;
  calm_ = true;
  placed_ = true;
  frozen_ = false;
  return Status::kOk;
}

bool ArticulatedWorld::resume(const ArticulatedWorld& other) noexcept {
  if (loose_.count() > 0 || !loose_.robots().empty() || !config_.ties.empty()) return false;
  configuration_ = other.configuration_;
  ground_ = other.ground_;
  if (soft_ && other.soft_) soft_->resume(*other.soft_);
  joints_ = other.joints_;
  flight_ = other.flight_;
  pushes_ = other.pushes_;
  reported_ = other.reported_;
  part_ = other.part_;
  held_ = other.held_;
  calm_ = other.calm_;
  converged_ = other.converged_;
  airborne_ = other.airborne_;
  before_ = other.before_;
  frozen_ = other.frozen_;
  deep_ = other.deep_;
  placed_ = other.placed_;
  body_.place(configuration_);
  return true;
}

Status ArticulatedWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  if (joint < 0 || at(joint) >= joints_.size()) return Status::kWrongSize;
  const Status status = check_target(target);
  if (status != Status::kOk) return status;
  ServoTarget scaled = target;
  scaled.kp *= config_.servo_kp_scale;
  scaled.kd *= config_.servo_kd_scale;
  joints_[at(joint)].set_target(scaled);
  flight_.interrupt();
  return Status::kOk;
}

Status ArticulatedWorld::set_loose(int body, const LooseState& state) noexcept {
  if (body < 0 || body >= loose_.count()) return Status::kWrongSize;
  const Status status = check_loose(state);
  if (status != Status::kOk) return status;
  loose_.set(body, state);
  placed_ = true;
  frozen_ = false;
  return Status::kOk;
}

Status ArticulatedWorld::hold(int tie, bool holds) noexcept {
  flight_.interrupt();
  return ties_.hold(tie, holds, loose_.systems());
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
  trust_ = {};
  work_ = kUnknown;
  const long unconverged = unconverged_, unsettled = unsettled_;
  const Status status = take_step();
  trust_[Doubt::kUnconverged] = unconverged_ > unconverged;
  trust_[Doubt::kUnsettled] = unsettled_ > unsettled;
  placed_ = false;
  return status;
}

Status ArticulatedWorld::take_step() noexcept {
  if (frozen_) return Status::kDiverged;
  if (fly()) return Status::kOk;
  start_ = configuration_;
  loose_.save();
  const bool in_parts = config_.order > 1, apart = config_.local_error > 0.0;
  const bool advanced = apart ? advance_apart() : in_parts ? advance_in_parts() : advance_settled();
  solve_.hurry(false);
  if (!advanced) {
    configuration_ = start_;
    body_.place(configuration_);
    loose_.restore();
    frozen_ = true;
    return Status::kDiverged;
  }
  rest();
  report_contacts();
  pushes_.clear();
  return Status::kOk;
}

bool ArticulatedWorld::fly() noexcept {
  if (config_.flight == Flight::kImplicit || !loose_.robots().empty()) return false;
  if (!pushes_.empty()) {
    flight_.interrupt();
    return false;
  }
  find_contacts(config_.step);
  if (!contacts_.empty()) {
    flight_.interrupt();
    return false;
  }
  next_ = configuration_;
  if (!flight_.step(body_, joints_, config_.step, next_)) return false;
  if (check_configuration(joints_.size(), next_) != Status::kOk) {
    flight_.interrupt();
    body_.place(configuration_);
    return false;
  }
  configuration_ = next_;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    joints_[j].settle(configuration_.q[index], configuration_.qd[index]);
  }
  ground_.forget();
  (void)loose_.advance(contacts_, config_.step, 1.0);  // nothing touches: they fall
  reported_.clear();
  ++flown_;
  return true;
}

// Where the contacts do not settle, in ever smaller parts, which grow again behind it.
bool ArticulatedWorld::advance_settled() noexcept {
  int part = kSettleParts;
  for (int done = 0; done < kSettleParts;) {
    switch (advance(config_.step * part / kSettleParts, part > 1)) {
      case Outcome::kFailed:
        return false;
      case Outcome::kEvent:
        part /= 2;
        break;
      case Outcome::kTaken:
        done += part;
        if (done % (2 * part) == 0) part *= 2;
        break;
    }
  }
  return true;
}

// One solve.  kFailed: no sane result.  kEvent, if it may be rejected: its contacts did not settle,
// and nothing has changed.  goes_on: another solve follows from where this one ends; else a body
// that does not float is left placed where it began.
ArticulatedWorld::Outcome ArticulatedWorld::advance(double h, bool may_reject,
                                                    bool goes_on) noexcept {
  next_ = configuration_;
  if (!solve_step(h)) return Outcome::kFailed;
  if (!converged_) {
    if (may_reject) {
      body_.place(configuration_);
      loose_.place_all();
      return Outcome::kEvent;
    }
    ++unconverged_;
  }
  body_.advance(h, next_);
  if (check_configuration(joints_.size(), next_) != Status::kOk) return Outcome::kFailed;
  if (!loose_.advance(contacts_, h, h / config_.step)) return Outcome::kFailed;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    joints_[j].finish(next_.qd[static_cast<Eigen::Index>(j)], h / config_.step);
  }
  std::swap(configuration_, next_);
  ground_.remember(contacts_, 0, h);
  ties_.remember(contacts_);
  keep_depths(h);
  if (goes_on || floats()) place_after(before_, h, 0.0);
  return Outcome::kTaken;
}

// momentum: of the start; kept in flight.  before: share of the old velocity in the way of the
// centre of mass.
void ArticulatedWorld::place_after(Momentum momentum, double h, double before) noexcept {
  if (!floats()) {
    body_.place(configuration_);
    return;
  }
  const Eigen::Vector3d old = momentum.linear;
  momentum.linear.z() -= h * body_.mass() * kGravity;
  for (const Push& push : pushes_) {
    momentum.linear += h * push.force;
    momentum.angular += h * (push.point - momentum.com).cross(push.force);
  }
  for (const Contact& c : contacts_) {
    if (c.now.mode == ContactMode::kOpen || !of_robot(c)) continue;
    const Eigen::Vector3d force = c.system == 0 ? c.now.force : Eigen::Vector3d(-c.now.force);
    momentum.linear += h * force;
    momentum.angular += h * (c.point - momentum.com).cross(force);
    if (turns(c)) momentum.angular += h * (c.system == 0 ? c.moment : Eigen::Vector3d(-c.moment));
  }
  momentum.com += h / body_.mass() * (before * old + (1.0 - before) * momentum.linear);
  body_.place(momentum, configuration_);
}

// By something fixed; else by anything.
bool ArticulatedWorld::touched(bool fixed) const noexcept {
  return std::any_of(contacts_.begin(), contacts_.end(), [fixed](const Contact& c) {
    return c.now.mode != ContactMode::kOpen && (fixed ? holds_robot(c) : of_robot(c));
  });
}

// Nothing fixed has touched the robot in the last solve: its momentum is known.
bool ArticulatedWorld::floats() const noexcept { return airborne_ && !touched(true); }

void ArticulatedWorld::find_contacts(double h) noexcept {
  const PartScope part("contacts, found");
  ground_.find(body_, h, contacts_);
  ties_.find(loose_.systems(), h, contacts_);
  if (!loose_.empty()) loose_.find(h, contacts_);
  if (!soft_) return;
  soft_->weigh(joints_);
  soft_->give(h > 0.0 ? h : config_.step, contacts_);
}

// What touches and how.
std::uint64_t ArticulatedWorld::pattern_of_contacts() const noexcept {
  std::uint64_t pattern = kNoContact;
  for (const Contact& c : contacts_) {
    if (c.now.mode == ContactMode::kOpen) continue;
    pattern = mix(pattern, 2 * c.key + (c.now.mode == ContactMode::kSlip ? 1 : 0));
  }
  return pattern;
}

std::uint64_t ArticulatedWorld::pattern() const noexcept {
  std::uint64_t pattern = pattern_of_contacts();
  for (std::size_t j = 0; j < joints_.size(); ++j) {  // few are beyond their first pieces
    if (const int pieces = joints_[j].pattern(); pieces != 0) {
      pattern = mix(mix(pattern, static_cast<int>(j)), pieces);
    }
  }
  return loose_.robots().pattern(motors_.pattern(pattern));
}

// False: an inertia was not positive.
bool ArticulatedWorld::solve_step(double h) noexcept {
  find_contacts(h);
  doubt_depths(h);
  airborne_ = !config_.fixed_base &&
              std::none_of(contacts_.begin(), contacts_.end(),
                           [](const Contact& c) { return c.depth > 0.0 && holds_robot(c); });
  if (airborne_) before_ = body_.momentum();
  for (const Push& push : pushes_) {
    body_.add_force(push.link, push.point - body_.origin(), push.force);
  }
  solve_.fold(contacts_, h);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    joints_[j].begin(configuration_.q[index], configuration_.qd[index], h);
  }
  motors_.begin(joints_, configuration_.q);
  const auto speed_of = [&](std::size_t j) { return end_speed(j, h); };
  OtherRobots& others = loose_.robots();
  others.begin(h);
  // Block pivoting (Judice and Pires 1994): all joints that are wrong change piece at once while
  // that makes fewer of them; else one piece of the last one alone does, which cannot cycle.
  int fewest = std::numeric_limits<int>::max();
  int patience = kPatience;
  for (int pass = 0;; ++pass) {
    for (std::size_t j = 0; j < joints_.size(); ++j) rows_[j] = joints_[j].row();
    solves_ += pass_;
    do {
      if (!body_.inward(rows_, h) || !loose_.inward(h)) return false;
      body_.outward();
      loose_.outward();
    } while (solve_.refold(contacts_, h));
    const long before = solve_.counters().unconverged;
    solve_.solve(contacts_, h);
    converged_ = solve_.counters().unconverged == before && !solve_.gave_up();
    if (solve_.gave_up()) return true;
    int wrong = others.wrong(h) + motors_.wrong(joints_, speed_of);
    std::size_t last = joints_.size();
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].holds(end_speed(j, h))) continue;
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
    motors_.approach(joints_, speed_of);
    const bool all = patience > 0;
    if (all || last == joints_.size()) others.approach(h, all);
    if (last == joints_.size()) continue;
    if (!all) {
      joints_[last].approach_by_one(end_speed(last, h));
      continue;
    }
    for (std::size_t j = 0; j <= last; ++j) joints_[j].approach(end_speed(j, h));
  }
}

double ArticulatedWorld::end_speed(std::size_t joint, double h) const noexcept {
  return configuration_.qd[static_cast<Eigen::Index>(joint)] +
         h * body_.qdd(static_cast<int>(joint));
}

void ArticulatedWorld::report_contacts() noexcept {
  reported_.clear();
  for (const Contact& c : contacts_) {
    if (c.tie != TieKind::kNone) {
      if (c.system == 0) reported_.push_back(felt(c.link, c.point, c.now.force));
      if (c.other_system == 0) reported_.push_back(felt(c.other, c.point, -c.now.force));
      continue;
    }
    if (c.now.mode == ContactMode::kOpen && !(c.depth > 0.0)) continue;
    if (within_robot(c)) {
      const double depth = std::max(0.0, c.depth);
      reported_.push_back({c.link, -1, c.point, c.now.force, depth, false, moment_of(c)});
      reported_.push_back({c.other, -1, c.point, -c.now.force, depth, false, -moment_of(c)});
    }
    if (!of_robot(c)) continue;
    const bool first = c.system == 0;
    reported_.push_back({.link = first ? c.link : c.other,
                         .sole = c.sole,
                         .point = c.point,
                         .force = first ? c.now.force : Eigen::Vector3d(-c.now.force),
                         .depth = std::max(0.0, c.depth),
                         .moment = (first ? 1.0 : -1.0) * moment_of(c)});
  }
}

void ArticulatedWorld::estimate_contact_forces() noexcept {
  find_contacts(0.0);
  for (Contact& c : contacts_) {
    c.v = c.v0;
    if (c.tie != TieKind::kNone) {
      find_force(c, 0.0, false, 0.0);
      continue;
    }
    const double fn =
        c.params.stiffness * (c.depth + c.lead) -
        (damping_at(c.params, c.depth) + config_.step * c.params.stiffness) * c.normal.dot(c.v0);
    c.now.force = std::max(0.0, fn) * c.normal;
    c.now.mode = ContactMode::kStick;
    c.moment.setZero();
  }
  report_contacts();
}

double ArticulatedWorld::encoder(int joint) const noexcept {
  return configuration_.q[joint] + joints_[at(joint)].play();
}

double ArticulatedWorld::work() const noexcept {
  return solves_ + kNewtonWork * static_cast<double>(solve_.counters().newton);
}

double ArticulatedWorld::tau(int joint) const noexcept { return joints_[at(joint)].tau(); }

Eigen::Isometry3d ArticulatedWorld::link_in_world(int link) const noexcept {
  const LinkNow l = body_.link(link);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = l.rotation;
  pose.translation() = body_.origin() + l.origin;
  return pose;
}

Eigen::Vector3d ArticulatedWorld::point_velocity(int link,
                                                 const Eigen::Vector3d& point) const noexcept {
  return at_point(body_.velocity(link), point - body_.origin());
}

Eigen::Vector3d ArticulatedWorld::angular_velocity(int link) const noexcept {
  return angular(body_.velocity(link));
}

Eigen::Vector3d ArticulatedWorld::com() const noexcept { return body_.momentum().com; }

Eigen::Vector3d ArticulatedWorld::com_velocity() const noexcept {
  return body_.momentum().linear / body_.mass();
}

}  // namespace twinbus::sim
