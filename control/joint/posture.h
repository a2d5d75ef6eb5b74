// Joint-space set-points of every joint on the bus: each rests or is on a smooth way to where it
// was sent.  What a guard holds stays where it is held, and nothing runs on ahead of it: its way goes on
// once the guard has been content for a while, and ends for good where it is held again and again without going on.

#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "control/joint/min_jerk.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class Posture {
 public:
  explicit Posture(const Model& model) : model_(&model) {}

  // Every joint at q [bus order], at rest, kept inside the limits.
  void rest(const PerJoint<double>& q) noexcept;
  // Every joint comes to rest from velocity qd within duration [s].
  void brake(const PerJoint<double>& q, const PerJoint<double>& qd, double duration) noexcept;
  // The joints of the mask go to q; not faster than share of the velocity limit, whatever duration
  // says.
  void move(const PerJoint<double>& q, std::int64_t mask, double duration) noexcept;
  // Once per tick, behind advance(): joints of the mask are held by a guard, and were put at q and qd last [bus order].
  void yield(std::int64_t mask, const PerJoint<double>& q, const PerJoint<double>& qd, double dt) noexcept;
  // Bit per joint that was held on its way since the last call; that will not go on any more.
  struct Held {
    std::int64_t waits = 0, given_up = 0;
  };
  Held take_held() noexcept { return std::exchange(held_, {}); }
  // A joint that something else moves (an arm path).
  void set(int bus_joint, double q, double qd) noexcept;
  void advance(double dt) noexcept;

  double q(int j) const noexcept { return joint_[static_cast<std::size_t>(j)].position(); }
  double qd(int j) const noexcept {
    const auto k = static_cast<std::size_t>(j);
    return driven_[k] ? driven_rate_[k] : joint_[k].velocity();
  }
  bool moving() const noexcept;
  // One of these is to go on once nothing holds it.
  bool waits(std::int64_t mask) const noexcept { return (waiting_ & mask) != 0; }
  // One of these was sent somewhere last, and was held too often to come there.
  bool gave_up(std::int64_t mask) const noexcept { return (given_up_ & mask) != 0; }

 private:
  // Of a way that was asked for.
  struct Way {
    double to = 0.0, left = 0.0;  // where it goes [rad or m], the time that is left of it [s]
    double shown = 0.0;           // since it began [s]
    double clear_for = 0.0;       // since nothing holds the joint [s]
    double held_towards = 0.0;    // from where it was held last to where it went [rad or m]
    double held_at = 0.0;         // where that was [rad or m]
    int blocks = 0;               // so often it was held there
  };
  double inside(int bus_joint, double q) const noexcept;
  double least_time(int bus_joint, double q) const noexcept;  // to there [s]
  void hold(int bus_joint, double q, double qd) noexcept;
  void let_go(int bus_joint, double dt) noexcept;

  const Model* model_;
  std::array<MinJerk, kMaxJoints> joint_{};
  std::array<Way, kMaxJoints> way_{};
  std::int64_t asked_ = 0, waiting_ = 0, given_up_ = 0;  // bit per joint: has a way, waits on it, was held on it too often
  std::int64_t braked_ = 0;                              // held a tick ago
  Held held_;
  std::array<bool, kMaxJoints> driven_{};  // set() this tick
  PerJoint<double> driven_rate_{};
};

}  // namespace twinbus::control
