#include "sim/contact/band_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <utility>
#include <vector>

#include "common/math/random.h"
#include "common/simd/block_solve.h"

namespace twinbus {
namespace {

// Small diagonals, so that rows must be exchanged.
TEST(BandSolve, AgreesWithAFullSolve) {
  BandSolve band(60, 60 * 60);
  Random random(5);
  for (const int n : {1, 2, 7, 60}) {
    for (const int reach : {0, 1, 5, 11}) {
      band.reset(n, reach);
      Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
      Eigen::VectorXd right(n);
      for (int r = 0; r < n; ++r) {
        right[r] = random.normal();
        for (int c = std::max(0, r - reach); c <= std::min(n - 1, r + reach); ++c) {
          full(r, c) = r == c && reach > 0 ? 0.01 : random.normal();
          band.add(r, c, full(r, c));
        }
      }
      const Eigen::VectorXd x = full.fullPivLu().solve(right);
      band.solve(right.data());
      EXPECT_LT((right - x).norm(), 1e-8 * (1.0 + x.norm())) << n << " " << reach;
    }
  }
}

// Bodies that all touch the last one: far entries in every row, and nothing between.
TEST(BandSolve, AgreesWithAFullSolveWhereAllTouchOne) {
  constexpr int n = 600;  // more than one word of columns
  BandSolve band(n, 3 * n * n);
  band.reset(n, n);
  Random random(7);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right(n);
  const auto put = [&](int r, int c) {
    full(r, c) = random.normal();
    band.add(r, c, full(r, c));
  };
  for (int r = 0; r < n; ++r) {
    right[r] = random.normal();
    for (int c = r / 6 * 6; c < r / 6 * 6 + 6; ++c) put(r, c);
    for (int c = n - 6; r < n - 6 && c < n; ++c) put(r, c), put(c, r);
  }
  const Eigen::VectorXd x = full.fullPivLu().solve(right);
  band.solve(right.data());
  EXPECT_LT((right - x).norm(), 1e-7 * (1.0 + x.norm()));
}

TEST(BandSolve, LeavesOutWhatItHasNoRoomFor) {
  BandSolve band(10, 40);  // a band of four columns: a reach of one
  band.reset(10, 9);
  Eigen::VectorXd right = Eigen::VectorXd::Ones(10);
  for (int r = 0; r < 10; ++r) {
    band.add(r, r, 2.0);
    band.add(r, (r + 5) % 10, 1.0);
  }
  band.solve(right.data());
  EXPECT_TRUE(right.isApproxToConstant(0.5));
}

using Block = Eigen::Matrix<double, 6, 6>;

Block random_block(Random& random) {
  Block block;
  for (int i = 0; i < block.size(); ++i) block.data()[i] = random.normal();
  return block;
}

// The same places with other numbers each time, of more nodes than a word has bits.
TEST(BlockSolve, AgreesWithAFullSolve) {
  constexpr int kNodes = 70;
  BlockSolve solve(kNodes, 400, 2000);
  Random random(11);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 1; i < kNodes; ++i) {
    pairs.push_back({i, static_cast<int>(random.uniform() * i)});
    if (i > 10 && i % 3 == 0) pairs.push_back({i - 10, i});
  }
  for (int time = 0; time < 3; ++time) {
    solve.clear();
    for (const auto& [a, b] : pairs) solve.touch(a, b), solve.touch(b, a);
    ASSERT_TRUE(solve.begin(kNodes));
    Eigen::MatrixXd full = Eigen::MatrixXd::Identity(6 * kNodes, 6 * kNodes);
    Eigen::VectorXd right(6 * kNodes);
    for (double& value : right) value = random.normal();
    const auto put = [&](int r, int c, const Block& block) {
      full.block<6, 6>(6 * r, 6 * c) += block;
      solve.add(r, c, block.data());
    };
    for (int i = 0; i < kNodes; ++i) {
      // Exchanges of rows within it are needed.
      Block own = random_block(random) + 30.0 * Block::Identity().rowwise().reverse();
      own.diagonal().array() -= 1.0;
      put(i, i, own);
    }
    for (const auto& [a, b] : pairs) put(a, b, random_block(random)), put(b, a, random_block(random));
    const Eigen::VectorXd x = full.fullPivLu().solve(right);
    ASSERT_TRUE(solve.solve(right.data()));
    EXPECT_LT((right - x).norm(), 1e-9 * (1.0 + x.norm())) << time;
    pairs.push_back({1, kNodes - 1 - time});
  }
}

TEST(BlockSolve, SaysThatItHasNoRoom) {
  BlockSolve solve(4, 20, 5);
  const auto chain = [&](int end) {
    solve.clear();
    for (int i = 0; i < end; ++i) solve.touch(i, i + 1);
    return solve.begin(end + 1);
  };
  EXPECT_TRUE(chain(3));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) solve.touch(i, j);
  }
  EXPECT_FALSE(solve.begin(4));
  EXPECT_TRUE(chain(3));
}

TEST(BlockSolve, SaysThatABlockIsSingular) {
  BlockSolve solve(1, 1, 1);
  ASSERT_TRUE(solve.begin(1));
  const Block minus = -Block::Identity();
  solve.add(0, 0, minus.data());
  Eigen::VectorXd right = Eigen::VectorXd::Ones(6);
  EXPECT_FALSE(solve.solve(right.data()));
}

}  // namespace
}  // namespace twinbus
