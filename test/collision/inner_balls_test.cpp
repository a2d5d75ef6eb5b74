#include "robot/collision/links/inscribed_spheres.h"

#include <gtest/gtest.h>

#include "common/math/index.h"
#include "test/collision/postures.h"

namespace twinbus {
namespace {

LinkGeometry box(const Eigen::Vector3d& size) {
  Shape shape;
  shape.size = size;
  return link_geometry({shape});
}

TEST(InnerBalls, OfABoxStayInsideAndItsCornersComeAlong) {
  const Eigen::Vector3d half(0.1, 0.05, 0.03);
  const std::vector<Ball> balls = inner_balls(box(2.0 * half), 24, 8);
  int points = 0;
  double largest = 0.0;
  for (const Ball& ball : balls) {
    const Eigen::Vector3d room = half - ball.center.cwiseAbs();
    EXPECT_GE(room.minCoeff(), ball.radius - 1e-12);
    points += ball.radius == 0.0 ? 1 : 0;
    largest = std::max(largest, ball.radius);
    if (ball.radius == 0.0) {
      EXPECT_NEAR(room.maxCoeff(), 0.0, 1e-9);
    }
  }
  EXPECT_EQ(points, 8);
  EXPECT_GT(balls.size(), 12U);
  EXPECT_GT(largest, 0.9 * half.z());
}

TEST(InnerBalls, NoTriangleOfARobotsLinkIsInsideOne) {
  const RobotGeometry robot = build_geometry(hrp1s());
  int balls = 0;
  for (const LinkGeometry& link : robot.links) {
    for (const Ball& ball : inner_balls(link, 24, 0)) {
      ++balls;
      EXPECT_GT(std::abs(winding_number(link.mesh, ball.center)), 0.5);
      for (const auto& t : link.mesh.triangles) {  // points all over each
        for (double u = 0.0; u <= 1.0; u += 0.25) {
          for (double v = 0.0; u + v <= 1.0; v += 0.25) {
            const Eigen::Vector3d p = u * link.mesh.points[at(t[0])] +
                                      v * link.mesh.points[at(t[1])] +
                                      (1.0 - u - v) * link.mesh.points[at(t[2])];
            ASSERT_GE((p - ball.center).norm(), ball.radius);
          }
        }
      }
    }
  }
  EXPECT_GT(balls, 8 * static_cast<int>(robot.links.size()));
}

TEST(InnerBalls, AnOpenMeshHasNone) {
  LinkGeometry open = box({0.1, 0.1, 0.1});
  open.mesh.triangles.pop_back();
  EXPECT_TRUE(inner_balls(open, 24, 8).empty());
}

TEST(InnerBalls, TheWindingNumberTellsInsideFromOutside) {
  const TriangleMesh mesh = box({0.1, 0.1, 0.1}).mesh;
  EXPECT_NEAR(std::abs(winding_number(mesh, {0.02, -0.03, 0.04})), 1.0, 1e-9);
  EXPECT_NEAR(winding_number(mesh, {0.02, -0.03, 0.06}), 0.0, 1e-9);
}

}  // namespace
}  // namespace twinbus
