// Steps of ArticulatedWorld whose parts are chosen by their local error, while nothing loose is near the robot: the robot in its parts,
// the loose bodies in theirs.  A robot that stands is not divided for what falls beside it.

#include <algorithm>
#include <utility>

#include "sim/engine/articulated_world.h"

namespace twinbus::inline sim {

namespace {


}  // namespace

void ArticulatedWorld::begin_apart() {
  apart_.part = most_parts();
  apart_.share = static_cast<double>(loose_.count()) / static_cast<double>(loose_.count() + body_.link_count());
  apart_.contacts.reserve(contacts_.capacity());
  apart_.deep.reserve(deep_.capacity());
}

bool ArticulatedWorld::advance_apart() noexcept {
  const bool apart = loose_.count() > 0 && loose_.robots().empty() && config_.ties.empty() && !config_.asleep &&
                     loose_.away_from_robot(config_.step);
  if (apart != apart_.now) {
    if (apart) {
      apart_.deep = deep_;
      apart_.part = part_;
      apart_.h = last_h_;
    } else {
      const std::size_t room = deep_.capacity() - deep_.size();
      const auto more = static_cast<std::ptrdiff_t>(std::min(room, apart_.deep.size()));
      deep_.insert(deep_.end(), apart_.deep.begin(), apart_.deep.begin() + more);
      part_ = std::min(part_, apart_.part);
    }
    apart_.now = apart;
  }
  apart_.contacts.clear();
  if (!apart) return advance_in_parts();
  const auto exchange = [this] {
    std::swap(contacts_, apart_.contacts);
    std::swap(deep_, apart_.deep);
    std::swap(last_h_, apart_.h);
  };
  exchange();
  const bool sound = advance_loose_in_parts();
  exchange();
  if (!sound) return false;
  loose_.leave_out(true);
  pass_ = 1.0 - apart_.share;
  const bool advanced = advance_in_parts();
  pass_ = 1.0;
  loose_.leave_out(false);
  return advanced;
}

bool ArticulatedWorld::advance_loose_in_parts() noexcept {
  const int parts = most_parts();
  if (apart_.calm) apart_.part = std::min(2 * apart_.part, parts);
  for (int done = 0; done < parts;) {
    const double h = config_.step * apart_.part / parts;
    switch (extrapolate_loose(h, apart_.part > 1)) {
      case Outcome::kFailed:
        return false;
      case Outcome::kEvent:
        apart_.part /= 2;
        break;
      case Outcome::kTaken:
        done += apart_.part;
        if (apart_.calm && done < parts && done % (2 * apart_.part) == 0) apart_.part *= 2;
        break;
    }
  }
  return true;
}

// As extrapolated() does with all.
ArticulatedWorld::Outcome ArticulatedWorld::extrapolate_loose(double h, bool may_reject) noexcept {
  loose_.save();
  bool smooth = true;
  std::uint64_t expected = 0;
  for (int parts = 1; parts <= config_.order; ++parts) {
    if (parts > 1) loose_.restore();
    for (int i = 0; i < parts; ++i) {
      solve_.hurry(may_reject);
      const Outcome outcome = advance_loose(h / parts, may_reject);
      if (outcome == Outcome::kFailed && parts == config_.order) return Outcome::kFailed;
      smooth = smooth && outcome == Outcome::kTaken;
      if (parts == 1) expected = pattern_of_contacts();
      smooth = smooth && pattern_of_contacts() == expected && !crosses();
      if (smooth) continue;
      if (may_reject) {
        loose_.restore();
        return Outcome::kEvent;
      }
      if (parts < config_.order) break;
    }
    if (parts < config_.order) loose_.keep_coarse(parts - 1);
  }
  if (!smooth) {
    apart_.calm = false;
    ++events_;
    return Outcome::kTaken;
  }
  const double off = loose_.extrapolate(config_.order), allowed = config_.local_error * h;
  if (may_reject && !(off <= allowed)) {
    loose_.restore();
    return Outcome::kEvent;
  }
  apart_.calm = off <= kGrows * allowed;
  return Outcome::kTaken;
}

// As advance() does with all.
ArticulatedWorld::Outcome ArticulatedWorld::advance_loose(double h, bool may_reject) noexcept {
  contacts_.clear();
  loose_.find_alone(h, contacts_);
  doubt_depths(h);
  solve_.fold(contacts_, h);
  do {
    if (!loose_.inward(h)) return Outcome::kFailed;
    loose_.outward();
  } while (solve_.refold(contacts_, h));
  solves_ += apart_.share;
  const long before = solve_.counters().unconverged;
  solve_.solve(contacts_, h);
  if (solve_.counters().unconverged != before || solve_.gave_up()) {
    if (may_reject) {
      loose_.place_all();
      return Outcome::kEvent;
    }
    ++unconverged_;
  }
  if (!loose_.advance(contacts_, h, h / config_.step)) return Outcome::kFailed;
  keep_depths(h);
  return Outcome::kTaken;
}

}  // namespace twinbus::sim
