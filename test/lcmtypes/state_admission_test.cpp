#include "lcmtypes/msg/state_admission.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kTick = 2'000'000;  // [ns]

RobotState state_of(std::int64_t run_id, std::int32_t term, std::int64_t tick,
                    std::int64_t grant_run_id = 0, std::int64_t grant_tick = 0) {
  RobotState state;
  state.run_id = run_id;
  state.term = term;
  state.tick = tick;
  state.grant_run_id = grant_run_id;
  state.grant_tick = grant_tick;
  return state;
}

class Listener : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(hear(state_of(1, 5, 100))); }
  bool hear(const RobotState& state) { return admission.admit(state, now += kTick); }
  StateAdmission admission;
  std::int64_t now = 1'000'000'000;
};

TEST_F(Listener, FollowsTheHolder) {
  EXPECT_TRUE(hear(state_of(1, 5, 101)));
  EXPECT_TRUE(hear(state_of(1, 5, 105)));
  EXPECT_TRUE(hear(state_of(1, 5, 105)));   // lock-step repeats
  EXPECT_FALSE(hear(state_of(1, 5, 104)));  // older
  EXPECT_EQ(admission.ignored(), 1);
}

TEST_F(Listener, GoesToTheGrantedSuccessorAtTheStatedTick) {
  EXPECT_TRUE(hear(state_of(1, 5, 101, 2, 106)));
  EXPECT_FALSE(hear(state_of(2, 6, 105)));  // too early
  EXPECT_FALSE(hear(state_of(3, 6, 106)));  // somebody else
  EXPECT_FALSE(hear(state_of(2, 7, 106)));  // not the next term
  EXPECT_TRUE(hear(state_of(2, 6, 106)));
  EXPECT_EQ(admission.run_id(), 2);
  EXPECT_EQ(admission.changes(), 1);
  EXPECT_FALSE(hear(state_of(1, 5, 107)));  // the old holder is over
}

TEST_F(Listener, GoesToAGrantedSuccessorThatIsSlowerThanTheHolder) {
  EXPECT_TRUE(hear(state_of(1, 5, 101, 2, 106)));
  EXPECT_TRUE(hear(state_of(1, 5, 108, 2, 106)));
  EXPECT_FALSE(hear(state_of(2, 6, 105)));
  EXPECT_TRUE(hear(state_of(2, 6, 106)));
  EXPECT_FALSE(hear(state_of(1, 5, 109, 2, 106)));
  EXPECT_TRUE(hear(state_of(2, 6, 107)));
}

TEST_F(Listener, BelievesTheHolderThatTakesItsGrantBack) {
  EXPECT_TRUE(hear(state_of(1, 5, 101, 2, 106)));
  EXPECT_TRUE(hear(state_of(1, 7, 110)));
  EXPECT_FALSE(hear(state_of(2, 6, 111)));
  EXPECT_EQ(admission.run_id(), 1);
}

TEST_F(Listener, DoesNotBelieveAGrantTakenBackThatWasNeverGiven) {
  EXPECT_FALSE(hear(state_of(1, 7, 101)));
  EXPECT_TRUE(hear(state_of(1, 5, 102)));
}

TEST_F(Listener, ReturnsToTheHolderThatTookItsGrantBackAfterTheSuccessorWasHeard) {
  EXPECT_TRUE(hear(state_of(1, 5, 101, 2, 106)));
  EXPECT_TRUE(hear(state_of(2, 6, 106)));
  EXPECT_TRUE(hear(state_of(2, 6, 111)));
  EXPECT_TRUE(hear(state_of(1, 7, 109)));
  EXPECT_EQ(admission.run_id(), 1);
  EXPECT_FALSE(hear(state_of(2, 6, 112)));
}

TEST_F(Listener, NoSingleDatagramTakesItAway) {
  EXPECT_FALSE(hear(state_of(9, 6, 101)));
  EXPECT_FALSE(hear(state_of(9, 1'000'000, 101)));
  EXPECT_FALSE(hear(state_of(1, 5, 1'000'100)));
  EXPECT_FALSE(hear(state_of(9, 5, 101)));
  EXPECT_TRUE(hear(state_of(1, 5, 101)));
  EXPECT_EQ(admission.ignored(), 4);
}

TEST_F(Listener, ActivationIsBelievedWhenNobodyIsActive) {
  now += 100'000'000;
  EXPECT_FALSE(hear(state_of(9, 5, 3)));  // an old term
  EXPECT_TRUE(hear(state_of(9, 6, 3)));
}

TEST_F(Listener, AnythingIsBelievedAfterALongSilence) {
  now += 1'000'000'000;
  EXPECT_TRUE(hear(state_of(9, 1, 3)));
}

}  // namespace
}  // namespace twinbus
