#include "sim/contact/band_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "common/math/random.h"

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

}  // namespace
}  // namespace twinbus
