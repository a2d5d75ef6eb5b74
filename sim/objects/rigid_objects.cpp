#include "sim/objects/rigid_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "sim/articulated/richardson.h"
#include "sim/contact/ground_contacts.h"
#include "sim/objects/rigid_object_mesh.h"

namespace twinbus::inline sim {

namespace {

constexpr double kStill = 0.01;  // [m/s] and [rad/s]
constexpr double kRest = 0.2;        // [s]
constexpr double kSlow = 1e-4;       // what is slower lies [m/s]
constexpr int kLies = 64;        // smooth steps so slow, from which a body lies

Model model_of(const LooseBody& body) {
  Model model;
  model.name = body.name;
  Link link;
  link.name = body.name;
  link.mass = body.mass;
  link.inertia = inertia_of(body);
  model.links = {link};
  return model;
}

}  // namespace

LooseBodies::LooseBodies(const Model& model, const WorldConfig& config, ArticulatedBody& robot)
    : robots_(config), systems_{&robot}, contacts_(model, config) {
  articulated_.reserve(config.loose.size());
  for (const LooseBody& body : config.loose) {
    const Model own = model_of(body);
    articulated_.emplace_back(own, false, 1.0);
    systems_.push_back(&articulated_.back());
    Body& added = bodies_.emplace_back();
    added.now = added.start = Configuration(own);
    added.coarse = {added.now, added.now};
    added.inertia = own.links[0].inertia.diagonal();
    added.radius = bounding_radius(body.solid);
    set(count() - 1, body.start);
  }
  for (int i = 0; i < robots_.count(); ++i) systems_.push_back(&robots_.body(i));
  for (const Tie& tie : config.ties) {
    for (const int body : {tie.a.loose, tie.b.loose}) {
      if (body >= 0 && body < count()) bodies_[at(body)].tied = true;
    }
  }
  parent_.resize(systems_.size());
  restless_.resize(systems_.size());
  heap_.resize(systems_.size());
}

int LooseBodies::most_contacts() const noexcept {
  const int robots = 1 + robots_.count();
  const int among_robots = contacts_.robots_meet() ? robots * kMostContacts : 0;
  return robots * kMostContacts + among_robots + kMostLooseContacts * count();
}

LooseState LooseBodies::state(int body) const noexcept {
  const Configuration& now = bodies_[at(body)].now;
  return {now.base, now.base_velocity, now.base_angular_velocity};
}

void LooseBodies::set(int body, const LooseState& state) noexcept {
  Configuration& now = bodies_[at(body)].now;
  now.base = state.pose;
  now.base.linear() = Eigen::Quaterniond(state.pose.linear()).normalized().toRotationMatrix();
  now.base_velocity = state.velocity;
  now.base_angular_velocity = state.angular_velocity;
  bodies_[at(body)].still = 0;
  bodies_[at(body)].quiet = 0.0;
  place(at(body));
  contacts_.forget();
}

// The acceleration of the solve is to be that of the centre itself, without w x v.
void LooseBodies::place(std::size_t body) noexcept {
  const Configuration& now = bodies_[body].now;
  ArticulatedBody& work = articulated_[body];
  work.place(now);
  work.add_force(0, Eigen::Vector3d::Zero(),
                 work.mass() * now.base_angular_velocity.cross(now.base_velocity));
}

void LooseBodies::place_all() noexcept {
  if (out_) return;
  robots_.place_all();
  for (std::size_t i = 0; i < bodies_.size(); ++i) place(i);
}

bool LooseBodies::inward(double h) noexcept {
  if (out_) return true;
  bool sound = robots_.inward(h);
  for (std::size_t i = 0; i < articulated_.size(); ++i)
    sound = (asleep(i) || articulated_[i].inward(no_rows_, h)) && sound;
  return sound;
}

void LooseBodies::outward() noexcept {
  if (out_) return;
  robots_.outward();
  for (std::size_t i = 0; i < articulated_.size(); ++i) {
    if (!asleep(i)) articulated_[i].outward();
  }
}

bool LooseBodies::advance(const std::vector<Contact>& contacts, double h,
                          double share) noexcept {
  if (empty() || out_) return true;
  contacts_.remember(systems_, contacts, h);
  if (!robots_.advance(contacts, count() + 1, h, share)) return false;
  for (Body& body : bodies_) body.touched = false;
  for (const Contact& c : contacts) {
    if (c.now.mode == ContactMode::kOpen) continue;
    for (const int system : {c.system, c.other_system}) {
      if (system > 0 && system <= count()) bodies_[at(system - 1)].touched = true;
    }
  }
  std::array<FreeRotation, kFreeLanes> turning;
  int flying = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (asleep(i)) continue;
    if (bodies_[i].touched) {
      bodies_[i].ever = true;
      land(i, h);
      continue;
    }
    turning[at(flying++)] = fly(i, h);
    if (flying == kFreeLanes) turn_freely(turning.data(), std::exchange(flying, 0), h);
  }
  turn_freely(turning.data(), flying, h);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (asleep(i)) continue;
    if (check_configuration(0, bodies_[i].now) != Status::kOk) return false;
    place(i);
  }
  return true;
}

