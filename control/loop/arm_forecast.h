// Where the joints that balance does not move go if nobody steers them any more: on as they are for a moment, then to rest
// along their own path, be it a way between two postures or a planned motion of the arms.

#pragma once

#include "control/joint/posture.h"
#include "control/loop/arm_follow.h"

namespace twinbus::inline control {

class ArmForecast {
 public:
  explicit ArmForecast(const Model& model) : posture_(model) {}

  void start(const Posture& posture, const ArmFollow& arm) noexcept {
    posture_ = posture;
    arm_ = &arm;
    path_id_ = arm.path_id();
    time_ = arm.time();
    rate_ = arm.rate();
    share_ = 1.0;
    gone_ = 0.0;
  }
  // brakes: the motion is to end.  False when the arm has begun another path meanwhile.
  bool advance(bool brakes, double dt) noexcept;

  const Posture& posture() const noexcept { return posture_; }
  // So long has anything gone on at its own speed [s].
  double gone() const noexcept { return gone_; }
  bool moving() const noexcept { return share_ > 0.0 && (path_id_ != 0 || posture_.moving()); }

 private:
  Posture posture_;
  const ArmFollow* arm_ = nullptr;
  std::int64_t path_id_ = 0;
  double time_ = 0.0, rate_ = 0.0;  // along the path
  double share_ = 1.0;              // of its own speed that every motion has
  double gone_ = 0.0;
};

}  // namespace twinbus::control
