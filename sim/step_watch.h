// What is asked of every step of a simulated world beside its result: is it to be trusted, and what did it cost.

#pragma once

#include <algorithm>
#include <vector>

#include "common/time/cpu_time.h"
#include "common/time/part_clock.h"
#include "lcmtypes/msg/robot_io.h"
#include "sim/engine/energy_balance.h"
#include "sim/engine/local_error.h"
#include "sim/world/step_trust.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class StepWatch {
 public:
  StepWatch(const Model& model, const WorldConfig& config, std::size_t most_pushes)
      : bands_(config.bands), balance_(model, config), error_(model.links.size(), config.loose.size(), config) {
    pushes_.reserve(most_pushes);
  }
  // After a jump of the world.
  void begin(const World& world) noexcept {
    balance_.begin(world);
    error_.begin(balance_.velocities(), balance_.own_velocities());
  }
  // A command that comes into force, and the one before.
  void driven_by(const JointCommand& to, const JointCommand& from) noexcept {
    if (to.q != from.q || to.qd != from.qd || to.tau != from.tau || to.kp != from.kp || to.kd != from.kd) error_.driven();
  }
  // A force on a point of a link acts in the next step; point: link frame, force: world [N].
  void push(const World& world, int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
    if (pushes_.size() < pushes_.capacity()) pushes_.push_back({link, point, world.link_in_world(link) * point, force});
  }
  // Steps the world; time: at its end [s].
  Status step(World& world, double time) noexcept {
    const double begun = timed_ ? thread_cpu_seconds() : 0.0;
    const Status status = step_of(world);
    if (timed_) seconds_ += std::max(0.0, thread_cpu_seconds() - begun - clock_);
    if (status == Status::kOk) stepped(world, time);
    return status;
  }
  // After a step of the world, whoever took it.
  void stepped(const World& world, double time) noexcept {
    const PartScope part("energy and doubts");
    double work = 0.0;
    for (const Push& push : pushes_) work += push.force.dot(world.link_in_world(push.link) * push.local - push.from);
    pushes_.clear();
    StepTrust trust = world.trust();
    trust[Doubt::kEnergy] = balance_.add(world, work);
    trust.know(bands_);
    if (balance_.looks() && error_.add(balance_.velocities(), balance_.own_velocities(), touched(world)))
      trust[Doubt::kCoarse] = true;
    counts_.add(trust, balance_.gain(), time);
  }
  const TrustCounts& counts() const noexcept { return counts_; }
  TrustBands bands() const noexcept { return {error_.band(), balance_.gain_band(), balance_.rise_band(), counts_.first_depth}; }

  void time_steps() noexcept {
    timed_ = true;
    clock_ = cost_of_thread_clock();
  }
  double seconds() const noexcept { return seconds_; }  // CPU of the steps since then [s]

 private:
  struct Push {
    int link;
    Eigen::Vector3d local, from, force;
  };
  static Status step_of(World& world) noexcept {
    const PartScope part("dynamics");
    return world.step();
  }
  static bool touched(const World& world) noexcept {
    return std::any_of(world.contacts().begin(), world.contacts().end(), [](const ContactPoint& c) { return !c.tie; });
  }

  TrustBands bands_;
  EnergyBalance balance_;
  LocalError error_;
  TrustCounts counts_;
  std::vector<Push> pushes_;
  bool timed_ = false;
  double seconds_ = 0.0, clock_ = 0.0;
};

}  // namespace twinbus::sim
