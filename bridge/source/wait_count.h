// How long a simulated world has stood still for late commands, and when people are told.

#pragma once

#include <array>
#include <cstdint>
#include <cstdio>

namespace twinbus::inline bridge {

class WaitCount {
 public:
  // It stood still for so long until now (steady clock) [ns].  Gives a sentence now and then, else null.
  const char* add(std::int64_t waited_ns, std::int64_t now) noexcept {
    if (waited_ns_ == 0 && now - told_ns_ > kSeldom) since_ns_ = now - waited_ns;
    waited_ns_ += waited_ns;
    if (waited_ns_ < kLong || now - told_ns_ < (waited_ns >= kLong ? kOften : kSeldom)) return nullptr;
    std::snprintf(text_.data(), text_.size(),
                  "slower than real time: the simulated world stood still for %.0f ms of the last %.1f s, for late commands",
                  1e-6 * static_cast<double>(waited_ns_), 1e-9 * static_cast<double>(now - since_ns_));
    told_ns_ = since_ns_ = now;
    waited_ns_ = 0;
    return text_.data();
  }

 private:
  static constexpr std::int64_t kLong = 20'000'000, kOften = 1'000'000'000, kSeldom = 10'000'000'000;
  std::int64_t waited_ns_ = 0, since_ns_ = 0, told_ns_ = 0;  // since it was told
  std::array<char, 160> text_{};
};

}  // namespace twinbus::bridge
