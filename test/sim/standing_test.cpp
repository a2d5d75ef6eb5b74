#include "sim/world/static_equilibrium.h"

#include <gtest/gtest.h>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/engine/ode_world.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

Standing half_sitting(const Model& model, const std::array<double, 2>& height) {
  const NamedPose& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))];
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(pose.q.data(), model.joint_count());
  return stand(model, q, 1.0, {2.5e5, 2.5e5}, height, false);
}

TEST(Standing, TheSpringsCarryTheWeightBelowTheCentreOfMass) {
  const Model model = load_robot("hrp1s");
  for (const double error : {0.0, 0.001, -0.001}) {
    const Standing standing = half_sitting(model, {error, 0.0});
    ASSERT_TRUE(standing.balanced);
    Kinematics kinematics(model);
    kinematics.update(standing.configuration);
    double force = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model.soles[side];
      for (int c = 0; c < kSoleCorners; ++c) {
        const Eigen::Vector3d p =
            kinematics.link_in_world(sole.link) * (sole.frame * sole_corner(sole, c));
        const double f = standing.corner_force[side][static_cast<std::size_t>(c)];
        force += f;
        moment += f * p.head<2>();
      }
    }
    EXPECT_NEAR(force, model.total_mass() * kGravity, 1e-3);
    EXPECT_LT((moment / force - kinematics.com().head<2>()).norm(), 1e-6);
  }
}

TEST(Standing, CornerForcesHaveTheResultantAsked) {
  const Model model = load_robot("hrp1s");
  const Sole& sole = model.soles[0];
  const auto force = corner_forces(sole, 600.0, 12.0, -20.0);
  double fz = 0, mx = 0, my = 0;
  for (int c = 0; c < kSoleCorners; ++c) {
    const double f = force[static_cast<std::size_t>(c)];
    EXPECT_GE(f, 0.0);
    fz += f;
    mx += sole_corner(sole, c).y() * f;
    my -= sole_corner(sole, c).x() * f;
  }
  EXPECT_NEAR(fz, 600.0, 1e-9);
  EXPECT_NEAR(mx, 12.0, 1e-9);
  EXPECT_NEAR(my, -20.0, 1e-9);
}

// On the rim and beyond it, as of a robot that lies: two corners or one carry all, none pulls.
TEST(Standing, AForceBeyondTheRimIsCarriedByItsCornersWithoutAllocating) {
  const Model model = load_robot("hrp1s");
  const Sole& sole = model.soles[0];
  const double x = sole_corner(sole, 0).x(), y = sole_corner(sole, 0).y();
  double shared = 0.0;  // of the corners at that edge
  for (int c = 0; c < kSoleCorners; ++c) {
    if (sole_corner(sole, c).y() * y > 0.0) shared += 300.0 * sole_corner(sole, c).x();
  }
  const NoAlloc no_alloc;
  const auto edge = corner_forces(sole, 600.0, 600.0 * y, -shared);
  const auto corner = corner_forces(sole, 600.0, 600.0 * y, -600.0 * x);
  const auto beyond = corner_forces(sole, 600.0, 2000.0 * y, -2000.0 * x);
  const std::int64_t allocated = no_alloc.count();
  EXPECT_EQ(allocations_counted() ? allocated : 0, 0);
  for (int c = 0; c < kSoleCorners; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const bool at_edge = sole_corner(sole, c).y() * y > 0.0;
    EXPECT_NEAR(edge[i], at_edge ? 300.0 : 0.0, 1e-6) << c;
    EXPECT_NEAR(corner[i], c == 0 ? 600.0 : 0.0, 1e-6) << c;
    EXPECT_GE(beyond[i], 0.0) << c;
  }
  EXPECT_GT(beyond[0], 600.0);
}

TEST(Standing, FittingTheBaseBringsTheForcesBack) {
  const Model model = load_robot("hrp1s");
  const Standing standing = half_sitting(model, {0.0, 0.0});
  Configuration moved = standing.configuration;
  moved.base.pretranslate(Eigen::Vector3d(0, 0, 0.004));
  moved.base.linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()) * moved.base.linear();
  Kinematics kinematics(model);
  fit_base_to_corner_forces(model, standing.corner_force, {2.5e5, 2.5e5}, {0.0, 0.0}, kinematics,
                            moved);
  kinematics.update(moved);
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[side];
    for (int c = 0; c < kSoleCorners; ++c) {
      const Eigen::Vector3d p =
          kinematics.link_in_world(sole.link) * (sole.frame * sole_corner(sole, c));
      EXPECT_NEAR(-2.5e5 * p.z(), standing.corner_force[side][static_cast<std::size_t>(c)], 0.5);
    }
  }
}

TEST(Standing, AFixedBaseHangsClearOfTheGround) {
  const Model model = load_robot("hrp1s");
  const Standing standing =
      stand(model, Eigen::VectorXd::Zero(model.joint_count()), 1.0, {2.5e5, 2.5e5}, {0, 0}, true);
  Kinematics kinematics(model);
  kinematics.update(standing.configuration);
  for (const Sole& sole : model.soles) {
    EXPECT_GT((kinematics.link_in_world(sole.link) * sole.frame).translation().z(), 0.1);
  }
}

}  // namespace
}  // namespace twinbus
