#include "control/teleop/joint_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "control/joint/posture.h"
#include "hrp1s.h"

namespace twinbus {
namespace {

constexpr std::int64_t kJointMs = 1'000'000;

class JointJog : public ::testing::Test {
 protected:
  JointJog() : model_(load_robot("hrp1s")), target_(model_) {
    state_.joint_count = static_cast<std::int16_t>(model_.bus_count());
  }
  const Joint& joint() const { return model_.joints[at(model_.bus_joints[at(target_.chosen())])]; }
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  bool next(std::int64_t now_ns, Mode mode = Mode::kHold) { return target_.next(now_ns, state_, mode, pose_); }
  double& q() { return state_.q[at(target_.chosen())]; }

  Model model_;
  JointTarget target_;
  RobotState state_;
  ModeRequest pose_;
};

TEST_F(JointJog, BeginsWithAnArmAndGoesRoundAllJoints) {
  const int first = target_.chosen();
  EXPECT_EQ(model_.bus_joints[at(first)], model_.hands[0].joints.front());
  target_.choose(-1);
  target_.choose(1);
  EXPECT_EQ(target_.chosen(), first);
  for (int k = 0; k < model_.bus_count(); ++k) target_.choose(1);
  EXPECT_EQ(target_.chosen(), first);
}

// A key held for two seconds, with a controller that follows each pose: as fast as it may be, never faster, and at rest soon after.
TEST_F(JointJog, AHeldKeyMovesTheJointAtABoundedSpeed) {
  Posture posture(model_);
  q() = 0.2;
  posture.rest(state_.q);
  double fastest = 0.0, middle = 0.0;
  for (std::int64_t ms = 0; ms < 4000; ms += 2) {
    if (ms % 34 == 0 && ms < 2000) target_.move(0.1, state_, Mode::kPose);
    if (next(ms * kJointMs)) {
      EXPECT_EQ(pose_.mode, Mode::kPose);
      EXPECT_EQ(pose_.joint_mask, std::int64_t{1} << target_.chosen());
      posture.move(pose_.q, pose_.joint_mask, static_cast<double>(pose_.duration));
    }
    posture.advance(0.002);
    fastest = std::max(fastest, std::abs(posture.qd(target_.chosen())));
    q() = posture.q(target_.chosen());
    if (ms == 2000) middle = q();
  }
  EXPECT_LE(fastest, 1.05 * target_.speed());
  EXPECT_GE(middle - 0.2, 0.5 * 2.0 * target_.speed());
  EXPECT_LE(q() - middle, 0.55 * target_.speed()) << "it rests where it was sent last";
  EXPECT_FALSE(posture.moving());
}

TEST_F(JointJog, StopsAtItsLimitAndSaysSo) {
  q() = joint().upper - 0.01;
  for (int i = 0; i < 20; ++i) target_.move(0.1, state_, Mode::kHold);
  ASSERT_TRUE(next(kJointMs * 1000));
  EXPECT_EQ(pose_.q[at(target_.chosen())], joint().upper);
  EXPECT_NE(target_.words(state_).find("is at its upper limit"), std::string::npos);
  target_.move(-0.1, state_, Mode::kHold);
  EXPECT_EQ(target_.words(state_).find("limit"), std::string::npos);
}

// Held by something far behind where it was jogged to: the first key back leads back.
TEST_F(JointJog, LeadsBackAtOnceFromWhereItIsHeld) {
  q() = 0.1;
  for (std::int64_t ms = 1000; ms < 2000; ms += 20) {
    target_.move(0.05, state_, Mode::kPose);
    (void)next(ms * kJointMs, Mode::kPose);
  }
  target_.move(-0.05, state_, Mode::kPose);
  ASSERT_TRUE(next(2200 * kJointMs, Mode::kPose));
  EXPECT_LT(pose_.q[at(target_.chosen())], q());
}

TEST_F(JointJog, SaysThatItIsHeldWhenItDoesNotGo) {
  q() = 0.1;
  std::int64_t ms = 1000;
  for (; ms < 1400; ms += 10) {
    target_.move(0.05, state_, Mode::kPose);
    (void)next(ms * kJointMs, Mode::kPose);
  }
  EXPECT_FALSE(target_.is_held());
  for (; ms < 2200; ms += 10) {
    target_.move(0.05, state_, Mode::kPose);
    (void)next(ms * kJointMs, Mode::kPose);
  }
  EXPECT_TRUE(target_.is_held());
  EXPECT_NE(target_.words(state_).find("is held"), std::string::npos);
  state_.qd[at(target_.chosen())] = 0.2F;
  (void)next(ms * kJointMs, Mode::kPose);
  EXPECT_FALSE(target_.is_held());
}

TEST_F(JointJog, StopsWhereItIsWhenLetGo) {
  q() = 0.1;
  for (int i = 0; i < 5; ++i) target_.move(0.1, state_, Mode::kHold);
  ASSERT_TRUE(next(kJointMs * 1000));
  q() = 0.12;
  target_.stop();
  ASSERT_TRUE(next(kJointMs * 1010));
  EXPECT_EQ(pose_.q[at(target_.chosen())], 0.12);
  EXPECT_FALSE(next(kJointMs * 1020)) << "once";
  target_.stop();
  EXPECT_FALSE(next(kJointMs * 1030)) << "nothing to stop";
}

TEST_F(JointJog, SendsNothingMoreInAModeThatAPoseWouldEnd) {
  std::int64_t ms = 1000;
  for (const Mode mode : {Mode::kIdle, Mode::kWalk, Mode::kStop}) {
    const auto jogged = [&] {
      target_.move(0.1, state_, Mode::kHold);
      const bool asked = next(kJointMs * (ms += 200));
      target_.move(0.1, state_, Mode::kHold);
      return asked;
    };
    ASSERT_TRUE(jogged());
    target_.stop();
    EXPECT_FALSE(next(kJointMs * (ms += 10), mode)) << "let go in it";
    EXPECT_FALSE(next(kJointMs * (ms += 10))) << "nor after it";
    ASSERT_TRUE(jogged());
    EXPECT_FALSE(next(kJointMs * (ms += 200), mode)) << "held on in it";
    target_.stop();
    EXPECT_FALSE(next(kJointMs * (ms += 10))) << "the wish is gone";
  }
}

TEST_F(JointJog, DroppedItAsksForNothingNotEvenToStop) {
  target_.move(0.1, state_, Mode::kHold);
  ASSERT_TRUE(next(kJointMs * 1000));
  target_.move(0.1, state_, Mode::kHold);
  target_.drop();
  EXPECT_FALSE(next(kJointMs * 1200));
  target_.stop();
  EXPECT_FALSE(next(kJointMs * 1210));
  target_.move(0.1, state_, Mode::kHold);
  EXPECT_TRUE(next(kJointMs * 1220)) << "what is wished from then on is";
}

TEST_F(JointJog, DoesNothingWhileTheRobotWalksOrIsLetGoAndWithNonsense) {
  for (const Mode mode : {Mode::kWalk, Mode::kIdle, Mode::kStop}) {
    target_.move(0.1, state_, mode);
    EXPECT_FALSE(next(kJointMs * 1000, mode));
    EXPECT_NE(target_.words(state_), joint().name + " 0.000 rad");
  }
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), 0.0}) {
    target_.move(wrong, state_, Mode::kHold);
    EXPECT_FALSE(next(kJointMs * 2000));
  }
  q() = std::nan("");
  target_.move(0.1, state_, Mode::kHold);
  EXPECT_FALSE(next(kJointMs * 3000));
}

}  // namespace
}  // namespace twinbus
