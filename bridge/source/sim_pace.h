// The clock that a source lives by: the steady clock, or one that a simulator may stop, slow down or let go tick by tick.
//
// Everything that waits for a source (gate, handover) is asked on this clock, so that a pause is no silence.  Until
// somebody changes the pace, or it stands for a late command, it is the steady clock itself.

#pragma once

#include <cstdint>

#include "common/process/process.h"

namespace twinbus::inline bridge {

class SimPace {
 public:
  static constexpr double kSlowest = 0.01, kFastest = 10.0;
  static constexpr int kMostSteps = 100'000;

  std::int64_t now() const noexcept { return at(monotonic_ns()); }  // [ns]
  // When the steady clock will show what this clock shows then; as now() while it stands.
  std::int64_t real_of(std::int64_t then) const noexcept {
    if (factor_ == 1.0) return then - base_ + real_base_;
    return factor_ > 0.0
               ? real_base_ + static_cast<std::int64_t>(static_cast<double>(then - base_) / factor_)
               : monotonic_ns();
  }
  double factor() const noexcept { return factor_; }
  bool paused() const noexcept { return factor_ == 0.0; }
  bool changed() const noexcept { return factor_ != 1.0; }

  void pause() noexcept { set(0.0); }
  void go() noexcept {
    steps_ = 0;
    set(wanted_);
  }
  // False, and nothing changes, for a pace out of range.
  bool pace(double factor) noexcept {
    if (!(factor >= kSlowest && factor <= kFastest)) return false;
    wanted_ = factor;
    if (!paused()) set(wanted_);
    return true;
  }
  bool step(int ticks) noexcept {
    if (ticks < 1 || ticks > kMostSteps) return false;
    steps_ = ticks;
    set(wanted_);
    return true;
  }
  // Stands still until it goes on; what lies between has not been for whoever is asked on this clock.
  void stand() noexcept {
    set(factor_);
    stands_ = true;
  }
  void end_stand() noexcept {
    stands_ = false;
    real_base_ = monotonic_ns();
  }
  // Goes back by so much, while it runs as the steady clock does.
  void lose(std::int64_t ns) noexcept { real_base_ += ns; }
  // Call after each tick.
  void ticked() noexcept {
    if (steps_ > 0 && --steps_ == 0) set(0.0);
  }

 private:
  std::int64_t at(std::int64_t real) const noexcept {
    if (stands_) return base_;
    if (factor_ == 1.0) return base_ + (real - real_base_);
    return base_ + static_cast<std::int64_t>(factor_ * static_cast<double>(real - real_base_));
  }
  void set(double factor) noexcept {
    const std::int64_t real = monotonic_ns();
    base_ = at(real);
    real_base_ = real;
    factor_ = factor;
  }

  std::int64_t base_ = 0, real_base_ = 0;
  double factor_ = 1.0, wanted_ = 1.0;
  int steps_ = 0;
  bool stands_ = false;
};

}  // namespace twinbus::bridge
