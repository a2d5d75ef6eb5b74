#include "sim/world/truth.h"

#include <gtest/gtest.h>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

TWINBUS_BOTH_ENGINES(TruthTest);

TEST_P(TruthTest, SaysWhatCarriesTheBodyAndWhenItFell) {
  const Model model = test::block();
  Configuration at = test::standing_block(model);
  const auto world_owner = make_at(at, model);
  World& world = *world_owner;
  ASSERT_EQ(world.step(), Status::kOk);
  SimTruth truth;
  fill_truth(model, felt_feet(model), world, 0.0, truth);
  EXPECT_EQ(truth.contact_count, 8);
  EXPECT_NEAR(truth.foot_force[0][2] + truth.foot_force[1][2], world.mass() * kGravity, 1.0);
  EXPECT_NEAR(truth.zmp[0], 0.0, 1e-4);
  EXPECT_NEAR(truth.zmp_margin, 0.1, 1e-3);
  EXPECT_GT(truth.penetration, 0.0F);
  // Wherever its base has its origin, here in the ground: it stands as long as its mass is up.
  fill_truth(model, felt_feet(model), world, world.com().z(), truth);
  EXPECT_FALSE(truth.fell);
  fill_truth(model, felt_feet(model), world, 2.1 * world.com().z(), truth);
  EXPECT_TRUE(truth.fell);

  at.base.translation().z() = 3.0;
  at.base.linear() = Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
  ASSERT_EQ(world.set(at), Status::kOk);
  fill_truth(model, felt_feet(model), world, 0.5, truth);
  EXPECT_TRUE(truth.fell);
  EXPECT_EQ(truth.contact_count, 0);
  at.base.linear() = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
  ASSERT_EQ(world.set(at), Status::kOk);
  fill_truth(model, felt_feet(model), world, 0.5, truth);
  EXPECT_FALSE(truth.fell);
  fill_truth(model, felt_feet(model), world, 6.5, truth);
  EXPECT_TRUE(truth.fell);
}

TEST(Truth, HasWhatTheEngineDoubtsOfItsSteps) {
  TrustCounts counts;
  SimTruth truth;
  fill_doubts(counts, truth);
  EXPECT_EQ(truth.doubted_steps, 0);
  EXPECT_EQ(truth.last_doubt, StepDoubt::kNone);
  for (std::size_t i = 0; i < kDoubts; ++i) {
    StepTrust step;
    step.doubt[i] = true;
    counts.add(step, 0.0, 0.1 * static_cast<double>(i + 1));
    counts.add({}, 0.0, 0.1 * static_cast<double>(i + 1) + 0.05);
    fill_doubts(counts, truth);
    EXPECT_EQ(truth.doubted_steps, static_cast<int>(i) + 1);
    EXPECT_EQ(truth.doubted[i], 1);
    EXPECT_EQ(static_cast<int>(truth.last_doubt), static_cast<int>(i) + 1);
    EXPECT_DOUBLE_EQ(truth.doubted_since, 0.1);
  }
}

}  // namespace
}  // namespace twinbus
