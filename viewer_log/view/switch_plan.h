// What the page's "Switch to it" asks of the sources, one request after the other, as
// `./twinbus switch` does: into standby first, then to take over once its posture is near.
//
// Pure: neither bus nor clock.  The sources decide; a refusal is shown with the source that gave it.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/messages.h"
#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

class SwitchPlan {
 public:
  void start(std::int64_t target_run_id, std::int64_t now_ns);

  // Call often.  True when request is to be sent now.
  [[nodiscard]] bool next(const StackView& view, std::int64_t now_ns, SourceRequest& request);

 private:
  enum class Phase { kDone, kBegin, kStandby, kNear };
  void ask_takeover(const StackView& view, SourceRequest& request);

  Phase phase_ = Phase::kDone;
  std::int64_t target_ = 0, since_ns_ = 0, near_ns_ = 0;
};

}  // namespace twinbus::viewer_log
