// Linear equations in blocks of 6 by 6, most of which are zero: elimination without exchanges between blocks, in an order
// that keeps few of them filled (minimum degree; Tinney and Walker 1967).  Order and places are kept while what touches
// stays the same.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace twinbus::inline common {

class BlockSolve {
 public:
  using Pair = std::pair<int, int>;

  // Room for so many nodes, pairs of them, and blocks off the diagonal, what elimination fills included.
  BlockSolve(std::size_t most_nodes, std::size_t most_pairs, std::size_t most_blocks);

  // Which pairs of nodes have blocks, both ways; each may be named more than once.
  void clear() noexcept { asked_.clear(); }
  void touch(int a, int b) noexcept {
    if (a != b && asked_.size() < asked_.capacity()) asked_.push_back({a, b});
  }
  // The identity.  False: no room.
  bool begin(int nodes) noexcept;
  // Column by column, of a pair that was named.
  void add(int row, int column, const double* block) noexcept;
  // Solves in place; the matrix is used up.  False: a block on the diagonal was singular.
  bool solve(double* right) noexcept;

 private:
  static constexpr int kSize = 6, kWide = 8;  // a row of a block is as wide as lanes are
  struct alignas(64) Block {
    double row[kSize][kWide];
  };
  struct alignas(64) Part {
    double row[kWide];
  };

  bool plan() noexcept;
  void eliminate(int k) noexcept;

  std::vector<Pair> asked_, planned_;
  int nodes_ = 0, planned_nodes_ = -1;
  bool room_ = false;
  std::vector<std::uint64_t> near_;   // of each node, a bit for each it is coupled with
  std::vector<int> degree_;
  std::vector<int> place_, order_;    // of a node in the elimination; the node at a place
  std::vector<int> first_;            // of a place, in after_
  std::unique_ptr<int[]> after_;      // places coupled with it that come later, rising
  std::size_t most_blocks_;           // of after_
  std::vector<Block> diagonal_;
  std::unique_ptr<Block[]> lower_, upper_;  // as after_; pages that are never used are never filled
  std::vector<Part> right_;
};

}  // namespace twinbus::common
