// Joint-space set-points of every joint on the bus: each rests or is on a smooth way to where it
// was sent.

#pragma once

#include <array>
#include <cstdint>

#include "control/joint/min_jerk.h"
#include "robot/description/model.h"

namespace twinbus {

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
  // A joint that something else moves (an arm path).
  void set(int bus_joint, double q, double qd) noexcept;
  void advance(double dt) noexcept;

  double q(int j) const noexcept { return joint_[static_cast<std::size_t>(j)].position(); }
  double qd(int j) const noexcept {
    const auto k = static_cast<std::size_t>(j);
    return driven_[k] ? driven_rate_[k] : joint_[k].velocity();
  }
  bool moving() const noexcept;

 private:
  double inside(int bus_joint, double q) const noexcept;

  const Model* model_;
  std::array<MinJerk, kMaxJoints> joint_{};
  std::array<bool, kMaxJoints> driven_{};  // set() this tick
  PerJoint<double> driven_rate_{};
};

}  // namespace twinbus
