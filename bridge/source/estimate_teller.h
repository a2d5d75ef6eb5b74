// What ESTIMATE says beside each STATE of a source, without a break across a switch.
//
// A source that becomes active goes on from the last ESTIMATE of the one before, if that belongs to the last STATE that was
// heard and is not old; else it begins anew.  A stranger's ESTIMATE can therefore move where the world of the estimate lies, and
// its velocity for a tenth of a second; nothing in a source depends on it.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/estimation/inertial_leg_odometry.h"

namespace twinbus::inline bridge {

class EstimateTeller {
 public:
  explicit EstimateTeller(const Model& model) : odometry_(model) {}  // the model must outlive this

  // STATE and ESTIMATE of any source, also of this one; finite.
  void heard(const RobotState& state) noexcept {
    heard_run_ = state.run_id;
    heard_tick_ = state.tick;
  }
  void operator()(const Estimate& estimate) noexcept {
    if (estimate.run_id == heard_run_ && estimate.tick == heard_tick_) last_ = estimate;
  }

  // state: that this source publishes on STATE; the same tick again gives the same.
  const Estimate& of(const RobotState& state) noexcept {
    if (!active_) {
      active_ = true;
      const bool follows = last_.run_id != 0 && last_.run_id != state.run_id && last_.tick <= state.tick + kBeyond &&
                           state.tick - last_.tick <= kOld;
      if (follows) odometry_.resume(last_);
    }
    odometry_.update(state);
    return odometry_.estimate();
  }
  // This source does not publish on STATE.
  void rest() noexcept { active_ = false; }

 private:
  static constexpr std::int64_t kOld = 100;    // [ticks]
  static constexpr std::int64_t kBeyond = 10;  // two sources publish at once for a moment [ticks]

  InertialLegOdometry odometry_;
  Estimate last_;
  std::int64_t heard_run_ = 0, heard_tick_ = -1;
  bool active_ = false;
};

}  // namespace twinbus::bridge
