// Where an operator wants one joint: moved at a bounded speed while a key or stick is held, and asked for as poses of that joint.
//
// The controller judges each pose as any other: one on whose way a standing robot would fall or touch itself is refused.  The
// wish is never further ahead of the joint than it goes in half a second, so a joint that was let go comes to rest within that.
// Pure: neither bus nor clock.

#pragma once

#include <cstdint>
#include <string>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class JointTarget {
 public:
  // At first the first joint of a hand is chosen, else the first on the bus.
  explicit JointTarget(const Model& model);

  // The next joint on the bus, or the one before: step 1 or -1.
  void choose(int step) noexcept;
  // seconds: at the speed of the joint, either way.  mode: of the controller.  What it does not move is said in words().
  void move(double seconds, const RobotState& state, Mode mode) noexcept;
  // Whoever let go, or asked for it: the joint stops where it is.
  void stop() noexcept;
  // Another mode is asked for: what was wished is forgotten and nothing more is sent, not even to stop.
  void drop() noexcept { begun_ = halt_ = false; }

  // What to ask for now, if anything; all but its addressing.  Nothing in a mode that a pose would end, which drops a wish.
  [[nodiscard]] bool next(std::int64_t now_ns, const RobotState& state, Mode mode, ModeRequest& request) noexcept;

  // It was sent on and does not move: something holds it.
  bool is_held() const noexcept { return still_ns_ != 0 && now_ns_ - still_ns_ > kHeldNs; }

  // Of the joint that is chosen: [rad/s or m/s].
  double speed() const noexcept;
  int chosen() const noexcept { return chosen_; }  // on the bus
  // Which joint, where it is, and why it goes no further.
  std::string words(const RobotState& state) const;

 private:
  static constexpr std::int64_t kHeldNs = 500'000'000;

  const Joint& joint() const noexcept;
  void watch(const RobotState& state) noexcept;

  const Model* model_;
  int chosen_ = 0;
  bool begun_ = false;  // wanted_ means something
  bool halt_ = false;   // to be stopped with the next()
  const char* refusal_ = nullptr;
  double wanted_ = 0.0, asked_ = 0.0;  // [rad or m]
  std::int64_t asked_ns_ = 0, moved_ns_ = 0, now_ns_ = 0;
  std::int64_t still_ns_ = 0;  // since when it is away from where it was sent and rests; 0: it is not
};

}  // namespace twinbus::control
