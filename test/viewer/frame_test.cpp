#include "viewer_log/view/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lcmtypes/msg/guard_defaults.h"
#include "robot/description/load.h"
#include "test/carried_arms.h"
#include "test/control/four_legged.h"
#include "test/viewer/standing.h"
#include "viewer_log/view/signals.h"

namespace twinbus {
namespace {

using Json = nlohmann::json;
constexpr std::int64_t kNow = 1'000'000'000;

using test::model;
using test::standing;

// Four feet without soles: named by their links, each with what it carries, and nobody speaks of a ZMP before there is one.
TEST(LiveFrame, ShowsEveryFootOfAQuadruped) {
  const Model& four = test::four_legged(1.0);
  StackView view(four);
  RobotState state = standing();
  state.model_hash = four.hash;
  state.joint_count = static_cast<std::int16_t>(four.bus_count());
  state.wrench_kind = {};
  for (std::size_t foot = 0; foot < 4; ++foot) {
    state.wrench_kind[foot] = WrenchKind::kEstimated;
    state.wrench[foot] = {};
    state.wrench[foot][2] = 30.0F + static_cast<float>(foot);
  }
  for (int i = 0; i < 100; ++i) {
    ++state.tick;
    state.time_ns += 2'000'000;
    view.on_state(state, kNow);
  }
  const Json frame = Json::parse(live_frame(view, kNow));
  ASSERT_EQ(frame["feet"].size(), 4u);
  EXPECT_EQ(frame["feet"][0], "fl_shank");
  EXPECT_EQ(frame["soles"].size(), 4u);
  EXPECT_EQ(frame["soles"][3].size(), 1u);
  EXPECT_EQ(frame["loaded"], Json::parse("[true,true,true,true]"));
  EXPECT_EQ(frame["polygon"].size(), 4u);
  EXPECT_GT(frame["margin_mm"].get<double>(), 0.0);
  EXPECT_GT(frame["foot_force"][3].get<double>(), frame["foot_force"][0].get<double>());
  const Json signals = Json::parse(signals_frame(view, kNow));
  EXPECT_DOUBLE_EQ(signals["STATE"]["wrench"]["fr_shank"][2], 31.0);
}

TEST(LiveFrame, NamesTheSourceAndCarriesThePosture) {
  StackView view(model());
  RobotState state = standing();
  state.q[2] = -0.5;
  view.on_state(state, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_EQ(frame["type"], "live");
  EXPECT_EQ(frame["source"], "robot");
  EXPECT_EQ(frame["term"], 3);
  EXPECT_EQ(frame["q"].size(), static_cast<std::size_t>(model().bus_count()));
  EXPECT_DOUBLE_EQ(frame["q"][2], -0.5);
  EXPECT_EQ(frame["base"].size(), 7u);
  EXPECT_LT(live_frame(view, kNow).size(), 8000u);
}

// Standing on both feet the support polygon encloses both soles, and is convex and
// counter-clockwise.
TEST(LiveFrame, SupportPolygonIsTheHullOfTheLoadedSoles) {
  StackView view(model());
  view.on_state(standing(), kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  ASSERT_EQ(frame["soles"].size(), 2u);
  const Json& polygon = frame["polygon"];
  ASSERT_GE(polygon.size(), 4u);
  const auto cross = [](const Json& o, const Json& a, const Json& b) {
    const auto n = [](const Json& p, int i) {
      return p[static_cast<std::size_t>(i)].get<double>();
    };
    return (n(a, 0) - n(o, 0)) * (n(b, 1) - n(o, 1)) - (n(a, 1) - n(o, 1)) * (n(b, 0) - n(o, 0));
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Json& a = polygon[i];
    const Json& b = polygon[(i + 1) % polygon.size()];
    for (const Json& sole : frame["soles"]) {
      for (const Json& corner : sole) EXPECT_GE(cross(a, b, corner), -1e-4);
    }
  }
}

// Alarm colours belong to what the guard acts on, not to links that are always near.
// As the guard does: of links that are near by design less is kept.
TEST(LiveFrame, APairThatIsNearByDesignIsNoAlarm) {
  Model close = model();
  close.near_pairs = {{1, 7, 0.003}};
  StackView view(close);
  view.on_state(standing(), kNow);
  GuardReport report;
  report.run_id = 11;
  report.pairs_near = 2;
  report.link_a = {1, 2};
  report.link_b = {7, 7};
  report.distance = {0.004F, 0.004F};
  view.on_guard(report, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_EQ(frame["pairs"][0]["level"], "");
  EXPECT_EQ(frame["pairs"][1]["level"], "touch");
}

TEST(LiveFrame, APairIsAnAlarmWhenTheGuardActsOrLessIsLeftThanItKeeps) {
  StackView view(model());
  view.on_state(standing(), kNow);
  GuardReport report;
  report.run_id = 11;
  report.pairs_near = 4;
  constexpr auto kKeeps = static_cast<float>(GuardDefaults::kInController);
  report.distance = {0.49F * kKeeps, 0.99F * kKeeps, 1.01F * kKeeps, 4.5F * kKeeps};
  report.verdict = GuardVerdict::kNear;
  const auto levels = [&] {
    view.on_guard(report, kNow);
    std::vector<std::string> found;
    const Json frame = Json::parse(live_frame(view, kNow));
    for (const Json& pair : frame["pairs"]) found.push_back(pair["level"]);
    return found;
  };
  using Levels = std::vector<std::string>;
  EXPECT_EQ(levels(), (Levels{"touch", "close", "", ""}));
  report.hold_mask = 4;
  report.tick = 1;
  EXPECT_EQ(levels(), (Levels{"touch", "close", "close", ""}));
  report.hold_mask = 0;
  report.verdict = GuardVerdict::kWillCollide;
  report.tick = 2;
  EXPECT_EQ(levels(), (Levels{"touch", "close", "close", ""}));
}

TEST(LiveFrame, WithoutASimulatorFootSensorsAreDrawn) {
  StackView view(model());
  view.on_state(standing(), kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_EQ(frame["forces_from"], "foot sensors");
  EXPECT_EQ(frame["forces"].size(), 2u);
}

TEST(LiveFrame, WithASimulatorItsContactsAreDrawn) {
  StackView view(model());
  view.on_state(standing(), kNow);
  SimTruth truth;
  truth.run_id = 11;
  truth.contact_count = 99;  // more than there are rows
  for (auto& force : truth.contact_force) force = {0, 0, 160};
  truth.push_force = {45, 0, 0};
  view.on_truth(truth, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_EQ(frame["forces_from"], "simulated contacts");
  EXPECT_EQ(frame["forces"].size(), 8u);
  EXPECT_TRUE(frame.contains("push"));
}

// Where the robot believes it is drifts from where the simulator has it; what is under its feet stays under its feet.
TEST(LiveFrame, SolesAndPolygonAreBelowTheRobotThatIsDrawn) {
  StackView view(model());
  view.on_state(standing(), kNow);
  SimTruth truth;
  truth.run_id = 11;
  truth.base_attitude = {1, 0, 0, 0};
  view.on_truth(truth, kNow);
  const Json before = Json::parse(live_frame(view, kNow));
  truth.base_position = {0.25, -0.5, 0};
  view.on_truth(truth, kNow);
  const Json after = Json::parse(live_frame(view, kNow));
  const auto moved = [](const Json& a, const Json& b, int i) {
    const auto k = static_cast<std::size_t>(i);
    return b[k].get<double>() - a[k].get<double>();
  };
  EXPECT_NEAR(moved(before["base"], after["base"], 0), 0.25, 1e-3);
  ASSERT_EQ(before["polygon"].size(), after["polygon"].size());
  for (const char* key : {"soles", "polygon"}) {
    const Json& a = key == std::string("soles") ? before[key][0] : before[key];
    const Json& b = key == std::string("soles") ? after[key][0] : after[key];
    for (std::size_t corner = 0; corner < a.size(); ++corner) {
      EXPECT_NEAR(moved(a[corner], b[corner], 0), 0.25, 1e-3) << key;
      EXPECT_NEAR(moved(a[corner], b[corner], 1), -0.5, 1e-3) << key;
    }
  }
}

TEST(LiveFrame, NothingHeardYetIsStillAFrame) {
  StackView view(model());
  const Json live = Json::parse(live_frame(view, kNow));
  EXPECT_EQ(live["source"], "none");
  EXPECT_TRUE(live["age_ms"].is_null());
  EXPECT_EQ(Json::parse(status_frame(view, kNow))["health"]["level"], "waiting");
}

TEST(Frames, NumbersThatAreNotFiniteBecomeNull) {
  StackView view(model());
  RobotState state = standing();
  state.q[0] = std::numeric_limits<double>::quiet_NaN();
  state.q[1] = std::numeric_limits<double>::infinity();
  view.on_state(state, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_TRUE(frame["q"][0].is_null());
  EXPECT_TRUE(frame["q"][1].is_null());
}

TEST(Frames, TextOfAnyBytesIsValidJson) {
  StackView view(model());
  Event event;
  event.sender_id = 1;
  event.sequence = 1;
  event.text = {'<', 's', '>', '"', '\\', '\n', '\xff', '\xc3', '\x01'};
  view.on_event(event);
  const Json frame = Json::parse(status_frame(view, kNow));
  ASSERT_EQ(frame["events"].size(), 1u);
  EXPECT_EQ(frame["events"][0]["text"].get<std::string>().substr(0, 5), "<s>\"\\");
}

TEST(Frames, GuardPairsWithStrangeLinksAreNamedSo) {
  StackView view(model());
  view.on_state(standing(), kNow);
  GuardReport report;
  report.pairs_near = 2;
  report.link_a = {0, 30000};
  report.link_b = {-1, 1};
  view.on_guard(report, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  ASSERT_EQ(frame["pairs"].size(), 2u);
  EXPECT_EQ(frame["pairs"][0]["b"], "?");
  EXPECT_EQ(frame["pairs"][1]["a"], "an obstacle");  // an index beyond those heard
}

TEST(HelloFrame, ListsJointsInBusOrder) {
  const Json frame = Json::parse(hello_frame(model(), true));
  EXPECT_EQ(frame["joints"].size(), static_cast<std::size_t>(model().bus_count()));
  EXPECT_EQ(frame["trusted"], true);
  EXPECT_NEAR(frame["mass"].get<double>(), 130.8, 1.0);
}

TEST(HelloFrame, NamesEveryArm) {
  EXPECT_EQ(Json::parse(hello_frame(model(), true))["hands"][1]["name"], "right");
  const Model three = test::three_arms();
  const Json hands = Json::parse(hello_frame(three, true))["hands"];
  ASSERT_EQ(hands.size(), 3u);
  EXPECT_EQ(hands[2]["name"], "west");
  EXPECT_EQ(hands[2]["link"], "west_lower");
  StackView view(three);
  RobotState state = standing();
  state.model_hash = three.hash;
  state.joint_count = static_cast<std::int16_t>(three.bus_count());
  view.on_state(state, kNow);
  const Json places = Json::parse(live_frame(view, kNow))["hands"];
  ASSERT_EQ(places.size(), 3u);
  EXPECT_GT(places[0][0].get<double>(), places[2][0].get<double>() + 0.3) << "east and west";
}

TEST(LiveFrame, GhostsAreOfThisRunAndOfAnother) {
  StackView view(model());
  view.on_state(standing(), kNow);
  JointCommand command;
  command.joint_count = standing().joint_count;
  command.run_id = 99;
  view.on_command(command, kNow);
  EXPECT_FALSE(Json::parse(live_frame(view, kNow)).contains("command"));
  command.run_id = 11;
  command.q[3] = 0.25;
  view.on_command(command, kNow);
  RobotState standby = standing();
  standby.run_id = 12;
  standby.q[0] = 0.5;
  view.on_standby_state(standby, kNow);
  const Json frame = Json::parse(live_frame(view, kNow));
  EXPECT_DOUBLE_EQ(frame["command"][3], 0.25);
  EXPECT_DOUBLE_EQ(frame["standby"]["q"][0], 0.5);
  ASSERT_EQ(frame["hands"].size(), 2u);
  EXPECT_GT(frame["hands"][0][1], frame["hands"][1][1]);  // the left one is to the left
  EXPECT_LT(frame.dump().size(), 8000u);

  const Json signals = Json::parse(signals_frame(view, kNow));
  EXPECT_DOUBLE_EQ(signals["TRACKING"]["q"][3], 0.25);
  EXPECT_DOUBLE_EQ(signals["DIFFERENCE"]["q"][0], 0.5);
  EXPECT_DOUBLE_EQ(signals["STATE"]["wrench"]["left_foot"][2], 640);
  EXPECT_FALSE(signals["STATE"]["wrench"].contains("left_hand"));
}

}  // namespace
}  // namespace twinbus
