#include "control/loop/mode_queue.h"

namespace twinbus::inline control {

bool ModeQueue::add(const ModeRequest& request, std::int64_t run_id) noexcept {
  if (request.run_id != run_id || count_ == kCapacity ||
      !heard_.is_new(request.sender_id, request.sequence))
    return false;
  waiting_[count_++] = request;
  return true;
}

const ModeRequest* ModeQueue::take(std::int64_t tick) noexcept {
  std::size_t best = count_;
  for (std::size_t i = 0; i < count_; ++i) {
    if (waiting_[i].at_tick > tick) continue;
    if (best == count_ || waiting_[i].at_tick < waiting_[best].at_tick) best = i;
  }
  if (best == count_) return nullptr;
  taken_ = waiting_[best];
  std::move(waiting_.begin() + static_cast<std::ptrdiff_t>(best) + 1,
            waiting_.begin() + static_cast<std::ptrdiff_t>(count_),
            waiting_.begin() + static_cast<std::ptrdiff_t>(best));
  --count_;
  return &taken_;
}

}  // namespace twinbus::control
