#include "common/simd/block_solve.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline common {

namespace {

using Rows = double[6][8];

// Gauss and Jordan, the largest entry of each column on the diagonal.
TWINBUS_INLINE bool invert(Rows& block) noexcept {
  double work[6][16];  // beside the identity
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 8; ++c) work[r][c] = block[r][c], work[r][8 + c] = c == r ? 1.0 : 0.0;
  }
  for (int c = 0; c < 6; ++c) {
    int pivot = c;
    for (int r = c + 1; r < 6; ++r) {
      if (std::abs(work[r][c]) > std::abs(work[pivot][c])) pivot = r;
    }
    if (!(std::abs(work[pivot][c]) > 0.0)) return false;
    if (pivot != c) std::swap(work[pivot], work[c]);
    const double inverse = 1.0 / work[c][c];
    for (double& value : work[c]) value *= inverse;
    for (int r = 0; r < 6; ++r) {
      const double factor = work[r][c];
      if (r == c || factor == 0.0) continue;
      for (int k = 0; k < 16; ++k) work[r][k] -= factor * work[c][k];
    }
  }
  for (int r = 0; r < 6; ++r) std::copy_n(work[r] + 8, 8, block[r]);
  return true;
}

// to += a b.
TWINBUS_INLINE void add_product(const Rows& a, const Rows& b, Rows& to) noexcept {
  Vec4 left[6], right[6];
  for (int k = 0; k < 6; ++k) left[k] = load4(b[k]), right[k] = load4(b[k] + 4);
  for (int r = 0; r < 6; ++r) {
    Vec4 one = load4(to[r]), two = load4(to[r] + 4);
    for (int k = 0; k < 6; ++k) {
      one += left[k] * a[r][k];
      two += right[k] * a[r][k];
    }
    store4(to[r], one);
    store4(to[r] + 4, two);
  }
}

// to += a b.
TWINBUS_INLINE void add_product(const Rows& a, const double* b, double* to) noexcept {
  for (int r = 0; r < 6; ++r) {
    const Vec4 sum = load4(a[r]) * load4(b) + load4(a[r] + 4) * load4(b + 4);
    to[r] += sum[0] + sum[1] + sum[2] + sum[3];
  }
}

}  // namespace

BlockSolve::BlockSolve(std::size_t most_nodes, std::size_t most_pairs, std::size_t most_blocks)
    : near_(most_nodes * (most_nodes / 64 + 1)),
      degree_(most_nodes),
      place_(most_nodes),
      order_(most_nodes),
      first_(most_nodes + 1),
      after_(std::make_unique_for_overwrite<int[]>(most_blocks)),
      most_blocks_(most_blocks),
      diagonal_(most_nodes),
      lower_(std::make_unique_for_overwrite<Block[]>(most_blocks)),
      upper_(std::make_unique_for_overwrite<Block[]>(most_blocks)),
      right_(most_nodes) {
  asked_.reserve(most_pairs);
  planned_.reserve(most_pairs);
}

bool BlockSolve::begin(int nodes) noexcept {
  nodes_ = nodes;
  if (nodes != planned_nodes_ || asked_ != planned_) {
    planned_nodes_ = nodes;
    planned_.assign(asked_.begin(), asked_.end());
    room_ = asked_.size() < asked_.capacity() && plan();
  }
  if (!room_) return false;
  for (int k = 0; k < nodes; ++k) {
    diagonal_[at(k)] = {};
    for (int r = 0; r < kSize; ++r) diagonal_[at(k)].row[r][r] = 1.0;
  }
  std::fill_n(lower_.get(), first_[at(nodes)], Block{});
  std::fill_n(upper_.get(), first_[at(nodes)], Block{});
  return true;
}

