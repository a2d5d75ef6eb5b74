#include "bridge/source/sim_pace.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kHour = 3'600'000'000'000;

TEST(SimPace, StandsForALateCommandAndGoesOnWhereItStood) {
  SimPace clock;
  const std::int64_t before = clock.now();
  clock.stand();
  const std::int64_t stood = clock.now();
  EXPECT_GE(stood, before);
  EXPECT_EQ(clock.now(), stood);
  EXPECT_FALSE(clock.changed());  // it is no pause, and no slow motion
  clock.end_stand();
  EXPECT_GE(clock.now(), stood);
  EXPECT_LT(clock.now(), stood + kHour);
}

TEST(SimPace, LosesTheTimeOfAProcessThatSlept) {
  SimPace clock;
  const std::int64_t before = clock.now();
  clock.lose(kHour);
  EXPECT_LT(clock.now(), before);
  // What is due on this clock is due later by as much.
  EXPECT_GE(clock.real_of(before), before + kHour);
}

TEST(SimPace, APauseThatIsAskedForWhileItStandsHolds) {
  SimPace clock;
  clock.stand();
  const std::int64_t stood = clock.now();
  clock.pause();
  clock.end_stand();
  EXPECT_TRUE(clock.paused());
  EXPECT_EQ(clock.now(), stood);
}

}  // namespace
}  // namespace twinbus
