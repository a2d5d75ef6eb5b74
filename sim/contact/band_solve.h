// Linear equations whose matrix is zero far from its diagonal: Gaussian elimination with partial
// pivoting inside the band.  Piles of bodies have such matrices once the bodies are numbered along
// the pile; a robot's own few touched links fill theirs.  What is zero inside the band is known eight
// columns at a time and costs nothing: a body that many others touch makes the band wide, not full.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace twinbus::inline sim {

class BandSolve {
 public:
  // Room for so many rows and entries; entries count what pivoting fills as well.
  BandSolve(std::size_t most_rows, std::size_t most_entries);

  // n equations, all zero, with entries at most `reach` to the left and right of the diagonal.  If
  // there is no room for that, what lies further out than there is room for is left out by add().
  void reset(int n, int reach) noexcept;
  void add(int row, int column, double value) noexcept {
    if (column < row - reach_ || column > row + reach_) return;
    line(row)[column] += value;
    filled(row)[column / kBits] |= std::uint64_t{1} << (column / kWide % 64);
  }
  // Solves in place; the matrix is used up.
  void solve(double* right) noexcept;

 private:
  // Of columns row - reach_ and on; indexed by the column itself.
  double* line(int row) noexcept { return entries_.get() + row * (width_ - 1) + reach_; }

  static constexpr int kWide = 8, kBits = 64 * kWide;  // columns that a bit stands for, and a word
  std::uint64_t* filled(int row) noexcept { return filled_.data() + row * words_; }
  // Ranges of columns from `from` on that are not zero in a row, into spans_; how many.
  int spans_of(int row, int from) noexcept;

  std::unique_ptr<double[]> entries_;  // pages that are never used are never filled
  std::size_t most_entries_;
  std::vector<std::uint64_t> filled_;  // of each row, a bit for kWide columns
  std::vector<std::array<int, 2>> spans_;
  int n_ = 0, reach_ = 0, width_ = 1, words_ = 1;
};

}  // namespace twinbus::sim
