#include "sim/contact/band_solve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline sim {

BandSolve::BandSolve(std::size_t most_rows, std::size_t most_entries)
    : entries_(std::make_unique_for_overwrite<double[]>(most_entries)),
      most_entries_(most_entries),
      filled_(most_rows * (most_rows / kBits + 1)),
      spans_(most_rows / kWide + 2) {}

// An exchange of rows brings in entries up to twice the reach to the right.
void BandSolve::reset(int n, int reach) noexcept {
  n_ = n;
  reach_ = std::min(reach, n - 1);
  const auto room = static_cast<int>(most_entries_ / static_cast<std::size_t>(n));
  if (3 * reach_ + 1 > room) reach_ = std::max(0, (room - 1) / 3);
  width_ = 3 * reach_ + 1;
  words_ = n / kBits + 1;
  std::fill_n(entries_.get(), n_ * width_, 0.0);
  std::fill_n(filled_.begin(), n_ * words_, 0);
}

int BandSolve::spans_of(int row, int from) noexcept {
  const std::uint64_t* const bits = filled(row);
  int count = 0;
  for (int w = from / kBits; w < words_; ++w) {
    std::uint64_t left = bits[w];
    if (w == from / kBits) left &= ~std::uint64_t{0} << (from / kWide % 64);
    while (left != 0) {
      const int first = std::countr_zero(left), many = std::countr_one(left >> first);
      const int begin = std::max(from, w * kBits + first * kWide), end = std::min(n_, w * kBits + (first + many) * kWide);
      if (count > 0 && spans_[at(count - 1)][1] == begin) spans_[at(count - 1)][1] = end;
      else if (begin < end) spans_[at(count++)] = {begin, end};
      left = first + many == 64 ? 0 : left & ~std::uint64_t{0} << (first + many);
    }
  }
  return count;
}

TWINBUS_AVX2_CLONES
void BandSolve::solve(double* right) noexcept {
  for (int c = 0; c < n_; ++c) {
    const int last = std::min(n_ - 1, c + reach_);
    int pivot = c;
    for (int r = c + 1; r <= last; ++r) {
      if (std::abs(line(r)[c]) > std::abs(line(pivot)[c])) pivot = r;
    }
    double* const row = line(c);
    // Beyond these a row has no room: what its last bits stand for ends there.
    const int most = std::min(n_, c + 2 * reach_ + 1);
    if (pivot != c) {
      std::swap_ranges(row + c, row + most, line(pivot) + c);
      std::swap(right[c], right[pivot]);
      std::swap_ranges(filled(c), filled(c) + words_, filled(pivot));
    }
    const double inverse = 1.0 / row[c];
    const int spans = spans_of(c, c + 1);
    for (int r = c + 1; r <= last; ++r) {
      double* const below = line(r);
      const double factor = below[c] * inverse;
      if (factor == 0.0) continue;
      for (int s = 0; s < spans; ++s) {
        const int end = std::min(most, spans_[at(s)][1]);
        for (int k = spans_[at(s)][0]; k < end; ++k) below[k] -= factor * row[k];
      }
      for (int w = c / kBits; w < words_; ++w) filled(r)[w] |= filled(c)[w];
      right[r] -= factor * right[c];
    }
  }
  for (int r = n_ - 1; r >= 0; --r) {
    const double* const row = line(r);
    const int spans = spans_of(r, r + 1), most = std::min(n_, r + 2 * reach_ + 1);
    for (int s = 0; s < spans; ++s) {
      const int end = std::min(most, spans_[at(s)][1]);
      for (int k = spans_[at(s)][0]; k < end; ++k) right[r] -= row[k] * right[k];
    }
    right[r] /= row[r];
  }
}

}  // namespace twinbus::sim
