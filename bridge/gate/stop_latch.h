// A stop that stays until it is cleared by name: doc/protocol.md section 6.
//
// Every stop draws a new nonce, shown in STATE; a clear must echo it.  So a clear that was sent
// before this stop, came late, came twice or comes out of an old log clears nothing.  A repeated
// stop message (same sender and sequence) is the same stop and keeps the nonce, otherwise an
// operator could never clear while a sender still repeats.

#pragma once

#include <array>
#include <cstdint>

#include "bridge/handover/rules.h"
#include "common/math/splitmix64.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline bridge {

struct StopLatch {
  explicit StopLatch(std::uint64_t seed = 1) noexcept;

  // A stop somebody asks for (kind not kNone).  True if it is a new stop.
  bool stop(const StopRequest& request, RuleSet off = 0) noexcept;
  // A stop the gate draws itself.  True if it raised the kind.
  bool stop(StopKind kind, StopReason reason) noexcept;
  // True if the nonce was right and the latch is open now.
  bool clear(std::int32_t echoed, RuleSet off = 0) noexcept;
  // A source that is not active hears the same stop as the active one.  It may then be cleared by
  // the active one's nonce too, so that one clear from the operator is enough; but not by a nonce
  // that was shown before this stop.
  void share(std::int32_t active_nonce, bool active_stopped) noexcept;

  bool latched() const noexcept { return kind != StopKind::kNone; }

  StopKind kind = StopKind::kNone;
  StopReason reason = StopReason::kNone;
  bool asked = false;  // by somebody, not only drawn by the gate
  std::int32_t nonce = 0;
  std::int32_t shared_nonce = 0;  // 0: none
  std::int32_t shown_nonce = 0;   // by the active source, last
  std::int32_t spent_nonce = 0;   // shown before this stop: cannot clear it

 private:
  struct Heard {
    std::int64_t sender = 0;
    std::int32_t sequence = 0;
  };
  void draw_nonce() noexcept;
  SplitMix64 random_;
  std::array<Heard, 8> heard_{};
  unsigned next_ = 0;
};

}  // namespace twinbus::bridge