// Of those left the node with the fewest neighbours goes; its neighbours then touch one another.
bool BlockSolve::plan() noexcept {
  const int words = nodes_ / 64 + 1;
  const auto row = [&](int node) { return near_.data() + node * words; };
  std::fill_n(near_.begin(), nodes_ * words, 0);
  for (const auto& [a, b] : planned_) {
    row(a)[b / 64] |= std::uint64_t{1} << (b % 64);
    row(b)[a / 64] |= std::uint64_t{1} << (a % 64);
  }
  const auto count = [&](int node) {
    int sum = 0;
    for (int w = 0; w < words; ++w) sum += std::popcount(row(node)[w]);
    return sum;
  };
  for (int node = 0; node < nodes_; ++node) degree_[at(node)] = count(node);
  std::size_t filled = 0;
  constexpr int kGone = 1 << 30;
  for (int k = 0; k < nodes_; ++k) {
    const int node = static_cast<int>(std::min_element(degree_.begin(), degree_.begin() + nodes_) - degree_.begin());
    order_[at(k)] = node;
    place_[at(node)] = k;
    first_[at(k)] = static_cast<int>(filled);
    if (filled + at(degree_[at(node)]) > most_blocks_) return false;
    degree_[at(node)] = kGone;
    for (int w = 0; w < words; ++w) {
      for (std::uint64_t left = row(node)[w]; left != 0; left &= left - 1) after_[filled++] = 64 * w + std::countr_zero(left);
    }
    for (std::size_t e = at(first_[at(k)]); e < filled; ++e) {
      const int other = after_[e];
      for (int w = 0; w < words; ++w) row(other)[w] |= row(node)[w];
      row(other)[node / 64] &= ~(std::uint64_t{1} << (node % 64));
      row(other)[other / 64] &= ~(std::uint64_t{1} << (other % 64));
      degree_[at(other)] = count(other);
    }
  }
  first_[at(nodes_)] = static_cast<int>(filled);
  for (std::size_t e = 0; e < filled; ++e) after_[e] = place_[at(after_[e])];
  for (int k = 0; k < nodes_; ++k) std::sort(after_.get() + first_[at(k)], after_.get() + first_[at(k + 1)]);
  return true;
}

void BlockSolve::add(int row, int column, const double* block) noexcept {
  const int r = place_[at(row)], c = place_[at(column)], early = std::min(r, c);
  Block* to = &diagonal_[at(r)];
  if (r != c) {
    const int* const end = after_.get() + first_[at(early + 1)];
    const int* const found = std::lower_bound(static_cast<const int*>(after_.get()) + first_[at(early)], end, std::max(r, c));
    if (found == end || *found != std::max(r, c)) return;
    to = (r > c ? lower_ : upper_).get() + (found - after_.get());
  }
  for (int k = 0; k < kSize; ++k) {
    for (int i = 0; i < kSize; ++i) to->row[i][k] += block[kSize * k + i];
  }
}

// What a place does to those after it; its own lower blocks become factors.
TWINBUS_INLINE void BlockSolve::eliminate(int k) noexcept {
  const int begin = first_[at(k)], end = first_[at(k + 1)];
  for (int e = begin; e < end; ++e) {
    Block factor{};
    add_product(lower_[at(e)].row, diagonal_[at(k)].row, factor.row);
    for (auto& row : factor.row) {
      for (double& value : row) value = -value;
    }
    lower_[at(e)] = factor;
    add_product(factor.row, right_[at(k)].row, right_[at(after_[at(e)])].row);
  }
  for (int e = begin; e < end; ++e) {
    const int one = after_[at(e)];
    add_product(lower_[at(e)].row, upper_[at(e)].row, diagonal_[at(one)].row);
    int to = first_[at(one)];
    for (int f = e + 1; f < end; ++f) {
      while (after_[at(to)] != after_[at(f)]) ++to;
      add_product(lower_[at(e)].row, upper_[at(f)].row, upper_[at(to)].row);
      add_product(lower_[at(f)].row, upper_[at(e)].row, lower_[at(to)].row);
    }
  }
}

TWINBUS_AVX2_CLONES
bool BlockSolve::solve(double* right) noexcept {
  for (int k = 0; k < nodes_; ++k) {
    right_[at(k)] = {};
    std::copy_n(right + kSize * order_[at(k)], kSize, right_[at(k)].row);
  }
  for (int k = 0; k < nodes_; ++k) {
    if (!invert(diagonal_[at(k)].row)) return false;
    eliminate(k);
  }
  for (int k = nodes_ - 1; k >= 0; --k) {
    Part later{}, result{};
    for (int e = first_[at(k)]; e < first_[at(k + 1)]; ++e)
      add_product(upper_[at(e)].row, right_[at(after_[at(e)])].row, later.row);
    for (int r = 0; r < kSize; ++r) later.row[r] = right_[at(k)].row[r] - later.row[r];
    add_product(diagonal_[at(k)].row, later.row, result.row);
    right_[at(k)] = result;
    std::copy_n(result.row, kSize, right + kSize * order_[at(k)]);
  }
  return true;
}

}  // namespace twinbus::common
