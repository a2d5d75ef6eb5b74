// Whether timed work had its core to itself.
//
// Two hardware threads share the execution ports of one core.  When the other one works for somebody else (another
// guest of the same host), code with many independent instructions takes 1.5 to 2.4 times as long; a chain of dependent
// ones takes as long as ever.  A guest sees no counter of that, but a short loop of independent additions, timed right
// before and right after the work, does: it touches no memory, takes one time alone and 1.2 to 2 times that beside a
// neighbour, whose turns last about 0.1 ms.
//
// What is tagged leans to short times: long work is seldom alone from end to end, and an interrupt between the bursts is not
// seen.  It tells what a neighbour adds; it does not replace the figures of all times.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "common/process/process.h"

namespace twinbus::test {

class CoreAlone {
 public:
  // Learns in 40,000 bursts (20 to 40 ms) how long one takes at least.
  CoreAlone() {
    for (int i = 0; i < 40000; ++i) (void)alone();
  }

  // One burst of half a microsecond: whether nobody shared the core in it.
  [[nodiscard]] bool alone() {
    const std::int64_t then = monotonic_ns();
    burst(kRounds);
    const std::int64_t took = monotonic_ns() - then;
    least_ns_ = std::min(least_ns_, took);
    return static_cast<double>(took) < kAlone * static_cast<double>(least_ns_);
  }

  // Additions in registers that do not wait for one another.  Never inlined: every burst is the same instructions.
  [[gnu::noinline]] static void burst(int rounds) {
    std::uint64_t a = 1, b = 2, c = 3, d = 4, e = 5, f = 6;
    for (int i = 0; i < rounds; ++i) {
      a += 3, b += 3, c += 3, d += 3, e += 3, f += 3;
      asm volatile("" : "+r"(a), "+r"(b), "+r"(c), "+r"(d), "+r"(e), "+r"(f));
    }
  }

 private:
  static constexpr int kRounds = 800;
  static constexpr double kAlone = 1.12;  // of the least: beside a neighbour it is 1.2 to 2
  std::int64_t least_ns_ = std::numeric_limits<std::int64_t>::max();
};

// Times of the same kind of work [us], and which of them had the core alone.
class SharedTimes {
 public:
  void add(double us, bool alone) {
    all_.push_back(us);
    if (alone) alone_.push_back(us);
  }
  // At `share` (0 to 1) of all times in order; 0 when there are none.
  [[nodiscard]] double all(double share) const { return at(all_, share); }
  [[nodiscard]] double alone(double share) const { return at(alone_, share); }
  // The same when the same `count` pieces of work were done over and over, in the same order: each piece's time is the
  // median of its repeats.  What a neighbour adds falls on other pieces in every repeat and drops out; unlike the choice
  // by alone(), this one does not lean to short pieces.
  [[nodiscard]] double repeated(double share, std::size_t count) const {
    std::vector<double> pieces(count), repeats;
    for (std::size_t i = 0; i < count; ++i) {
      repeats.clear();
      for (std::size_t k = i; k < all_.size(); k += count) repeats.push_back(all_[k]);
      pieces[i] = at(repeats, 0.5);
    }
    return at(pieces, share);
  }
  [[nodiscard]] double mean() const { return mean_of(all_); }
  [[nodiscard]] double mean_alone() const { return mean_of(alone_); }
  [[nodiscard]] double share_alone() const {
    return all_.empty() ? 0.0
                        : static_cast<double>(alone_.size()) / static_cast<double>(all_.size());
  }

 private:
  static double at(std::vector<double> us, double share) {
    if (us.empty()) return 0.0;
    const auto nth =
        us.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(us.size() - 1));
    std::nth_element(us.begin(), nth, us.end());
    return *nth;
  }
  static double mean_of(const std::vector<double>& us) {
    return us.empty() ? 0.0
                      : std::accumulate(us.begin(), us.end(), 0.0) / static_cast<double>(us.size());
  }
  std::vector<double> all_, alone_;
};

}  // namespace twinbus::test
