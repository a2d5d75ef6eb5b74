#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "test/protocol/explorer.h"

namespace twinbus::protocol {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Protocol, FromStart, ::testing::ValuesIn(all_starts()),
                         [](const auto& which) {
                           std::string name = start_name(which.param);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

// Three halves of a split network, each with a source that was activated: of several rivals each
// must be heard.
TEST(ThreeSources, AllButOneGiveWay) {
  const Outcome outcome = explore(Start::kTwoActive, 3, {.depth = 3, .faults = 1, .happenings = 1});
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.violation, "") << story(outcome);
}

// A rule that can be left out without anybody noticing is no rule, or the explorer is blind to it.
// The table says where the bug shows soonest; the properties that find it are those of every start.
struct Plant {
  Rule rule;
  Start start;
  Bounds bounds;
};

constexpr Bounds within(int depth, int faults, int happenings) {
  return {.depth = depth, .faults = faults, .happenings = happenings};
}

constexpr Plant kPlants[] = {
    {Rule::kCommandRun, Start::kTwoActive, within(1, 0, 1)},
    {Rule::kCommandTerm, Start::kCancel, within(3, 2, 0)},
    {Rule::kCommandOrder, Start::kTrack, within(2, 1, 0)},
    {Rule::kCommandAge, Start::kTrack, within(1, 0, 1)},
    {Rule::kOneController, Start::kTrack, within(3, 1, 1)},
    {Rule::kTimeoutStops, Start::kTwoActive, within(1, 0, 0)},
    {Rule::kStopLatches, Start::kStopped, within(1, 0, 0)},
    {Rule::kHigherKindWins, Start::kTrack, within(3, 0, 2)},
    {Rule::kStopShutsGate, Start::kStopped, within(1, 0, 0)},
    {Rule::kClearNeedsNonce, Start::kStopped, within(1, 0, 1)},
    {Rule::kNonceChanges, Start::kStopped, within(1, 0, 1)},
    {Rule::kListenFirst, Start::kFresh, within(1, 0, 1)},
    {Rule::kActivateAlone, Start::kTrack, within(1, 0, 1)},
    {Rule::kActivateAsked, Start::kCold, within(1, 0, 1)},
    {Rule::kTermAdvances, Start::kTrack, within(1, 0, 0)},
    {Rule::kSwitchAddressed, Start::kTrack, within(1, 0, 1)},
    {Rule::kSwitchChecked, Start::kFarShadow, within(1, 0, 1)},
    {Rule::kGrantNamed, Start::kCancel, within(1, 0, 1)},
    {Rule::kGrantTick, Start::kSwitch, within(1, 0, 0)},
    {Rule::kGrantFresh, Start::kGrantLost, within(1, 0, 1)},
    {Rule::kOldHolderStopsObeying, Start::kCancel, within(1, 0, 0)},
    {Rule::kReleaseOnSuccessor, Start::kSwitch, within(12, 1, 0)},
    {Rule::kCancelSilent, Start::kCancel, within(1, 0, 0)},
    {Rule::kCancelRaisesTerm, Start::kCancel, within(2, 0, 0)},
    {Rule::kStandDown, Start::kSwitch, within(3, 0, 1)},
    {Rule::kStopRevokesGrant, Start::kSwitchBack, within(5, 0, 1)},
    {Rule::kStoppedStaysOut, Start::kGrantLost, within(1, 0, 0)},
    {Rule::kBelieveByRule, Start::kSwitch, within(1, 0, 1)},
    {Rule::kSwitchRate, Start::kGrantLost, within(3, 0, 2)},
    {Rule::kGiveWay, Start::kTwoActive, within(3, 0, 0)},
    {Rule::kPlanWhole, Start::kPlans, within(1, 0, 0)},
    {Rule::kPlanUnmixed, Start::kPlans, within(2, 2, 0)},
    {Rule::kPlanOrder, Start::kPlans, within(2, 1, 0)},
    {Rule::kPlanSource, Start::kPlans, within(1, 0, 1)},
    {Rule::kPlanController, Start::kPlans, within(1, 0, 1)},
    {Rule::kPlanAge, Start::kOldPlan, within(3, 0, 1)},
    {Rule::kPlanAtOnce, Start::kPlans, within(1, 1, 0)},
    {Rule::kPlanKept, Start::kPlans, within(3, 2, 0)},
    {Rule::kPlanOtherWaits, Start::kPlanRuns, within(2, 0, 1)},
    {Rule::kPlanResumeSoon, Start::kPlanLate, within(2, 0, 1)},
    {Rule::kPlanResumeNew, Start::kPlanRuns, within(2, 0, 1)},
    {Rule::kPlanStopStays, Start::kPlanRuns, within(4, 0, 3)},
    {Rule::kPlanOffEnds, Start::kPlanRuns, within(1, 0, 1)},
    {Rule::kPlanEndLatches, Start::kPlanLate, within(8, 0, 0)},
};

TEST(EveryRule, HasItsPlantedBug) {
  RuleSet planted = 0;
  for (const Plant& plant : kPlants) planted |= without(plant.rule);
  EXPECT_EQ(planted, without(Rule::kCount) - 1);
}

class PlantedBug : public ::testing::TestWithParam<Plant> {};

TEST_P(PlantedBug, IsFound) {
  const Plant& plant = GetParam();
  const Outcome outcome = explore(plant.start, 2, plant.bounds, without(plant.rule));
  ASSERT_NE(outcome.violation, "") << "rule " << static_cast<int>(plant.rule)
                                   << " of bridge/handover/rules.h was switched off and nothing was found";
  std::printf("rule %d: %s (start %s, %lld states)\n", static_cast<int>(plant.rule),
              outcome.violation.c_str(), start_name(plant.start),
              static_cast<long long>(outcome.states));
}

// The same bounds find nothing while the rule is there.
TEST_P(PlantedBug, IsNotSeenWithTheRuleInForce) {
  const Outcome outcome = explore(GetParam().start, 2, GetParam().bounds);
  EXPECT_EQ(outcome.violation, "") << story(outcome);
}

INSTANTIATE_TEST_SUITE_P(EveryRule, PlantedBug, ::testing::ValuesIn(kPlants),
                         [](const auto& which) {
                           return std::to_string(static_cast<int>(which.param.rule));
                         });

}  // namespace
}  // namespace twinbus::protocol
