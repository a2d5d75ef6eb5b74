#include "bridge/gate/stop_latch.h"

#include <gtest/gtest.h>

#include <set>

namespace twinbus {
namespace {

StopRequest stop_of(StopKind kind, std::int64_t sender, std::int32_t sequence) {
  StopRequest stop;
  stop.sender_id = sender;
  stop.sequence = sequence;
  stop.kind = kind;
  stop.reason = StopReason::kOperator;
  return stop;
}

TEST(StopLatch, StaysUntilItsOwnNonceIsEchoed) {
  StopLatch latch(7);
  const std::int32_t before = latch.nonce;
  ASSERT_TRUE(latch.stop(stop_of(StopKind::kHold, 5, 1)));
  EXPECT_FALSE(latch.clear(before));  // sent before the stop
  EXPECT_FALSE(latch.clear(0));
  EXPECT_FALSE(latch.clear(latch.nonce + 1));
  EXPECT_TRUE(latch.latched());
  EXPECT_TRUE(latch.clear(latch.nonce));
  EXPECT_FALSE(latch.latched());
}

TEST(StopLatch, AClearThatComesTwiceDoesNotUndoTheNextStop) {
  StopLatch latch(7);
  latch.stop(stop_of(StopKind::kHold, 5, 1));
  const std::int32_t nonce = latch.nonce;
  EXPECT_TRUE(latch.clear(nonce));
  latch.stop(stop_of(StopKind::kHold, 5, 2));
  EXPECT_FALSE(latch.clear(nonce));
  EXPECT_TRUE(latch.latched());
}

TEST(StopLatch, TheHigherKindWinsInEitherOrder) {
  StopLatch up(1), down(1);
  up.stop(stop_of(StopKind::kBalanced, 5, 1));
  up.stop(stop_of(StopKind::kOff, 5, 2));
  down.stop(stop_of(StopKind::kOff, 5, 1));
  down.stop(stop_of(StopKind::kBalanced, 5, 2));
  EXPECT_EQ(up.kind, StopKind::kOff);
  EXPECT_EQ(down.kind, StopKind::kOff);
}

TEST(StopLatch, ARepeatedStopMessageIsTheSameStopAndKeepsTheNonce) {
  StopLatch latch(3);
  latch.stop(stop_of(StopKind::kHold, 5, 1));
  const std::int32_t nonce = latch.nonce;
  EXPECT_FALSE(latch.stop(stop_of(StopKind::kHold, 5, 1)));
  EXPECT_EQ(latch.nonce, nonce);
  EXPECT_TRUE(latch.stop(stop_of(StopKind::kHold, 6, 1)));  // somebody else
  EXPECT_NE(latch.nonce, nonce);
}

TEST(StopLatch, NoncesArePositiveAndDoNotRepeat) {
  StopLatch latch(11);
  std::set<std::int32_t> seen;
  for (int i = 1; i <= 1000; ++i) {
    latch.stop(stop_of(StopKind::kHold, 5, i));
    EXPECT_GT(latch.nonce, 0);
    seen.insert(latch.nonce);
    latch.clear(latch.nonce);
  }
  EXPECT_GT(seen.size(), 998U);
}

TEST(StopLatch, AStandbyIsClearedByTheActiveNonceOfThisStopOnly) {
  StopLatch latch(3);
  latch.share(100, false);  // shown before the stop
  latch.stop(stop_of(StopKind::kHold, 5, 1));
  latch.share(100, true);
  EXPECT_FALSE(latch.clear(100));
  latch.share(200, true);
  EXPECT_TRUE(latch.clear(200));
}

TEST(StopLatch, AStopTheGateDrawsItselfNeverLowersOne) {
  StopLatch latch(3);
  EXPECT_TRUE(latch.stop(StopKind::kOff, StopReason::kOperator));
  EXPECT_FALSE(latch.stop(StopKind::kHold, StopReason::kCommandTimeout));
  EXPECT_EQ(latch.kind, StopKind::kOff);
  EXPECT_EQ(latch.reason, StopReason::kOperator);
}

}  // namespace
}  // namespace twinbus
