#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "test/protocol/explorer.h"

namespace twinbus::protocol {
namespace {

constexpr Start kStarts[] = {Start::kCold,       Start::kTrack,   Start::kSwitch,
                             Start::kSwitchBack, Start::kShadow,  Start::kShadowSwitch,
                             Start::kFarShadow,  Start::kStopped, Start::kTwoActive};

std::string story(const Outcome& outcome) {
  std::string text = outcome.violation + "\n";
  for (const std::string& line : outcome.trace) text += "  " + line + "\n";
  return text;
}

class FromStart : public ::testing::TestWithParam<Start> {};

TEST_P(FromStart, EveryPropertyHoldsWithTwoFaultsInTwelvePeriods) {
  const Outcome outcome = explore(GetParam(), 2, {.depth = 12, .faults = 2, .happenings = 0});
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.violation, "") << story(outcome);
  RecordProperty("states", static_cast<int>(outcome.states));
}

TEST_P(FromStart, EveryPropertyHoldsWhateverHappensOnceBesideOneFault) {
  const Outcome outcome = explore(GetParam(), 2, {.depth = 12, .faults = 1, .happenings = 1});
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.violation, "") << story(outcome);
  RecordProperty("states", static_cast<int>(outcome.states));
}

INSTANTIATE_TEST_SUITE_P(Protocol, FromStart, ::testing::ValuesIn(kStarts), [](const auto& which) {
  std::string name = start_name(which.param);
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

// A rule that can be left out without anybody noticing is no rule, or the explorer is blind to it.
class PlantedBug : public ::testing::TestWithParam<int> {};

TEST_P(PlantedBug, IsFound) {
  const RuleSet off = without(static_cast<Rule>(GetParam()));
  const Bounds tries[] = {{.depth = 12, .faults = 1, .happenings = 0},
                          {.depth = 12, .faults = 0, .happenings = 1},
                          {.depth = 12, .faults = 2, .happenings = 0, .seconds = 4.0},
                          {.depth = 12, .faults = 0, .happenings = 2, .seconds = 4.0},
                          {.depth = 12, .faults = 1, .happenings = 1, .seconds = 4.0}};
  for (const Bounds& bounds : tries) {
    for (const Start start : kStarts) {
      const Outcome outcome = explore(start, 2, bounds, off);
      if (outcome.violation.empty()) continue;
      RecordProperty("violation", outcome.violation);
      std::printf("rule %d: %s (start %s, %lld states)\n", GetParam(), outcome.violation.c_str(),
                  start_name(start), static_cast<long long>(outcome.states));
      return;
    }
  }
  FAIL() << "rule " << GetParam() << " of bridge/rules.h was switched off and nothing was found";
}

INSTANTIATE_TEST_SUITE_P(EveryRule, PlantedBug,
                         ::testing::Range(0, static_cast<int>(Rule::kCount)));

}  // namespace
}  // namespace twinbus::protocol
