// Where the CPU time of a thread goes, part by part: what begins within a part and has a name of its own is not counted in that.
//
//   PartClock clock;
//   { PartClock::Running running(clock); work(); }       // in work(): const PartScope scope("contacts, found");
//
// A scope costs nothing to speak of where no clock runs.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "common/time/cpu_time.h"

namespace twinbus::inline common {

class PartClock {
 public:
  struct Part {
    std::string_view name;
    double seconds = 0.0;  // CPU
    long times = 0;        // it was begun
  };

  // now: seconds; cost: of one look at it, which is nobody's.
  explicit PartClock(double (*now)() = thread_cpu_seconds, double cost = cost_of_thread_clock()) noexcept
      : now_(now), cost_(cost) {}

  // While it lives, the scopes of this thread are of that clock.
  class Running {
   public:
    explicit Running(PartClock& clock) noexcept : before_(now_running()) { now_running() = &clock; }
    ~Running() { now_running() = before_; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    PartClock* before_;
  };

  // In the order in which they were first begun.
  std::span<const Part> parts() const noexcept { return {parts_.data(), count_}; }

 private:
  friend class PartScope;
  static constexpr std::size_t kMost = 16, kDeepest = 16;

  static PartClock*& now_running() noexcept {
    static thread_local constinit PartClock* running = nullptr;
    return running;
  }
  // Up to now it was the innermost part; looking at the clock is nobody's.
  void look() noexcept {
    const double now = now_();
    if (depth_ > 0) parts_[open_[std::min(depth_, kDeepest) - 1]].seconds += std::max(0.0, now - last_ - cost_);
    last_ = now;
  }
  void begin(std::string_view name) noexcept {
    look();
    const auto last = parts_.begin() + static_cast<std::ptrdiff_t>(count_);
    auto found = std::find_if(parts_.begin(), last, [name](const Part& part) { return part.name == name; });
    if (found == last && count_ < kMost) parts_[count_++].name = name;
    if (found == parts_.end()) --found;  // there is no room: the last one takes it
    ++found->times;
    if (depth_ < kDeepest) open_[depth_] = static_cast<std::size_t>(found - parts_.begin());
    ++depth_;
  }
  void end() noexcept {
    look();
    --depth_;
  }

  std::array<Part, kMost> parts_{};
  std::size_t count_ = 0, depth_ = 0;
  std::array<std::size_t, kDeepest> open_{};
  double (*now_)();
  double cost_, last_ = 0.0;
};

// From here to the end of the block is a part; name: lives as long as the clock.
class PartScope {
 public:
  explicit PartScope(std::string_view name) noexcept : clock_(PartClock::now_running()) {
    if (clock_ != nullptr) clock_->begin(name);
  }
  ~PartScope() {
    if (clock_ != nullptr) clock_->end();
  }
  PartScope(const PartScope&) = delete;
  PartScope& operator=(const PartScope&) = delete;

 private:
  PartClock* clock_;
};

}  // namespace twinbus::common
