// What the gamepad process asks for: stops, modes, and poses of a joint that is jogged.  For gamepad_main.cpp only.

#pragma once

#include <cstdint>

#include "control/teleop/teleop.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/outgoing.h"

namespace twinbus::inline control {

// What is sent besides GAMEPAD, again and again under the same sequence number until it cannot have
// been missed.
class Requests {
 public:
  explicit Requests(std::int64_t sender_id) { stop_.message.sender_id = mode_.message.sender_id = sender_id; }

  void start(TeleopAction action, const RobotState& state) {
    ModeRequest mode;
    if (action == TeleopAction::kStop) {
      stop_.start({.kind = StopKind::kBalanced, .reason = StopReason::kGamepad});
    } else if (action == TeleopAction::kClear) {
      stop_.start({.stop_nonce = state.stop_nonce, .reason = StopReason::kGamepad});
    } else if (to_mode_request(action, mode)) {
      mode.run_id = state.run_id;
      mode_.start(mode);
      of_operator_ = true;
    }
  }
  // Of a joint that is jogged.  Only when says_mode() is not: it would take the place of the operator's own request.
  void start_pose(ModeRequest pose, std::int64_t run_id) {
    pose.run_id = run_id;
    mode_.start(pose);
    of_operator_ = false;
  }
  // A mode that the operator asked for has not been said often enough.
  bool says_mode() const { return of_operator_ && mode_.left > 0; }

  void send(Bus& bus) {
    stop_.send(bus);
    mode_.send(bus);
  }

 private:
  Outgoing<StopRequest> stop_;
  Outgoing<ModeRequest> mode_;
  bool of_operator_ = false;  // mode_ is
};

}  // namespace twinbus::control
