#include "launcher/bus/stack_monitor.h"
#include "lcmtypes/msg/labels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

SourceStatus status_of(std::int64_t run, Role role, int term) {
  return {.run_id = run, .term = term, .role = role};
}

TEST(StackMonitor, TheActiveSourceIsTheHolderOfTheHighestTerm) {
  StackMonitor seen;
  EXPECT_EQ(seen.active(0), nullptr);
  seen.on_source_status(status_of(1, Role::kStandbyTrack, 9), 1);
  EXPECT_EQ(seen.active(1), nullptr);
  seen.on_source_status(status_of(2, Role::kReleasing, 3), 1);
  seen.on_source_status(status_of(3, Role::kActive, 4), 1);
  ASSERT_NE(seen.active(1), nullptr);
  EXPECT_EQ(seen.active(1)->status.run_id, 3);
  EXPECT_EQ(seen.active(5'000'000'000), nullptr);  // silent for too long
}

TEST(StackMonitor, AFloodOfInventedSendersDoesNotGrowIt) {
  StackMonitor seen;
  for (int i = 1; i < 10000; ++i) seen.on_source_status(status_of(i, Role::kParked, 0), i);
  EXPECT_LE(seen.sources(10000, 100.0).size(), 64U);
}

TEST(StackMonitor, EventsCannotSendControlCharactersToATerminal) {
  StackMonitor seen;
  Event event;
  event.text[0] = 'a';
  event.text[1] = '\x1b';
  event.text[2] = 'b';
  seen.on_event(event);
  const std::vector<std::string> lines = seen.take_events();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "process: a?b");
  EXPECT_TRUE(seen.take_events().empty());
}

TEST(StackMonitor, FiguresAreTheWorstOfTheRun) {
  StackMonitor seen;
  SimTruth truth;
  truth.zmp_margin = 0.05F;
  for (int i = 0; i < 100; ++i) {
    truth.tick = i;
    truth.sim_time = 0.002 * i;
    truth.foot_slip = {0.01F, 0.0F};
    if (i == 50) {
      truth.zmp_margin = 0.02F;
      truth.base_attitude = {std::cos(0.05), std::sin(0.05), 0.0, 0.0};  // 0.1 rad about x
    } else if (i == 51) {
      truth.base_attitude = {1, 0, 0, 0};
    }
    seen.on_truth(truth, i);
  }
  EXPECT_NEAR(seen.figures().max_tilt, 0.1, 1e-9);
  EXPECT_NEAR(seen.figures().zmp_margin_min, 0.02, 1e-6);
  EXPECT_NEAR(seen.figures().slip_max, 0.01 * 0.002 * 99, 1e-6);
  EXPECT_FALSE(seen.figures().fell);
}

// TRUTH counts since its world began; the figures since the measured part of the run did, over several worlds.
TEST(StackMonitor, DoubtedStepsAreCountedOnceAndOverSeveralWorlds) {
  StackMonitor seen;
  SimTruth truth;
  const auto tell = [&](std::int64_t run, double time, int deep, int coarse) {
    truth.run_id = run;
    truth.sim_time = time;
    truth.doubted[3] = deep;
    truth.doubted[5] = coarse;
    truth.doubted_steps = deep + coarse;
    truth.last_doubt = coarse > 0 ? StepDoubt::kTooCoarse : StepDoubt::kFirstSeenDeep;
    truth.doubted_since = 0.004;
    seen.on_truth(truth, 0);
  };
  tell(7, 0.002, 0, 0);
  EXPECT_EQ(seen.figures().doubted_steps, 0);
  tell(7, 0.010, 3, 0);
  tell(7, 0.010, 3, 0);
  EXPECT_EQ(seen.figures().doubted_steps, 3);
  EXPECT_EQ(seen.figures().doubted_since, 0.004);
  seen.restart_counts();
  tell(7, 0.020, 4, 2);
  EXPECT_EQ(seen.figures().doubted_steps, 3);
  EXPECT_EQ(seen.figures().doubted[3], 1);
  EXPECT_EQ(seen.figures().doubted[5], 2);
  EXPECT_EQ(seen.figures().doubted_since, 0.020);
  tell(8, 0.004, 5, 0);
  EXPECT_EQ(seen.figures().doubted_steps, 8);
  tell(8, 0.002, 1, 0);  // begun anew
  EXPECT_EQ(seen.figures().doubted_steps, 9);
  tell(7, 0.030, 4, 2);  // and back to the first
  EXPECT_EQ(seen.figures().doubted_steps, 9);
  tell(7, 0.032, 5, 2);
  EXPECT_EQ(seen.figures().doubted_steps, 10);
  RobotState state;  // of 7, which is the active one: 8 stands by
  state.run_id = 7;
  state.tick = 1;
  seen.on_state(state, 1);
  tell(8, 0.010, 40, 0);
  EXPECT_EQ(seen.figures().doubted_steps, 10);
  state.run_id = 8;
  state.tick = 2;
  seen.on_state(state, 2);
  tell(8, 0.012, 41, 0);
  EXPECT_EQ(seen.figures().doubted_steps, 11);
}

TEST(StackMonitor, WordsForNumbersOutsideTheListAreUnknown) {
  EXPECT_STREQ(label(static_cast<Role>(99)), "unknown");
  EXPECT_STREQ(source_name(static_cast<SourceKind>(-1)), "unknown");
  EXPECT_STREQ(label(Role::kStandbyTrack), "track");
}

}  // namespace
}  // namespace twinbus
