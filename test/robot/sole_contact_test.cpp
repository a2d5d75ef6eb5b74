#include "robot/estimation/sole_contact.h"

#include "fixtures.h"

namespace twinbus::test {
namespace {

double force_at(const Sole& sole, const Eigen::Matrix3d& rotation, double height) {
  double force = 0.0;
  for (const double x : {sole.front, -sole.back}) {
    for (const double y : {sole.left, -sole.right}) {
      const double z = height + (rotation * Eigen::Vector3d(x, y, 0)).z();
      force += 0.25 * sole.stiffness * std::max(0.0, -z);
    }
  }
  return force;
}

TEST(SoleHeight, FourSpringsCarryTheForceHoweverTheSoleLeans) {
  const Sole& sole = hrp1s().soles[0];
  std::mt19937 random(3);
  std::uniform_real_distribution<double> tilt(-0.02, 0.02), load(1.0, 2000.0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Matrix3d rotation = rotation_from_rpy(tilt(random), tilt(random), 1.0);
    const double force = load(random);
    EXPECT_NEAR(force_at(sole, rotation, sole_height(sole, rotation, force)), force, 1e-6 * force);
  }
}

TEST(SoleHeight, FlatSoleIsASpring) {
  const Sole& sole = hrp1s().soles[0];
  EXPECT_NEAR(sole_height(sole, Eigen::Matrix3d::Identity(), 640.0), -640.0 / sole.stiffness,
              1e-12);
}

TEST(SoleHeight, WithoutForceTheLowestCornerTouches) {
  const Sole& sole = hrp1s().soles[0];
  const Eigen::Matrix3d rotation = rotation_from_rpy(0.0, 0.1, 0.0);  // toes down
  EXPECT_NEAR(sole_height(sole, rotation, 0.0), sole.front * std::sin(0.1), 1e-12);
  EXPECT_TRUE(std::isfinite(sole_height(sole, rotation, std::nan(""))));
}

}  // namespace
}  // namespace twinbus::test
