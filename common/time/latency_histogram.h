// A histogram of durations that never allocates: median, 99th and 99.9th percentile and the worst,
// for heartbeats and benches.
//
// Sixteen buckets per octave from 1 ns to an hour, so a percentile is right to 3.2 %; minimum and
// maximum are exact.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace twinbus::inline common {

class RateStats {
 public:
  void add(std::int64_t duration_ns) noexcept {
    const std::int64_t value = std::max<std::int64_t>(duration_ns, 0);
    ++count_[bucket(static_cast<std::uint64_t>(value))];
    ++total_;
    max_ = std::max(max_, value);
    min_ = std::min(min_, value);
  }

  void clear() noexcept { *this = RateStats(); }

  std::int64_t count() const noexcept { return total_; }
  std::int64_t max_ns() const noexcept { return max_; }
  std::int64_t min_ns() const noexcept { return total_ > 0 ? min_ : 0; }
  double median_ns() const noexcept { return percentile_ns(0.5); }
  double p99_ns() const noexcept { return percentile_ns(0.99); }
  double p999_ns() const noexcept { return percentile_ns(0.999); }

  // The duration that a share of all (0..1) does not exceed; 0 without any.
  double percentile_ns(double share) const noexcept {
    if (total_ == 0) return 0.0;
    const auto rank = static_cast<std::int64_t>(
        std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(total_)));
    std::int64_t seen = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
      seen += count_[i];
      if (seen >= std::max<std::int64_t>(rank, 1)) {
        return std::clamp(middle(i), static_cast<double>(min_), static_cast<double>(max_));
      }
    }
    return static_cast<double>(max_);
  }

  // Puts the durations of another histogram in.
  void merge(const RateStats& other) noexcept {
    for (std::size_t i = 0; i < kBuckets; ++i) count_[i] += other.count_[i];
    total_ += other.total_;
    max_ = std::max(max_, other.max_);
    min_ = std::min(min_, other.min_);
  }

 private:
  static constexpr std::size_t kPerOctave = 16;
  static constexpr std::size_t kOctaves = 43;
  static constexpr std::size_t kBuckets = kPerOctave * kOctaves;

  // Octave from the highest bit, place inside it linear: 16 steps of at most 6 %.
  static std::size_t bucket(std::uint64_t value) noexcept {
    if (value < kPerOctave) return static_cast<std::size_t>(value);
    const auto shift = static_cast<unsigned>(std::bit_width(value)) - 5u;
    const auto index =
        static_cast<std::size_t>(shift) * kPerOctave + static_cast<std::size_t>(value >> shift);
    return std::min(index, kBuckets - 1);
  }

  static double middle(std::size_t index) noexcept {
    if (index < 2 * kPerOctave) return static_cast<double>(index);
    const std::size_t shift = index / kPerOctave - 1;
    const auto low = static_cast<double>(index - shift * kPerOctave);
    return std::ldexp(low + 0.5, static_cast<int>(shift)) - 0.5;
  }

  std::array<std::int64_t, kBuckets> count_{};
  std::int64_t total_ = 0;
  std::int64_t max_ = 0;
  std::int64_t min_ = INT64_MAX;
};

}  // namespace twinbus::common
