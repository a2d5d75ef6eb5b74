// Whether a robot touches itself on the way to a pose: looked at before it begins, a few places per tick.
//
// The way is straight in the joints, as Posture moves them.  What is nearer than the guard's margin already may come apart.

#pragma once

#include <array>
#include <cstdint>

#include "robot/collision/collision.h"
#include "robot/description/model.h"
#include "robot/collision/near_pairs.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline control {

class PoseWay {
 public:
  // Allocates everything; throws std::runtime_error when a mesh cannot be read.
  explicit PoseWay(const Model& model);

  // base: where it is and what joints off the bus do; from, to: of the joints on the bus [rad or m]; mask: bit per joint
  // that goes to `to`.
  void start(const Configuration& base, const PerJoint<double>& from, const PerJoint<double>& to,
             std::int64_t mask) noexcept;
  enum class Verdict : std::int8_t { kLooks, kFree, kTouches };
  // Once per tick, until it is not kLooks.
  Verdict look() noexcept;
  // After kTouches: which links, a sentence that lives until the fourth next refusal.
  const char* why() noexcept;

 private:
  static constexpr int kPlaces = 24, kPerTick = 2, kMostPairs = 32;

  const Model* model_;
  Collision collision_;
  MarginShares shares_;
  Kinematics kinematics_;
  Configuration place_;
  PerJoint<double> from_{}, to_{};
  std::int64_t mask_ = 0;
  int next_ = 0;
  std::array<PairDistance, kMostPairs> near_{}, at_start_{};
  int near_at_start_ = 0;
  PairDistance hit_;
  std::array<std::array<char, 200>, 4> sentences_{};
  std::size_t sentence_ = 0;
};

}  // namespace twinbus::control
