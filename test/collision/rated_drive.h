// Random jerk-limited motions of arms and waist at their rated speeds, to a posture in which the robot
// hits itself: what the guard is driven with in its tests and its bench.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "common/math/index.h"
#include "robot/collision/exact/self_collision.h"
#include "test/collision/guard_rig.h"

namespace twinbus {

class RatedDrive {
 public:
  explicit RatedDrive(const Model& model) : model_(model) {
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const std::string& name = model.joints[at(model.bus_joints[k])].name;
      if (name.find("ARM") != std::string::npos || name.find("WAIST") != std::string::npos ||
          name.find("CHEST") != std::string::npos)
        moved_.push_back(k);
    }
  }

  const std::vector<std::size_t>& moved() const { return moved_; }  // of the bus

  // The number of a motion and the seed say all about it.
  Configuration draw_target(SelfCollision& exact, const Configuration& home, std::int64_t seed,
                            std::int64_t number) const {
    std::seed_seq seeds{seed, number};
    std::mt19937_64 random(seeds);
    Configuration target = home;
    do {
      for (const std::size_t k : moved_) {
        const Joint& joint = model_.joints[at(model_.bus_joints[k])];
        target.q[model_.bus_joints[k]] =
            std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
      }
      exact.place(target.q);
    } while (!exact.any_touching());
    return target;
  }

  void start() { v_ = a_ = {}; }  // at rest

  // One tick of all commands.
  void follow(GuardRig& rig, const Configuration& aim) {
    for (const std::size_t k : moved_) follow(rig, k, aim.q[model_.bus_joints[k]]);
  }

 private:
  static constexpr double kPace = 30.0;  // of the follower: as fast as ratings allow [rad/s]
  static constexpr double kRamp = 0.05;  // to the rated speed [s]

  // Third order, towards the aim, within the rated speed and what reaches it in kRamp.
  void follow(GuardRig& rig, std::size_t k, double aim) {
    const Joint& joint = model_.joints[at(model_.bus_joints[k])];
    const double dt = model_.period(), most = joint.velocity / kRamp;
    const double jerk = kPace * kPace * kPace * (aim - rig.command.q[k]) -
                        3.0 * kPace * kPace * v_[k] - 3.0 * kPace * a_[k];
    const double limit = most / kRamp;
    a_[k] = std::clamp(a_[k] + std::clamp(jerk, -limit, limit) * dt, -most, most);
    v_[k] = std::clamp(v_[k] + a_[k] * dt, -joint.velocity, joint.velocity);
    rig.command.q[k] = std::clamp(rig.command.q[k] + v_[k] * dt, joint.lower, joint.upper);
  }

  const Model& model_;
  std::vector<std::size_t> moved_;
  PerJoint<double> v_{}, a_{};
};

}  // namespace twinbus
