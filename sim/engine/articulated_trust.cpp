// Which steps of ArticulatedWorld are to be doubted, and what its springs hold.

#include <algorithm>
#include <cmath>

#include "sim/contact/bristle.h"
#include "sim/engine/articulated_world.h"

namespace twinbus::inline sim {

namespace {
bool is_of(const Contact& c, const std::array<int, 4>& who) {
  return who[1] == c.link && who[3] == c.other && who[0] == c.system && who[2] == c.other_system;
}
}  // namespace

// Contacts are looked for ahead of where things move: one that is deep when it is first seen was missed.
void ArticulatedWorld::doubt_depths(double h) noexcept {
  if (placed_) return;
  for (const Contact& c : contacts_) {
    if (!(c.depth > kFirstDepth) || c.tie != TieKind::kNone || loose_.woke(c)) continue;
    double expected = kFirstDepth + 2.0 * h * std::abs(c.normal.dot(c.v0));
    for (const DeepPair& pair : deep_) {
      if (is_of(c, pair.who)) expected += 2.0 * pair.depth;
    }
    if (!(c.depth > expected)) continue;
    trust_[Doubt::kDeep] = true;
    trust_.first_depth = std::max(trust_.first_depth, c.depth);
  }
}

// After a solve: what is deep, and whether it may come out on the other side.
void ArticulatedWorld::keep_depths(double h) noexcept {
  last_h_ = h;
  deep_.clear();
  for (const Contact& c : contacts_) {
    const double end = c.depth - h * c.normal.dot(c.v);
    if (!(end > 0.25 * kFirstDepth) || c.tie != TieKind::kNone) continue;
    if (loose_.may_come_through(c, end)) trust_[Doubt::kThrough] = true;
    const auto same = [&c](const DeepPair& pair) { return is_of(c, pair.who); };
    const auto known = !deep_.empty() && same(deep_.back()) ? deep_.end() - 1 : std::find_if(deep_.begin(), deep_.end(), same);
    if (known == deep_.end()) {
      deep_.push_back({{c.system, c.link, c.other_system, c.other}, end});
    } else {
      known->depth = std::max(known->depth, end);
    }
  }
}

double ArticulatedWorld::elastic_energy() const noexcept {
  double energy = loose_.asleep_energy();
  for (const Contact& c : contacts_) energy += loose_.asleep(c) ? 0.0 : stored_energy(c, last_h_);
  for (const Contact& c : apart_.contacts) energy += stored_energy(c, apart_.h);
  return energy;
}

bool ArticulatedWorld::step_loose(const Eigen::AlignedBox3d& robot) noexcept {
  contacts_.clear();
  trust_ = {};
  if (loose_.count() == 0) return true;
  const double h = config_.step;
  if (!loose_.away_from(robot, h)) return false;
  loose_.save();
  loose_.find_alone(h, contacts_);
  doubt_depths(h);
  solve_.fold(contacts_, h);
  const long unconverged = solve_.counters().unconverged;
  bool sound = loose_.inward(h);
  if (sound) {
    loose_.outward();
    solve_.solve(contacts_, h);
    sound = solve_.counters().unconverged == unconverged && !solve_.gave_up() && loose_.advance(contacts_, h, 1.0);
  }
  if (!sound) {
    loose_.restore();
    return false;
  }
  keep_depths(h);
  return true;
}

double ArticulatedWorld::corner_stiffness(int sole) const noexcept {
  const ContactParams& params = ground_.sole_params(sole);
  if (!soft_) return params.stiffness;
  return soft_->stiffness(ground_.sole_link(sole), params.friction, body_.mass() * kGravity / (2.0 * kSoleCorners));
}

double ArticulatedWorld::corner_damping(int sole, double force) const noexcept {
  const ContactParams& params = ground_.sole_params(sole);
  if (soft_) return soft_->damping(ground_.sole_link(sole), params.friction, force);
  return damping_at(params, force / params.stiffness);
}

}  // namespace twinbus::sim
