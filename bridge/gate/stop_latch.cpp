#include "bridge/gate/stop_latch.h"

namespace twinbus::inline bridge {

StopLatch::StopLatch(std::uint64_t seed) noexcept : random_(seed) { draw_nonce(); }

// A positive int32 that differs from the last.
void StopLatch::draw_nonce() noexcept {
  const std::int32_t last = nonce;
  do nonce = static_cast<std::int32_t>(random_.next() & 0x7fffffffU);
  while (nonce == 0 || nonce == last);
}

bool StopLatch::stop(const StopRequest& request, RuleSet off) noexcept {
  const bool higher = request.kind > kind;
  if (latched() && !higher) {
    for (const Heard& heard : heard_) {
      if (heard.sender == request.sender_id && heard.sequence == request.sequence) return false;
    }
  }
  heard_[next_] = {request.sender_id, request.sequence};
  next_ = (next_ + 1) % static_cast<unsigned>(heard_.size());
  asked = true;
  if (higher || !holds(off, Rule::kHigherKindWins)) {
    kind = request.kind;
    reason = request.reason;
  }
  if (holds(off, Rule::kNonceChanges)) draw_nonce();
  shared_nonce = 0;
  spent_nonce = shown_nonce;
  return true;
}

bool StopLatch::stop(StopKind new_kind, StopReason new_reason) noexcept {
  if (!(new_kind > kind)) return false;
  kind = new_kind;
  reason = new_reason;
  draw_nonce();
  shared_nonce = 0;
  spent_nonce = shown_nonce;
  return true;
}

bool StopLatch::clear(std::int32_t echoed, RuleSet off) noexcept {
  if (!latched()) return false;
  const bool mine = echoed == nonce;
  const bool shared = shared_nonce != 0 && echoed == shared_nonce;
  if (!mine && !shared && holds(off, Rule::kClearNeedsNonce)) return false;
  shared_nonce = 0;
  asked = false;
  kind = StopKind::kNone;
  reason = StopReason::kNone;
  return true;
}

void StopLatch::share(std::int32_t active_nonce, bool active_stopped) noexcept {
  shown_nonce = active_nonce;
  if (latched() && active_stopped && active_nonce != spent_nonce) shared_nonce = active_nonce;
}

}  // namespace twinbus::bridge
