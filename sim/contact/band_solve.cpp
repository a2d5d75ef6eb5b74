#include "sim/contact/band_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/index.h"

namespace twinbus {

BandSolve::BandSolve(std::size_t most_rows, std::size_t most_entries)
    : entries_(std::make_unique_for_overwrite<double[]>(most_entries)),
      most_entries_(most_entries),
      ends_(most_rows) {}

// An exchange of rows brings in entries up to twice the reach to the right.
void BandSolve::reset(int n, int reach) noexcept {
  n_ = n;
  reach_ = std::min(reach, n - 1);
  const auto room = static_cast<int>(most_entries_ / static_cast<std::size_t>(n));
  if (3 * reach_ + 1 > room) reach_ = std::max(0, (room - 1) / 3);
  width_ = 3 * reach_ + 1;
  std::fill_n(entries_.get(), n_ * width_, 0.0);
  std::fill_n(ends_.begin(), n_, 0);
}

void BandSolve::solve(double* right) noexcept {
  for (int c = 0; c < n_; ++c) {
    const int last = std::min(n_ - 1, c + reach_);
    int pivot = c;
    for (int r = c + 1; r <= last; ++r) {
      if (std::abs(line(r)[c]) > std::abs(line(pivot)[c])) pivot = r;
    }
    double* const row = line(c);
    if (pivot != c) {
      const int end = std::max(ends_[at(c)], ends_[at(pivot)]);
      std::swap_ranges(row + c, row + end, line(pivot) + c);
      std::swap(right[c], right[pivot]);
      std::swap(ends_[at(c)], ends_[at(pivot)]);
    }
    const double inverse = 1.0 / row[c];
    const int end = ends_[at(c)];
    for (int r = c + 1; r <= last; ++r) {
      double* const below = line(r);
      const double factor = below[c] * inverse;
      if (factor == 0.0) continue;
      for (int k = c + 1; k < end; ++k) below[k] -= factor * row[k];
      ends_[at(r)] = std::max(ends_[at(r)], end);
      right[r] -= factor * right[c];
    }
  }
  for (int r = n_ - 1; r >= 0; --r) {
    const double* const row = line(r);
    for (int k = r + 1; k < ends_[at(r)]; ++k) right[r] -= row[k] * right[k];
    right[r] /= row[r];
  }
}

}  // namespace twinbus
