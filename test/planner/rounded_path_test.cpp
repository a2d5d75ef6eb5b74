#include "planner/timing/rounded_path.h"

#include <gtest/gtest.h>

#include "test/planner/flat_world.h"

namespace twinbus {
namespace {

const JointPath kCorners = {point2(0.0, 0.0), point2(1.0, 0.0), point2(1.0, 1.0), point2(0.2, 1.5)};

TEST(RoundedPath, KeepsItsEndsAndHasAContinuousDerivativeOfLengthOneAtMost) {
  FlatWorld world;
  const auto parts = RoundedPath::parts(world, kCorners, 0.3);
  ASSERT_EQ(parts.size(), 1U);
  const RoundedPath& path = parts[0];
  JointPoint q, dq, ddq, last;
  path.at(0.0, q, last, ddq);
  EXPECT_NEAR((q - kCorners.front()).norm(), 0.0, 1e-12);
  constexpr double kStep = 1e-4;
  for (double s = kStep; s <= path.length(); s += kStep) {
    path.at(s, q, dq, ddq);
    EXPECT_LE(dq.norm(), 1.0 + 1e-9);
    // A jump of the derivative would be as large as the corner; a curve turns by at most |ddq| ds.
    ASSERT_LT((dq - last).norm(), 10.0 * kStep) << "s = " << s;
    last = dq;
  }
  path.at(path.length(), q, dq, ddq);
  EXPECT_NEAR((q - kCorners.back()).norm(), 0.0, 1e-12);
}

TEST(RoundedPath, DerivativesAreThoseOfThePosition) {
  FlatWorld world;
  const auto parts = RoundedPath::parts(world, kCorners, 0.3);
  ASSERT_EQ(parts.size(), 1U);
  JointPoint a, b, q, dq, ddq, da, db, unused;
  constexpr double kH = 1e-5;
  for (double s = 0.0137; s < parts[0].length() - kH; s += 0.0371) {
    parts[0].at(s, q, dq, ddq);
    parts[0].at(s - kH, a, da, unused);
    parts[0].at(s + kH, b, db, unused);
    EXPECT_LT(((b - a) / (2.0 * kH) - dq).norm(), 1e-6);
    EXPECT_LT(((db - da) / (2.0 * kH) - ddq).norm(), 1e-4);
  }
}

TEST(RoundedPath, ACornerThatCannotBeCutEndsAPart) {
  FlatWorld world;
  // The inside of the corner at (0, 1.8) is wall up to the corner itself.
  class NoCurve : public FlatWorld {
   public:
    bool point_free(const JointPoint& q) override {
      return std::abs(q[0]) < 1e-9 || std::abs(q[1]) < 1e-9;
    }
  } axes;
  const auto parts =
      RoundedPath::parts(axes, {point2(1.0, 0.0), point2(0.0, 0.0), point2(0.0, 1.0)}, 0.3);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].length() + parts[1].length(), 2.0, 1e-12);
}

TEST(RoundedPath, CurvesStayFree) {
  FlatWorld world;
  world.walls = {{0.0, 1.8, 0.3}};
  const JointPath corners = {point2(-2.0, 0.0), point2(-0.15, 1.7), point2(0.15, 1.7),
                             point2(2.0, 0.0)};
  ASSERT_TRUE(world.path_free(corners));
  for (const RoundedPath& part : RoundedPath::parts(world, corners, 0.4)) {
    JointPoint q, dq, ddq;
    for (double s = 0.0; s < part.length(); s += 1e-3) {
      part.at(s, q, dq, ddq);
      EXPECT_TRUE(world.point_free(q)) << q.transpose();
    }
  }
}

TEST(RoundedPath, DoubledCornersAndAPathOfNoLengthAreUnderstood) {
  FlatWorld world;
  const auto parts = RoundedPath::parts(
      world, {point2(0.0, 0.0), point2(0.0, 0.0), point2(1.0, 0.0), point2(1.0, 0.0)}, 0.2);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].length(), 1.0, 1e-12);
  EXPECT_TRUE(RoundedPath::parts(world, {point2(1.0, 1.0), point2(1.0, 1.0)}, 0.2).empty());
}

}  // namespace
}  // namespace twinbus
