#include "control/motion/motion_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/control/made_motion.h"

namespace twinbus {
namespace {

using test::made_motion;
using test::squat;
using test::wave;

MotionVerdict check(const MotionFile& file, const MotionOptions& options = {},
                    bool as_recorded = false) {
  const MotionClip clip(test::hrp1s(), file, options);
  return check_motion(test::hrp1s(), clip, {.as_recorded = as_recorded});
}

const MotionFault* find(const MotionVerdict& verdict, FaultKind kind) {
  for (const MotionFault& fault : verdict.faults) {
    if (fault.kind == kind) return &fault;
  }
  return nullptr;
}

TEST(MotionCheck, AWaveOfTheArmsAndASquatPass) {
  const MotionVerdict verdict = check(made_motion(4.0, [](double time, auto& joints) {
    squat(time, joints);
    joints.emplace_back("RARM_SHOULDER_R", -0.8 * wave(time));
    joints.emplace_back("RARM_ELBOW", -0.5 * wave(time));
  }));
  for (const MotionFault& f : verdict.faults)
    ADD_FAILURE() << label(f.kind) << " " << f.what << " " << f.value << " at " << f.tick;
  EXPECT_TRUE(verdict.balance_known);
  EXPECT_GT(verdict.least_margin, 0.02);
  EXPECT_GT(verdict.speed_share, 0.1);
  EXPECT_LT(verdict.effort_share, 1.0);
}

TEST(MotionCheck, ASquatIsKeptAsTheDepthOfTheCentreOfMass) {
  const MotionClip clip(test::hrp1s(), made_motion(4.0, squat), {});
  EXPECT_TRUE(clip.moves_legs());
  EXPECT_EQ(clip.mask(), 0) << "legs alone: balance moves them";
  EXPECT_GT(clip.depth(), 0.02);
  EXPECT_LT(clip.depth(), 0.15);
  EXPECT_NEAR(clip.at_time(1.0).com.z(), -clip.depth(), 2e-3) << "deepest in the middle of a wave";
  const MotionClip upper(test::hrp1s(), made_motion(4.0, squat), {.upper_only = true});
  EXPECT_FALSE(upper.moves_legs());
  EXPECT_EQ(upper.depth(), 0.0);
}

TEST(MotionCheck, APositionBeyondItsLimitIsNamedWithTickValueAndLimit) {
  const MotionVerdict verdict = check(made_motion(
      2.0, [](double time, auto& joints) { joints.emplace_back("RARM_ELBOW", 1.0 * wave(time)); }));
  const MotionFault* fault = find(verdict, FaultKind::kPosition);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->what, "RARM_ELBOW");
  EXPECT_NEAR(fault->limit, 0.174533, 1e-5);
  EXPECT_NEAR(fault->value, 1.0 - 0.6363, 2e-3);
  EXPECT_NEAR(static_cast<double>(fault->worst_tick) * 0.002, 1.0, 0.01);
  // 0.6363 + 0.1745 of the way up: from here on.
  EXPECT_NEAR(static_cast<double>(fault->tick) * 0.002, std::acos(1.0 - 2.0 * 0.810833) / M_PI,
              0.01);
}

TEST(MotionCheck, ASpeedBeyondItsLimitIsNamedAndASlowerPaceHelps) {
  const MotionFile fast = made_motion(2.0, [](double time, auto& joints) {
    joints.emplace_back("LARM_WRIST_Y", 0.6 * std::sin(2.0 * M_PI * 2.0 * time));
  });
  const MotionVerdict verdict = check(fast);
  const MotionFault* fault = find(verdict, FaultKind::kSpeed);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->what, "LARM_WRIST_Y");
  EXPECT_NEAR(fault->value, 0.6 * 4.0 * M_PI, 0.1);
  EXPECT_NEAR(fault->limit, 6.0, 1e-9);
  EXPECT_EQ(find(check(fast, {.speed = 0.95 / verdict.speed_share}), FaultKind::kSpeed), nullptr);
}

TEST(MotionCheck, LinksThatTouchAreNamed) {
  const MotionVerdict verdict = check(made_motion(2.0, [](double time, auto& joints) {
    joints.emplace_back("RARM_SHOULDER_R", 0.4 * wave(time));  // into the trunk
    joints.emplace_back("RARM_SHOULDER_Y", 1.5 * wave(time));
    joints.emplace_back("RARM_ELBOW", -1.5 * wave(time));
  }));
  const MotionFault* fault = find(verdict, FaultKind::kTouch);
  ASSERT_NE(fault, nullptr);
  EXPECT_NE(fault->what.find("RARM"), std::string::npos);
  EXPECT_LT(fault->value, 0.010);
}

TEST(MotionCheck, ATrunkThatIsThrownForwardTipsTheRobotAndSlowlyItDoesNot) {
  const MotionFile thrown = made_motion(4.0, [](double time, auto& joints) {
    joints.emplace_back("WAIST_P", 0.5 * wave(6.0 * time));
  });
  const MotionFault* fault = nullptr;
  const MotionVerdict verdict = check(thrown);
  fault = find(verdict, FaultKind::kBalance);
  ASSERT_NE(fault, nullptr);
  EXPECT_LT(fault->value, 0.010);
  EXPECT_EQ(find(check(thrown, {.speed = 0.1}), FaultKind::kBalance), nullptr);
}

// Legs as recorded: nobody moves the centre of mass back over the soles.
TEST(MotionCheck, AsRecordedALeanOfTheAnklesTips) {
  MotionFile lean = made_motion(6.0, [](double time, auto& joints) {
    for (const char* side : {"L", "R"})
      joints.emplace_back(std::string(side) + "LEG_ANKLE_P", -0.35 * wave(time / 3.0));
  });
  const Model& model = test::hrp1s();
  for (const double time : lean.time) {
    Eigen::Isometry3d& root = lean.root.emplace_back(Eigen::Isometry3d::Identity());
    root.linear() =
        Eigen::AngleAxisd(0.35 * wave(time / 3.0), Eigen::Vector3d::UnitY()).toRotationMatrix();
    root.translation().z() = 0.65;
  }
  const MotionVerdict recorded = check(lean, {}, true);
  ASSERT_NE(find(recorded, FaultKind::kBalance), nullptr);
  EXPECT_EQ(find(check(lean), FaultKind::kBalance), nullptr)
      << "projected, it leans no farther than it stands";
  EXPECT_EQ(model.name, "hrp1s");
}

TEST(MotionClip, AJointThatTheRobotHasNotIsAnErrorWithTheNearest) {
  MotionFile file = made_motion(1.0, [](double, auto& joints) { joints.emplace_back("RARM_ELBOW", 0.0); });
  file.joints[0] = "RARM_ELBW";
  try {
    const MotionClip clip(test::hrp1s(), file, {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean RARM_ELBOW"), std::string::npos)
        << error.what();
  }
}

TEST(MotionClip, ItsPiecesHaveEveryFrameOnce) {
  const MotionClip clip(
      test::hrp1s(),
      made_motion(1.0,
           [](double time, auto& joints) { joints.emplace_back("RARM_ELBOW", -0.1 * wave(time)); }),
      {});
  int next = 0;
  for (const MotionPiece& piece : clip.pieces(7)) {
    EXPECT_EQ(piece.first, next);
    EXPECT_EQ(piece.frames, clip.frames());
    EXPECT_EQ(piece.motion_id, 7);
    next += piece.count;
  }
  EXPECT_EQ(next, clip.frames());
}

}  // namespace
}  // namespace twinbus
