// Which points of a hull can be the farthest along a direction: a few, found by the direction alone.
//
// Directions are in 96 cells: by the signs of x, y and z, by which of them is the largest, and by whether the
// others are half as large.  A point p is of a cell when some direction d of it has
//
//     p . d >= q . d     for all points q,
//
// that is, when the cell, a cone of four edges, is not empty after all these planes have cut it.

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace twinbus::inline geometry {

inline constexpr int kSupportCells = 96;

// Of a direction: sign bits of x, y, z as 1, 2, 4; 8 more when |y| is the largest, 16 when |z| is; 24 more when the
// coordinate after the largest (x after z) is at least half of it, 48 when the one before is.
struct SupportCells {
  struct alignas(64) Eight {  // a line of the cache
    double number[8];
  };
  std::vector<Eight> numbers;  // of every cell: x of all, y of all, z of all [m]
  // Where a cell begins there, and behind them where the last ends: most cells have few points, and who asks for one after
  // another finds them in the cache.
  std::array<std::uint32_t, kSupportCells + 1> begin{};

  [[nodiscard]] bool empty() const noexcept { return numbers.empty(); }
  // How many a cell has, a multiple of eight: the last again and again.
  [[nodiscard]] std::size_t size(std::size_t cell) const noexcept { return (begin[cell + 1] - begin[cell]) / 3 * 8; }
  [[nodiscard]] const double* points(std::size_t cell) const noexcept { return numbers[begin[cell]].number; }
};

SupportCells support_cells(const std::vector<Eigen::Vector3d>& points);

}  // namespace twinbus::geometry
