#include "control/loop/mode_queue.h"

#include <algorithm>

namespace twinbus {

bool ModeQueue::seen(const ModeRequest& request) noexcept {
  for (Sender& sender : sender_) {
    if (sender.id != request.sender_id || sender.id == 0) continue;
    if (request.sequence <= sender.sequence) return true;
    sender.sequence = request.sequence;
    return false;
  }
  sender_[next_sender_] = {request.sender_id, request.sequence};
  next_sender_ = (next_sender_ + 1) % kSenders;
  return false;
}

bool ModeQueue::add(const ModeRequest& request, std::int64_t run_id) noexcept {
  if (request.run_id != run_id || seen(request) || count_ == kCapacity) return false;
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

}  // namespace twinbus
