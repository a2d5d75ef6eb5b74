#include "robot/collision/exact/posture_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "common/math/index.h"
#include "robot/collision/exact/self_collision.h"
#include "test/collision/post_and_arm.h"
#include "test/collision/postures.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

constexpr JointCellOptions kCoarse{.per_joint = 6, .looks = 400};

TEST(JointCells, AreFreeWhereTheArmIsClearOfThePostAndListedWhereItIsNot) {
  const Model model = post_and_arm();
  const RobotGeometry geometry = build_geometry(model);
  const auto cells = find_joint_cells(model, geometry, {{0, 1}}, {.per_joint = 400})[0];
  ASSERT_EQ(cells.joints, 1);
  SelfCollision check(model, geometry, {{0, 1}});
  int free = 0, clear = 0;
  for (int k = 0; k < 400; ++k) {
    bool touches = false;  // anywhere in the cell
    for (int i = 0; i <= 8; ++i) {
      check.place(Eigen::VectorXd::Constant(1, -2.0 + 0.01 * (k + i / 8.0)));
      touches = touches || check.touches(0);
    }
    const bool is_free = cells.cell[at(k)] == JointCells::kFree;
    EXPECT_FALSE(is_free && touches) << k;
    free += is_free ? 1 : 0;
    clear += touches ? 0 : 1;
  }
  EXPECT_GT(clear, 300);
  EXPECT_LT(clear, 400);
  EXPECT_GE(free, clear - 4);  // the bound leaves hardly more than the cells at the edges
}

// A model of one joint and its only pair, checked with cells.
struct OneJoint {
  explicit OneJoint(const Model& model)
      : geometry(build_geometry(model)),
        check(model, geometry, {{0, 1}}),
        cells(find_joint_cells(model, geometry, check.pairs(), {.per_joint = 16})) {
    check.use(cells);
  }
  auto free() const { return std::count(cells[0].cell.begin(), cells[0].cell.end(), JointCells::kFree); }
  int touching_at(double q) {
    check.place(Eigen::VectorXd::Constant(1, q));
    return check.touching();
  }
  const RobotGeometry geometry;
  SelfCollision check;
  const std::vector<JointCells> cells;
};

TEST(JointCells, SayNothingOfPosturesBeyondTheLimits) {
  Model model = post_and_arm();
  model.joints[0].lower = 1.0;  // the arm never touches within them
  OneJoint joint(model);
  EXPECT_EQ(joint.free(), 16);
  EXPECT_EQ(joint.touching_at(1.5), 0);
  EXPECT_EQ(joint.touching_at(0.0), 1);
}

TEST(JointCells, ALinkInsideAnotherIsNotFree) {
  Model model = post_and_arm();
  model.links[1].collision[0].size = {0.02, 0.02, 0.02};
  model.links[1].collision[0].pose.translation() = Eigen::Vector3d(0.3, 0.0, 0.0);
  model.joints[0].lower = -0.05;  // so little that it stays inside
  model.joints[0].upper = 0.05;
  OneJoint joint(model);
  EXPECT_EQ(joint.free(), 0);
  EXPECT_EQ(joint.touching_at(0.01), 1);
}

TEST(JointCells, ChangeNoVerdictOnAnyInstructionSetAndAllocateNothing) {
  const Model& model = hrp1s();
  const RobotGeometry geometry = build_geometry(model);
  SelfCollision plain(model, geometry), quick(model, geometry);
  const std::vector<JointCells> cells = find_joint_cells(model, geometry, plain.pairs(), kCoarse);
  std::size_t free = 0, listed = 0;
  for (const JointCells& c : cells) {
    for (const std::uint32_t cell : c.cell) {
      free += cell == JointCells::kFree ? 1 : 0;
      listed += cell > JointCells::kUnknown ? 1 : 0;
    }
  }
  EXPECT_GT(free, 1000U);
  EXPECT_GT(listed, 10U);
  quick.use(cells);
  std::mt19937_64 random(20261122);
  const auto touching = [](SelfCollision& check, const Eigen::VectorXd& q) {
    check.place(q);
    const NoAlloc guard;
    const int n = check.touching();
    EXPECT_EQ(guard.count(), 0);
    return std::set<int>(check.hit(), check.hit() + n);
  };
  int hits = 0;
  for (int k = 0; k < 1500; ++k) {
    quick.use(k % 3 == 0 ? InstructionSet::kBaseline
                         : (k % 3 == 1 ? InstructionSet::kAvx2 : InstructionSet::kAvx512));
    Eigen::VectorXd q(model.joint_count());
    for (int j = 0; j < model.joint_count(); ++j) {  // somewhat beyond the limits, too
      const Joint& joint = model.joints[at(j)];
      const double over = k % 5 == 0 ? 0.1 : 0.0;
      q[j] = std::uniform_real_distribution<double>(joint.lower - over, joint.upper + over)(random);
      if (joint.mimic >= 0) q[j] = joint.mimic_multiplier * q[joint.mimic] + joint.mimic_offset;
    }
    const std::set<int> without = touching(plain, q);
    EXPECT_EQ(touching(quick, q), without) << k;
    hits += static_cast<int>(without.size());
  }
  EXPECT_GT(hits, 1000);
}

TEST(JointCells, OfOtherPairsAreRefused) {
  const Model model = post_and_arm();
  SelfCollision check(model, build_geometry(model), {{0, 1}});
  EXPECT_THROW(check.use(std::vector<JointCells>(2)), std::invalid_argument);
}

}  // namespace
}  // namespace twinbus
