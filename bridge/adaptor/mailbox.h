// Passes the newest value from one thread to one other without a lock and without waiting: three
// buffers, one index.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace twinbus::inline bridge {

template <class T>
class Mailbox {
 public:
  // Writer's thread only.
  void put(const T& value) noexcept {
    buffers_[write_] = value;
    write_ =
        middle_.exchange(static_cast<std::uint8_t>(write_ | kFresh), std::memory_order_acq_rel) &
        kIndex;
  }

  // Reader's thread only.  False when nothing was put since the last take.
  bool take(T& value) noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    read_ = middle_.exchange(read_, std::memory_order_acq_rel) & kIndex;
    value = buffers_[read_];
    return true;
  }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;
  std::array<T, 3> buffers_{};
  std::uint8_t write_ = 0;
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t read_ = 2;
};

}  // namespace twinbus::bridge