int LooseBodies::heap_of(int system) noexcept {
  while (parent_[at(system)] != system) system = parent_[at(system)];
  return system;
}

void LooseBodies::rest(const std::vector<Contact>& contacts, double step, double h) noexcept {
  bool any = false;
  std::fill(restless_.begin(), restless_.end(), 0);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    if (std::exchange(body.slept, asleep(i)) && !body.slept) body.quiet = 0.0;
    if (body.slept) continue;
    const bool slow = body.now.base_velocity.norm() + body.radius * body.now.base_angular_velocity.norm() < kSlow;
    body.quiet = slow && body.touched && !body.tied ? body.quiet + step : 0.0;
    restless_[i + 1] = body.quiet < kRest ? 1 : 0;
    any = any || restless_[i + 1] == 0;
  }
  if (!any) return;
  const auto is_body = [this](int system) { return system > 0 && system <= count(); };
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const Contact& c : contacts) {
    if (c.now.mode == ContactMode::kOpen || c.other_system < 0) continue;
    if (is_body(c.system) && is_body(c.other_system)) parent_[at(heap_of(c.other_system))] = heap_of(c.system);
    else restless_[at(c.system)] = restless_[at(c.other_system)] = 1;
  }
  for (int s = 1; s <= count(); ++s) restless_[at(heap_of(s))] |= restless_[at(s)];
  any = false;
  for (int s = 1; s <= count(); ++s) {
    const bool sleeps = !contacts_.asleep(s) && restless_[at(heap_of(s))] == 0;
    heap_[at(s)] = sleeps ? heap_of(s) : 0;
    any = any || sleeps;
    if (!sleeps) continue;
    Body& body = bodies_[at(s - 1)];
    body.now.base_velocity.setZero();
    body.now.base_angular_velocity.setZero();
    body.slept = true;
    place(at(s - 1));
  }
  if (any) contacts_.fall_asleep(heap_, systems_, contacts, h);
}

void LooseBodies::land(std::size_t index, double h) noexcept {
  Configuration& now = bodies_[index].now;
  const Eigen::Vector3d& inertia = bodies_[index].inertia;
  const Screw a = articulated_[index].acceleration(0);
  const Eigen::Matrix3d r = now.base.linear();
  const Eigen::Vector3d w = now.base_angular_velocity;
  const auto momentum = [&](const Eigen::Vector3d& spin) {
    return Eigen::Vector3d(r * inertia.cwiseProduct(r.transpose() * spin));
  };
  const Eigen::Vector3d end = w + h * angular(a);
  const Eigen::Vector3d angular_momentum = momentum(end) + h * w.cross(momentum(w));
  now.base_velocity += h * linear(a);
  now.base.translation() += h * now.base_velocity;
  const double angle = h * end.norm();
  if (angle > 0.0) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, end.normalized()));
    now.base.linear() = (turn * Eigen::Quaterniond(r)).normalized().toRotationMatrix();
  }
  const Eigen::Matrix3d after = now.base.linear();
  now.base_angular_velocity = after * (after.transpose() * angular_momentum).cwiseQuotient(inertia);
}

// All but its turn, which is returned.
FreeRotation LooseBodies::fly(std::size_t index, double h) noexcept {
  Configuration& now = bodies_[index].now;
  const Eigen::Vector3d gravity(0.0, 0.0, -kGravity);
  now.base.translation() += h * (now.base_velocity + 0.5 * h * gravity);
  now.base_velocity += h * gravity;
  return {&bodies_[index].inertia, &now.base, &now.base_angular_velocity};
}

void LooseBodies::save() noexcept {
  if (out_) return;
  contacts_.save();
  robots_.save();
  for (Body& body : bodies_) {
    body.start = body.now;
    body.still_before = body.still;
    body.ever = false;
  }
}

void LooseBodies::restore() noexcept {
  if (out_) return;
  contacts_.restore();
  robots_.restore();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].now = bodies_[i].start;
    bodies_[i].still = bodies_[i].still_before;
    place(i);
  }
}

void LooseBodies::keep_coarse(int which) noexcept {
  if (out_) return;
  robots_.keep_coarse(which);
  for (Body& body : bodies_) body.coarse[at(which)] = body.now;
}

// What has touched nothing is better as it is.
double LooseBodies::extrapolate(int order) noexcept {
  if (out_) return 0.0;
  double correction = robots_.extrapolate(order);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    if (!body.ever) continue;
    const bool slow = body.now.base_velocity.norm() < kStill &&
                      body.now.base_angular_velocity.norm() < kStill;
    body.still = slow ? body.still + 1 : 0;
    if (order == 3 && body.still > kLies) {
      extrapolate_at_rest(body.coarse, body.now);
    } else {
      correction = std::max(correction, twinbus::extrapolate(order, body.coarse, body.now));
    }
    place(i);
  }
  return correction;
}

}  // namespace twinbus::sim
