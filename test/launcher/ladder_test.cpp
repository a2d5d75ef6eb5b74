// The choice that a ladder of runs makes, and what of it the cache keeps.

#include "launcher/run/ladder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "test/sim/test_models.h"

namespace twinbus {
namespace {

// Order 1 is lucky at 2 ms; order 2 holds a millimetre from there on.
Ladder ladder() {
  Ladder l;
  const auto rung = [](int order, double step, double cost, double apart) {
    Rung r;
    r.order = order;
    r.step = step;
    r.cost = r.work = cost;
    r.apart = apart;
    r.bands = {2.0 * apart, 3.0 * apart, 4.0 * apart, 5.0 * apart};
    r.body = "link foot";
    return r;
  };
  l.rungs = {rung(1, 2e-3, 2, 2e-4),  rung(2, 2e-3, 6, 5e-4),  rung(3, 2e-3, 12, 1e-4),
             rung(1, 1e-3, 4, 3e-3),  rung(2, 1e-3, 12, 9e-5), rung(3, 1e-3, 24, 0.0)};
  l.agreement = 1e-4;
  return l;
}

TEST(Ladder, TheCheapestIsTakenThatHoldsTogetherWithAllFinerOnes) {
  const Ladder l = ladder();
  EXPECT_EQ(l.choose(1e-2), 0);   // order 1 holds 10 mm at both steps
  EXPECT_EQ(l.choose(1e-3), 1);   // order 1 at 2 ms was luck
  EXPECT_EQ(l.choose(2e-4), 2);   // order 2 at 2 ms does not; order 3 costs as much as the finer one of 2 does
}

TEST(Ladder, WhereTwoMethodsKnowTheYardstickNearlyAllOfTheErrorMayBeUsed) {
  Ladder l = ladder();
  l.rungs[3].apart = 4e-4;
  l.rungs[0].apart = 8.5e-4;  // order 1 at 2 ms: above 1 mm / 1.3
  EXPECT_EQ(l.choose(1e-3), 3);  // order 2 and the finest two of order 3 leave 0.97 - 0.19 mm
  l.agreement = 2e-5;
  l.rungs[4].apart = 3e-5;
  EXPECT_EQ(l.choose(1e-3), 0);
  l.rungs[0].apart = 9.4e-4;
  EXPECT_EQ(l.choose(1e-3), 3);
}

TEST(Ladder, WorkDecidesAndNotWhatABusyMachineMeasured) {
  Ladder l = ladder();
  l.rungs[4].cost = 5.0;  // order 2 at 1 ms
  EXPECT_EQ(l.choose(1e-3), 1);
  l.rungs[4].work = 5.0;  // at 2 ms it is divided at an impact
  EXPECT_EQ(l.choose(1e-3), 4);
  l.rungs[4].apart = 2e-3;  // then order 2 at 2 ms holds by luck
  EXPECT_EQ(l.choose(1e-3), 2);
}

TEST(Ladder, PartsChosenByLocalErrorAreTakenWithAFinerRunThatHoldsToo) {
  Ladder l = ladder();
  Rung local = l.rungs[1];
  local.local = 1.0;
  local.work = 3.0;
  local.apart = 7e-4;
  l.rungs.insert(l.rungs.end() - 1, local);
  EXPECT_EQ(l.choose(1e-3), 1);  // alone it may be luck
  local.local = 0.3;
  local.work = 5.0;
  local.apart = 1e-4;
  l.rungs.insert(l.rungs.end() - 1, local);
  EXPECT_EQ(l.choose(1e-3), 5);
  EXPECT_EQ(words_of(l.rungs[5]), "order 2 at 2 ms in parts, local error 1 m/s^2");
  l.rungs[6].apart = 1e-2;
  EXPECT_EQ(l.choose(1e-3), 1);
}

// Runs of a scene whose error is 0.4 mm (parts)^-order, after so many solves a second.
Ladder climbed(double error, const std::function<double(int order, int parts)>& work) {
  const Model model = test::block();
  LadderRequest request;
  request.duration = 0.1;
  request.error = error;
  request.follow = [&](const Scene& scene) {
    int order = 1;
    for (const auto& [key, value] : scene.settings) order = key == "solver.order" ? std::stoi(value) : order;
    const int parts = static_cast<int>(std::lround(model.period() / scene.step));
    Track track;
    track.names = {"link block"};
    const double off = 4e-4 * std::pow(parts, -order);
    track.at.assign(5, {Eigen::Vector3d(0.0, 0.0, off)});
    track.work = request.duration * work(order, parts);
    return track;
  };
  return climb(model, Scene{}, {}, request);
}

TEST(Ladder, AStepBetweenThoseOfTheLadderIsTriedWhereItMayBeLessWork) {
  const auto even = [](int order, int parts) { return order * (order + 1) / 2.0 * parts; };
  const Ladder l = climbed(2e-4, even);
  const Rung& chosen = l.rungs.at(static_cast<std::size_t>(l.choose(2e-4)));
  EXPECT_EQ(chosen.order, 1);
  EXPECT_EQ(std::lround(Model{}.period() / chosen.step), 3);
}

// The next step of the ladder would be more work than order 2 is, one before it is less.
TEST(Ladder, AFinerStepOfALowerOrderIsTriedAsFarAsItMayBeLessWork) {
  const Ladder l = climbed(9e-5, [](int order, int parts) { return (order == 1 ? 1.0 : order == 2 ? 2.2 : 20.0) * parts; });
  const Rung& chosen = l.rungs.at(static_cast<std::size_t>(l.choose(9e-5)));
  EXPECT_EQ(chosen.order, 1);
  EXPECT_EQ(std::lround(Model{}.period() / chosen.step), 6);
}

// Fixed steps have to be fine for the sake of an impact; parts only there.
TEST(Ladder, WhatFallsAloneIsTriedInPartsAndIsNoneOfTheDrivenScenes) {
  const Model model = test::block();
  for (const bool driven : {false, true}) {
    Scene scene;
    scene.loose.emplace_back();
    if (driven) scene.walks.emplace_back();
    LadderRequest request;
    request.duration = 0.1;
    request.error = 1e-4;
    request.follow = [&](const Scene& asked) {
      double order = 1.0, local = 0.0;
      for (const auto& [key, value] : asked.settings) {  // a twin has another mass too
        if (key == "solver.order") order = std::stod(value);
        if (key == "solver.local_error") local = std::stod(value);
      }
      const double parts = model.period() / asked.step;
      Track track;
      track.names = {"loose body ball"};
      const double off = local > 0.0 ? 1e-4 * local : 4e-3 * std::pow(parts, -order);
      track.at.assign(5, {Eigen::Vector3d(0.0, 0.0, off)});
      track.work = request.duration * order * (local > 0.0 ? 3.0 - std::log10(local) : 2.0 * parts);
      return track;
    };
    const Ladder l = climb(model, scene, {}, request);
    const Rung& chosen = l.rungs.at(static_cast<std::size_t>(l.choose(1e-4)));
    EXPECT_EQ(chosen.local, driven ? 0.0 : 0.3);
    EXPECT_EQ(at_rung(scene, chosen).settings.size(), driven ? 1U : 2U);
    EXPECT_EQ(at_rung(at_rung(scene, chosen), chosen).settings, at_rung(scene, chosen).settings);
  }
}

TEST(Ladder, AFinerStepIsTakenWhereACoarserOneIsDividedMore) {
  const auto divided = [](int order, int parts) {
    return order == 2 ? (parts == 1 ? 40.0 : 10.0 * parts) : 50.0 * order * parts;
  };
  const Ladder l = climbed(6e-4, divided);
  const Rung& chosen = l.rungs.at(static_cast<std::size_t>(l.choose(6e-4)));
  EXPECT_EQ(chosen.order, 2);
  EXPECT_EQ(std::lround(Model{}.period() / chosen.step), 2);
}

TEST(Ladder, NothingIsChosenThatTheYardstickDoesNotProve) {
  Ladder l = ladder();
  EXPECT_EQ(l.choose(1e-5), -1);
  l.agreement = std::numeric_limits<double>::infinity();
  EXPECT_EQ(l.choose(1e-2), -1);
  l = ladder();
  l.parted.push_back({"loose body chip", 0.5});
  EXPECT_EQ(l.choose(1e-2), -1);
}

// After impacts the finest two runs of order 3 may agree by luck: then order 2 is far off.
TEST(Ladder, TwoRunsThatAgreeProveNothingWhileOrderTwoIsFarOff) {
  Ladder l = ladder();
  l.rungs[4].apart = 83e-3;
  EXPECT_TRUE(l.proven(3e-2));
  EXPECT_FALSE(l.proven(1e-2));
  std::swap(l.rungs[1], l.rungs[4]);  // in whatever order they were run
  EXPECT_FALSE(l.proven(1e-2));
  std::swap(l.rungs[1], l.rungs[4]);
  EXPECT_EQ(l.choose(1e-2), -1);
  EXPECT_EQ(l.why_none_holds(1e-2),
            "no order and step holds 10 mm: order 2 at 1 ms is off by 83 mm while the finest two runs agree to 0.1 mm, "
            "link foot at 0.00 s");
  EXPECT_EQ(l.why_none_holds(1e-5),
            "no order and step holds 0.01 mm: the finest two runs differ by 0.1 mm, link foot at 0.00 s");
}

// A run that leaves something out is judged alone: it is no finer or coarser one of those that model everything.
TEST(Ladder, ARunThatLeavesSomethingOutIsTakenIfItHoldsAndCostsLess) {
  Ladder l = ladder();
  Rung less = l.rungs[1];
  less.less.held = {"HEAD"};
  less.cost = 3.0;
  less.apart = 6e-4;
  l.rungs.insert(l.rungs.end() - 1, less);
  EXPECT_EQ(l.choose(1e-3), 5);
  EXPECT_EQ(l.choose(7e-4), 1);  // with the margin it does not hold that
  l.rungs[5].cost = 7.0;
  EXPECT_EQ(l.choose(1e-3), 1);
}

TEST(Ladder, OfABudgetTheMostAccurateRunIsTaken) {
  const Ladder l = ladder();
  EXPECT_EQ(l.choose_within(1.0), -1);
  EXPECT_EQ(l.choose_within(6.0), 0);
  EXPECT_EQ(l.choose_within(12.0), 4);
  EXPECT_DOUBLE_EQ(l.estimate(4), 9e-5);
  EXPECT_DOUBLE_EQ(l.estimate(5), 1e-4);
}

TEST(Ladder, TheCacheGivesBackWhatItWasGiven) {
  Ladder l = ladder();
  l.rungs[0].apart = std::numeric_limits<double>::infinity();
  l.rungs[0].whole = false;
  l.rungs[2].bands.rise = std::numeric_limits<double>::infinity();
  l.rungs[1].local = 0.3;
  l.rungs[1].less = {{"HEAD", "L WRIST"}, {"second"}, {"base"}, {"L FOOT", "TORSO"}, {"HEAD"}, true, true};
  l.moved.joints = {0.1, 0.2};
  l.moved.robots = {"left one"};
  l.moved.robot_ways = {0.3};
  l.moved.clear = {-0.1, std::numeric_limits<double>::infinity()};
  l.moved.above = {0.02};
  l.moved.lay = 0.5;
  l.parted = {{"robot left one", 0.25}};
  Ladder back;
  ASSERT_TRUE(read_ladder(ladder_text(l), back));
  EXPECT_EQ(back.rungs, l.rungs);
  EXPECT_EQ(back.parted, l.parted);
  EXPECT_EQ(back.moved, l.moved);
  EXPECT_EQ(back.agreement, l.agreement);
  EXPECT_FALSE(read_ladder("", back));
  EXPECT_FALSE(read_ladder(ladder_text(l).substr(0, 60), back));
  EXPECT_FALSE(read_ladder(ladder_text(l).substr(0, ladder_text(l).size() - 12), back));
}

}  // namespace
}  // namespace twinbus
