#include "control/point_feet/point_force_share.h"

#include <gtest/gtest.h>

#include <random>

#include "common/math/pose_math.h"

namespace twinbus {
namespace {

constexpr double kLoad = 120.0, kLength = 0.16, kMu = 0.5;

std::array<PointFoot, kPointFeet> feet(std::array<bool, 4> stands) {
  std::array<PointFoot, kPointFeet> made;
  for (std::size_t i = 0; i < 4; ++i) {
    made[i].arm << (i < 2 ? 0.19 : -0.18), (i % 2 == 0 ? 0.13 : -0.14), -0.3 + 0.01 * static_cast<double>(i);
    made[i].most = stands[i] ? 1.2 * kLoad : 0.0;
  }
  return made;
}

// What the sharing minimizes, written out with its own weights.
double cost(const std::array<PointFoot, kPointFeet>& feet, const TrunkWrench& wanted, const PointForces& f) {
  Eigen::Vector3d force = -wanted.force, moment = -wanted.moment;
  double effort = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    force += f[i];
    moment += feet[i].arm.cross(f[i]);
    effort += f[i].squaredNorm();
  }
  force /= kLoad;
  moment /= kLoad * kLength;
  return force.x() * force.x() + force.y() * force.y() + 4.0 * force.z() * force.z() +
         6.0 * (moment.x() * moment.x() + moment.y() * moment.y()) + moment.z() * moment.z() + 2e-3 * effort / (kLoad * kLoad);
}

// Projected gradient from nothing, until it moves no more: slow, and another way to the one minimum of a convex problem.
PointForces dense(const std::array<PointFoot, kPointFeet>& feet, const TrunkWrench& wanted) {
  PointForces f;
  f.fill(Eigen::Vector3d::Zero());
  for (int round = 0; round < 60000; ++round) {
    Eigen::Vector3d force = -wanted.force, moment = -wanted.moment;
    for (std::size_t i = 0; i < 4; ++i) {
      force += f[i];
      moment += feet[i].arm.cross(f[i]);
    }
    force = Eigen::Vector3d(1.0, 1.0, 4.0).cwiseProduct(force);
    moment = Eigen::Vector3d(6.0, 6.0, 1.0).cwiseProduct(moment) / (kLength * kLength);
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d slope = force + moment.cross(feet[i].arm) + 2e-3 * f[i];
      f[i] = within_cone(f[i] - 0.008 * slope, kMu, feet[i].most);
    }
  }
  return f;
}

TEST(PointForceShare, IsTheDenseMinimumAndWithinTheCones) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  const std::array<std::array<bool, 4>, 4> standing{{{true, true, true, true}, {true, false, false, true}, {true, true, true, false},
                                                     {false, true, true, false}}};
  for (int k = 0; k < 24; ++k) {
    const auto points = feet(standing[static_cast<std::size_t>(k) % 4]);
    TrunkWrench wanted;
    wanted.force << 30.0 * one(random), 30.0 * one(random), kLoad * (1.0 + 0.4 * one(random));
    wanted.moment << 8.0 * one(random), 8.0 * one(random), 4.0 * one(random);
    PointForceShare share(kLoad, kLength, kMu);
    const PointForces& shared = share.solve(points, wanted, 400);
    const PointForces reference = dense(points, wanted);
    const double least = cost(points, wanted, reference);
    EXPECT_NEAR(cost(points, wanted, shared), least, 2e-4 + 0.01 * least) << k;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((shared[i] - reference[i]).norm(), 0.02 * kLoad) << k << ", foot " << i;
      EXPECT_LE(shared[i].head<2>().norm(), kMu * shared[i].z() + 1e-9);
      EXPECT_LE(shared[i].z(), points[i].most + 1e-9);
      EXPECT_GE(shared[i].z(), 0.0);
    }
  }
}

TrunkWrench sum_of(const PointForces& forces, const std::array<PointFoot, kPointFeet>& points) {
  TrunkWrench sum;
  for (std::size_t i = 0; i < kPointFeet; ++i) {
    sum.force += forces[i];
    sum.moment += points[i].arm.cross(forces[i]);
  }
  return sum;
}

TEST(PointForceShare, FourFeetGiveWhatIsAskedWithinTheCones) {
  const auto points = feet({true, true, true, true});
  TrunkWrench wanted;
  wanted.force << 10.0, -8.0, kLoad;
  wanted.moment << 2.0, -3.0, 1.0;
  PointForceShare share(kLoad, kLength, kMu);
  const TrunkWrench reached = sum_of(share.solve(points, wanted, 200), points);
  EXPECT_LT((reached.force - wanted.force).norm(), 0.01 * kLoad);
  EXPECT_LT((reached.moment - wanted.moment).norm(), 0.01 * kLoad * kLength);
}

// As many rounds as a tick has, from the forces of the tick before.
TEST(PointForceShare, IsThereWithTheRoundsOfATickOnceItIsWarm) {
  const auto points = feet({true, false, false, true});
  TrunkWrench wanted;
  wanted.force << 5.0, 5.0, kLoad;
  wanted.moment << 1.0, 0.5, 0.3;
  PointForceShare share(kLoad, kLength, kMu);
  for (int tick = 0; tick < 10; ++tick) (void)share.solve(points, wanted, 40);
  const PointForces warm = share.solve(points, wanted, 40);
  const PointForces reference = dense(points, wanted);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((warm[i] - reference[i]).norm(), 0.01 * kLoad);
}

TEST(WithinCone, IsTheNearestForce) {
  EXPECT_EQ(within_cone({1.0, 0.0, 10.0}, 0.5, 20.0), Eigen::Vector3d(1.0, 0.0, 10.0));
  EXPECT_EQ(within_cone({0.0, 0.0, -3.0}, 0.5, 20.0), Eigen::Vector3d::Zero());
  EXPECT_EQ(within_cone({3.0, 0.0, 4.0}, 0.5, 0.0), Eigen::Vector3d::Zero());
  const Eigen::Vector3d edge = within_cone({10.0, 0.0, 2.0}, 0.5, 20.0);
  EXPECT_NEAR(edge.x(), 0.5 * edge.z(), 1e-12);
  EXPECT_NEAR((Eigen::Vector3d(10.0, 0.0, 2.0) - edge).dot(Eigen::Vector3d(0.5, 0.0, 1.0)), 0.0, 1e-12);  // at right angles to the cone
}

}  // namespace
}  // namespace twinbus
