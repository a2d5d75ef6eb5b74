// Linear equations whose matrix is zero far from its diagonal: Gaussian elimination with partial
// pivoting inside the band.  Piles of bodies have such matrices once the bodies are numbered along
// the pile; a robot's own few touched links fill theirs.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace twinbus {

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
    if (column >= ends_[static_cast<std::size_t>(row)]) {
      ends_[static_cast<std::size_t>(row)] = column + 1;
    }
  }
  // Solves in place; the matrix is used up.
  void solve(double* right) noexcept;

 private:
  // Of columns row - reach_ and on; indexed by the column itself.
  double* line(int row) noexcept { return entries_.get() + row * (width_ - 1) + reach_; }

  std::unique_ptr<double[]> entries_;  // pages that are never used are never filled
  std::size_t most_entries_;
  std::vector<int> ends_;  // of each row: nothing from here on
  int n_ = 0, reach_ = 0, width_ = 1;
};

}  // namespace twinbus
