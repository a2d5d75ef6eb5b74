// Preview control against what it must be: optimal, at rest where it is told to rest, and beside the closed form.

#include "control/walk/preview_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "control/walk/dcm_plan.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus {
namespace {

constexpr double kHeight = 0.75, kEvery = 0.005;  // [m], [s]
constexpr int kCount = 400;
constexpr double kSingle = 0.5, kDouble = 0.1;  // [s]

// ZMP under the feet of a walk on one axis: still, six steps of 0.3 m, still.
std::vector<ZmpPiece> steps() {
  std::vector<ZmpPiece> pieces{{{0.0, 0.0}, {0.0, 0.0}, 2.5}};
  for (int k = 0; k < 6; ++k) {
    const Eigen::Vector2d from(0.3 * k, 0.0), to(0.3 * (k + 1), 0.0);
    pieces.push_back({from, to, kDouble});
    pieces.push_back({to, to, kSingle});
  }
  pieces.push_back({{1.8, 0.0}, {1.8, 0.0}, 3.0});
  return pieces;
}
double zmp_at(const std::vector<ZmpPiece>& pieces, double time) {
  for (const ZmpPiece& piece : pieces) {
    if (time < piece.duration)
      return piece.from.x() + (piece.to.x() - piece.from.x()) * time / piece.duration;
    time -= piece.duration;
  }
  return pieces.back().to.x();
}
// DCM of the closed form at that time: backwards from where the walk ends.
double dcm_at(const std::vector<ZmpPiece>& pieces, double time, double omega) {
  Eigen::Vector2d xi = pieces.back().to;
  double end = 0.0;
  for (const ZmpPiece& piece : pieces) end += piece.duration;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    ZmpPiece piece = pieces[k];
    const double begin = end - piece.duration;
    const double passed = std::max(0.0, time - begin);
    if (passed > 0.0) {  // what is left of this piece
      piece.from += (piece.to - piece.from) * (passed / piece.duration);
      piece.duration -= passed;
    }
    xi = dcm_before(piece, xi, omega);
    if (time >= begin) return xi.x();
    end = begin;
  }
  return xi.x();
}

struct Walk {
  double zmp_error = 0.0, dcm_error = 0.0, jerk = 0.0;  // largest
  Cart end;
};
Walk walk(double weight) {
  const PreviewControl preview(kHeight, kEvery, kCount, weight);
  const std::vector<ZmpPiece> pieces = steps();
  const double omega = std::sqrt(kGravity / kHeight);
  std::vector<double> wanted(kCount);
  Walk walk;
  Cart cart;
  for (int tick = 0; kEvery * tick < 8.5; ++tick) {
    const double time = kEvery * tick;
    for (int i = 0; i < kCount; ++i)
      wanted[static_cast<std::size_t>(i)] = zmp_at(pieces, time + kEvery * (i + 1));
    walk.zmp_error = std::max(walk.zmp_error, std::abs(preview.zmp(cart) - zmp_at(pieces, time)));
    walk.dcm_error =
        std::max(walk.dcm_error, std::abs(preview.dcm(cart) - dcm_at(pieces, time, omega)));
    const double jerk = preview.jerk(cart, wanted.data());
    walk.jerk = std::max(walk.jerk, std::abs(jerk));
    cart = PreviewControl::advance(cart, jerk, kEvery);
  }
  walk.end = cart;
  return walk;
}

TEST(PreviewControl, RefusesWhatIsNotPositive) {
  EXPECT_THROW(PreviewControl(0.0, 0.01, 10), std::invalid_argument);
  EXPECT_THROW(PreviewControl(0.8, -0.01, 10), std::invalid_argument);
  EXPECT_THROW(PreviewControl(0.8, 0.01, 0), std::invalid_argument);
  EXPECT_THROW(PreviewControl(std::numeric_limits<double>::quiet_NaN(), 0.01, 10),
               std::invalid_argument);
}

TEST(PreviewControl, WithLittleRegardForJerkItIsTheClosedForm) {
  const Walk strict = walk(1e-10);
  EXPECT_LT(strict.dcm_error, 0.002);
  EXPECT_LT(strict.zmp_error, 0.005);
}

TEST(PreviewControl, TheZmpStaysUnderTheFootAndTheCartEndsWhereItIsTold) {
  const Walk walked = walk(1e-6);
  EXPECT_LT(walked.zmp_error, 0.04);
  EXPECT_NEAR(walked.end.position, 1.8, 1e-3);
  EXPECT_NEAR(walked.end.velocity, 0.0, 1e-2);
}

TEST(PreviewControl, MoreRegardForJerkRoundsTheCorners) {
  const Walk strict = walk(1e-8), soft = walk(1e-4);
  EXPECT_LT(soft.jerk, 0.6 * strict.jerk);
  EXPECT_GT(soft.zmp_error, strict.zmp_error);
}

// The optimum: another jerk at one instant, and the optimal answer to that, cost more.
TEST(PreviewControl, AnyOtherJerkCostsMore) {
  constexpr double kWeight = 1e-6;
  const PreviewControl preview(kHeight, kEvery, kCount, kWeight);
  const std::vector<ZmpPiece> pieces = steps();
  const auto cost = [&](int when, double other) {
    std::vector<double> wanted(kCount);
    Cart cart;
    double sum = 0.0;
    for (int tick = 0; kEvery * tick < 7.5; ++tick) {
      for (int i = 0; i < kCount; ++i)
        wanted[static_cast<std::size_t>(i)] = zmp_at(pieces, kEvery * (tick + i + 1));
      const double error = preview.zmp(cart) - zmp_at(pieces, kEvery * tick);
      const double jerk = preview.jerk(cart, wanted.data()) + (tick == when ? other : 0.0);
      sum += error * error + kWeight * jerk * jerk;
      cart = PreviewControl::advance(cart, jerk, kEvery);
    }
    return sum;
  };
  const double best = cost(-1, 0.0);
  for (const int when : {450, 560, 710}) {
    EXPECT_GT(cost(when, 5.0), best) << when;
    EXPECT_GT(cost(when, -5.0), best) << when;
  }
}

}  // namespace
}  // namespace twinbus
