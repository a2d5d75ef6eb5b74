#include "test/oracles/sphere_cover.h"

#include <gtest/gtest.h>

#include "common/math/index.h"
#include "geometry/bounds/convex_hull.h"
#include "geometry/bounds/shape_mesh.h"
#include "robot/description/load.h"

namespace twinbus {
namespace {

TEST(SphereCover, AHoleIsFound) {
  Shape shape;
  shape.size = {0.1, 0.2, 0.3};
  shape.pose = Eigen::Translation3d(0.1, -0.2, 0.3) * Eigen::Quaterniond(0.5, 0.1, -0.7, 0.2).normalized();
  double outside = 0.0;
  const TriangleMesh box = shape_mesh(shape, outside);
  std::vector<Ball> balls = cover_with_balls(box, convex_hull(box.points), 0.01, 24);
  EXPECT_TRUE(covers(balls, box));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    std::vector<Ball> fewer = balls;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    std::vector<Ball> smaller = balls;
    smaller[i].radius *= 0.5;
    EXPECT_FALSE(covers(fewer, box)) << i;
    EXPECT_FALSE(covers(smaller, box)) << i;
  }
}

TEST(SphereCover, HoldsTheLinksOfARobotAndHardlySticksOut) {
  const Model model = load_robot("hrp1s");
  for (const LinkGeometry& g : build_geometry(model).links) {
    const std::vector<Ball> balls = cover_with_balls(g.mesh, g.hull);
    EXPECT_TRUE(covers(balls, g.mesh)) << model.links[at(g.link)].name;
    EXPECT_LT(excess_over_hull(balls, g.hull), 0.035) << model.links[at(g.link)].name;
  }
}

}  // namespace
}  // namespace twinbus
