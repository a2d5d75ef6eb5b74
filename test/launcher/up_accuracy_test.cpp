// What `up` makes of a ladder: no more than real time leaves, and it says what is not given.

#include "launcher/up/up_accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "launcher/run/fit_scene.h"
#include "robot/description/load.h"

namespace twinbus {
namespace {

constexpr double kUpPeriod = 2e-3;  // [s]

// Order 1 takes 100 ms a second and is off by 3 mm, order 2 takes 400 and is off by 0.5, order 3 takes 900 and is off by 0.05.
AccuracyChoice chosen(int rung) {
  AccuracyChoice choice;
  const auto add = [&](int order, double cost, double apart) {
    Rung r;
    r.order = order;
    r.step = kUpPeriod;
    r.cost = cost;
    r.apart = apart;
    choice.ladder.rungs.push_back(r);
  };
  add(1, 100.0, 3e-3);
  add(2, 400.0, 5e-4);
  add(3, 900.0, 0.0);
  choice.ladder.agreement = 5e-5;
  choice.rung = rung;
  return choice;
}

// What real time leaves of a choice.
AccuracyChoice kept(int rung, const AccuracyRequest& asked, double rate = 1.0, bool lockstep = false) {
  AccuracyChoice choice = chosen(rung);
  keep_to_real_time(choice, asked, kUpPeriod, time_for_physics(kUpPeriod, rate, lockstep));
  return choice;
}

TEST(UpAccuracy, WhatFitsStaysAndSaysNothingAndLockStepTakesItsTime) {
  const AccuracyChoice fits = kept(1, {.error = 1e-3}), waits = kept(2, {.error = 1e-4}, 1.0, true);
  EXPECT_EQ(fits.rung, 1);
  EXPECT_EQ(fits.reason, "");
  EXPECT_EQ(waits.rung, 2);
  EXPECT_EQ(waits.reason, "");
}

TEST(UpAccuracy, WhatDoesNotFitGivesWayToTheBestThatDoes) {
  const AccuracyChoice choice = kept(2, {.error = 1e-4});
  EXPECT_EQ(choice.rung, 1);
  EXPECT_EQ(choice.reason,
            "0.1 mm does not fit real time: order 3 at 2 ms takes 1.8 ms in the mean, and real time leaves the physics 1 ms of each "
            "control period");
  EXPECT_EQ(kept(2, {.error = 1e-4}, 4.0).rung, 0);
  const AccuracyChoice none = kept(2, {.error = 1e-4}, 10.0);
  EXPECT_EQ(none.rung, -1);
  EXPECT_NE(none.reason.find("no order and step fits"), std::string::npos);
}

TEST(UpAccuracy, ABudgetBeyondRealTimeIsTold) {
  const AccuracyChoice choice = kept(1, {.budget = 5e-3});
  EXPECT_EQ(choice.rung, 1);
  EXPECT_NE(choice.reason.find("a budget of 5 ms does not fit real time"), std::string::npos);
}

TEST(UpAccuracy, BudgetsHaveUnits) {
  double seconds = 0.0;
  for (const auto& [text, wanted] : {std::pair("0.5", 5e-4), std::pair("0.5ms", 5e-4), std::pair("500 us", 5e-4), std::pair("1s", 1.0)}) {
    EXPECT_EQ(read_budget(text, seconds), "") << text;
    EXPECT_NEAR(seconds, wanted, 1e-12) << text;
  }
  for (const char* text : {"", "ms", "-1", "0", "nan", "inf", "0.5m", "60s"}) EXPECT_NE(read_budget(text, seconds), "") << text;
}

class UpAsked : public ::testing::Test {
 protected:
  UpAccuracy up(const std::vector<std::string>& words, const std::string& stack = "sim") const {
    Scene scene = load_scene("stand");
    fit_scene(scene, model_);
    const Syntax syntax("up", 0, 1, "\nTest.\n  --accuracy X  a\n  --budget X  a\n  --set X  a");
    RunRequest request;
    request.engine = "articulated";
    request.seed = 1;
    request.lockstep = true;
    request.duration = 0.2;
    return {Arguments(syntax, words), model_, scene, load_stack(stack), request};
  }
  Model model_ = load_robot("hrp1s");
};

TEST_F(UpAsked, NothingAskedNothingChosen) {
  const UpAccuracy none = up({});
  EXPECT_TRUE(none.words().empty());
  EXPECT_TRUE(none.lines().empty());
  EXPECT_EQ(none.step_or(1e-3), 1e-3);
  EXPECT_EQ(none.in_report("{}\n"), "{}\n");
}

// It is the rung that `run` takes, in words that the simulator knows, and a report has it.
TEST_F(UpAsked, TheSimulatorIsToldTheRungOfRun) {
  UpAccuracy some = up({"--accuracy", "0.01mm"});
  const std::vector<std::string> words = some.words();
  ASSERT_EQ(some.failure(), "");
  const auto json = nlohmann::json::parse(some.in_report("{}"))["accuracy"];
  const auto order = std::find(words.begin(), words.end(), "solver.order=" + std::to_string(json["order"].get<int>()));
  EXPECT_NE(order, words.end());
  const auto step = std::find(words.begin(), words.end(), "--step");
  ASSERT_NE(step, words.end());
  EXPECT_NEAR(std::stod(*(step + 1)), json["step_s"].get<double>(), 1e-12);
  EXPECT_LE(json["error_estimate_m"].get<double>(), 1e-5);
  EXPECT_NE(std::find(words.begin(), words.end(), "--band-error"), words.end());
  EXPECT_FALSE(some.lines().empty());
  EXPECT_TRUE(some.drop());
  EXPECT_TRUE(some.words().empty());
  EXPECT_FALSE(some.drop());
}

TEST_F(UpAsked, AStackWithoutOneSimulatorRefusesIt) {
  EXPECT_THROW(up({"--accuracy", "1mm"}, "bridge"), UsageError);
  EXPECT_THROW(up({"--budget", "0.5ms"}, "twosims"), UsageError);
  EXPECT_TRUE(up({}, "bridge").words().empty());
}

TEST_F(UpAsked, NonsenseIsRefused) {
  EXPECT_THROW(up({"--accuracy", "1"}), UsageError);
  EXPECT_THROW(up({"--budget", "fast"}), UsageError);
}

}  // namespace
}  // namespace twinbus
