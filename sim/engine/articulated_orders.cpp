// Orders 2 and 3 of ArticulatedWorld: steps of order 1 extrapolated, in parts where an event lies.

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/engine/articulated_world.h"
#include "sim/articulated/richardson.h"

namespace twinbus::inline sim {

namespace {

// It is calm again where the last correction of an extrapolation changes no speed by more than this times step^1.5: between
// events errors fall with the square of the step, and with the step where they lie.
constexpr double kCalm = 0.03;  // [m/s^2.5]
// Steps in parts of one size, at most: motion may be lively without an event.
constexpr int kMostHeld = 16;

}  // namespace

// Where an event lies within a step, the step is taken in ever smaller parts, which grow again from
// part to part once all is calm, and from step to step once the robot is: servos and ground that a landing has shaken ring
// on for a while.
bool ArticulatedWorld::advance_in_parts() noexcept {
  work_ = 0.0;
  const int parts = most_parts();
  if (calm_ || (!(config_.local_error > 0.0) && ++held_ == kMostHeld)) {
    part_ = std::min(2 * part_, parts);
    held_ = 0;
  }
  for (int done = 0; done < parts;) {
    const double h = config_.step * part_ / parts;
    switch (extrapolated(h, part_ > 1)) {
      case Outcome::kFailed:
        return false;
      case Outcome::kEvent:
        part_ /= 2;
        held_ = 0;
        break;
      case Outcome::kTaken:
        done += part_;
        if (grows_ && done < parts && done % (2 * part_) == 0) part_ *= 2;
        break;
    }
  }
  return true;
}

// One step, two halves, at order 3 three thirds of it from the same start.  may_reject: an event
// leaves everything as it was.
ArticulatedWorld::Outcome ArticulatedWorld::extrapolated(double h, bool may_reject) noexcept {
  start_ = configuration_;
  loose_.save();
  ground_.save();
  for (JointLaw& joint : joints_) joint.save();
  Momentum momentum;  // if nothing touches
  bool smooth = true, airborne = true;
  double correction = 0.0;  // [m/s]
  bool moved = false;  // the body is placed elsewhere than at the start
  std::uint64_t expected = 0;
  std::array<double, 3> work{};  // of the servos in one, two and three parts [J]
  for (int parts = 1; parts <= config_.order; ++parts) {
    if (parts > 1) go_back(std::exchange(moved, false));
    for (int i = 0; i < parts; ++i) {
      const bool goes_on = i + 1 < parts;
      solve_.hurry(may_reject);
      const Outcome outcome = advance(h / parts, may_reject, goes_on);
      moved = moved || goes_on || floats();
      if (outcome == Outcome::kFailed && parts == config_.order) return Outcome::kFailed;
      smooth = smooth && outcome == Outcome::kTaken;
      work[at(parts - 1)] += work_since(next_);  // where it was before, since they were swapped
      if (parts == 1) {
        expected = pattern();
        momentum = before_;
      }
      airborne = airborne && airborne_ && !touched(false);
      smooth = smooth && pattern() == expected && !crosses();
      if (smooth) continue;
      if (may_reject) {
        go_back(moved);
        return Outcome::kEvent;
      }
      if (parts < config_.order) break;
    }
    if (parts < config_.order) {
      coarse_[at(parts - 1)] = configuration_;
      loose_.keep_coarse(parts - 1);
    }
  }
  if (smooth) {
    next_ = configuration_;
    correction = extrapolate(config_.order, coarse_, configuration_);
    smooth = check_configuration(joints_.size(), configuration_) == Status::kOk && !passes_stops(joints_, next_, configuration_);
    if (!smooth) configuration_ = next_;
  }
  if (!smooth) {
    grows_ = false;
    if (config_.local_error > 0.0) calm_ = false;
    if (!floats()) body_.place(configuration_);
    ++events_;
    work_ += work[at(config_.order - 1)];
    return Outcome::kTaken;
  }
  const double others = loose_.extrapolate(config_.order);
  const double allowed = config_.local_error * h;
  if (allowed > 0.0 && may_reject && !(std::max(correction, others) <= allowed)) {
    go_back(true);
    return Outcome::kEvent;
  }
  const double second = 2.0 * work[1] - work[0];
  work_ += config_.order == 2 ? second : (3.0 * (3.0 * work[2] - 2.0 * work[1]) - second) / 2.0;
  const double calm = kCalm * config_.step * std::sqrt(config_.step);
  calm_ = correction <= calm;
  grows_ = calm_ && others <= calm;
  if (allowed > 0.0) calm_ = grows_ = std::max(correction, others) <= kGrows * allowed;
  airborne_ = airborne;
  place_after(momentum, h, 0.5);
  return Outcome::kTaken;
}

// Of servos in a solve that led from there to where the robot is [J].
double ArticulatedWorld::work_since(const Configuration& before) const noexcept {
  double work = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    work += joints_[j].tau() * (configuration_.q[index] - before.q[index]);
  }
  return work;
}

// Something came to touch or to part within the last solve.
bool ArticulatedWorld::crosses() const noexcept {
  return std::any_of(contacts_.begin(), contacts_.end(), [](const Contact& c) {
    return (c.depth > 0.0) != (c.now.mode != ContactMode::kOpen);
  });
}

// To where extrapolated() began.
void ArticulatedWorld::go_back(bool moved) noexcept {
  configuration_ = start_;
  moved ? body_.place(configuration_) : body_.let_go();
  ground_.restore();
  loose_.restore();
  for (JointLaw& joint : joints_) joint.restore();
}

}  // namespace twinbus::sim
