#include "viewer_log/view/stack_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "lcmtypes/msg/messages.h"
#include "robot/description/load.h"
#include "test/viewer/standing.h"
#include "viewer_log/view/health.h"

namespace twinbus {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kStackStart = 1000 * kMs;  // the steady clock does not begin at 0

using test::model;

// A simulator's first tick.
RobotState standing_still(std::int64_t run = 11) {
  RobotState state = test::standing(run);
  state.tick = 1;
  state.term = 0;
  state.source = SourceKind::kSimulator;
  return state;
}

Event event(std::int64_t sender, std::int32_t sequence, const char* text) {
  Event e;
  e.sender_id = sender;
  e.sequence = sequence;
  std::strncpy(e.text.data(), text, e.text.size() - 1);
  return e;
}

TEST(StackView, TheSameEventSaidAgainIsShownOnce) {
  StackView view(model());
  for (int i = 0; i < 3; ++i) view.on_event(event(1, 1, "a"));
  view.on_event(event(2, 1, "b"));
  view.on_event(event(1, 2, "c"));
  ASSERT_EQ(view.events().size(), 3u);
  EXPECT_EQ(view.events()[1].text, "b");
}

TEST(StackView, AFloodOfSendersIsBounded) {
  StackView view(model());
  for (int i = 1; i <= 5000; ++i) {
    view.on_event(event(i, 1, "x"));
    Heartbeat beat;
    beat.process_id = i;
    view.on_heartbeat(beat, kStackStart);
    SourceStatus status;
    status.run_id = i;
    view.on_source_status(status, kStackStart);
  }
  EXPECT_LE(view.events().size(), 100u);
  EXPECT_LE(view.processes().size(), 100u);
  EXPECT_LE(view.sources().size(), 100u);
  view.forget_silent(kStackStart + 20'000 * kMs);
  EXPECT_TRUE(view.processes().empty());
  EXPECT_TRUE(view.sources().empty());
}

TEST(StackView, ATextWithoutItsEndIsCutNotOverrun) {
  StackView view(model());
  Event e = event(1, 1, "");
  e.text.fill('a');
  view.on_event(e);
  EXPECT_EQ(view.events().back().text.size(), e.text.size());
}

TEST(StackView, BadObstaclePiecesAreIgnored) {
  StackView view(model());
  ObstaclesPiece piece;
  for (auto [at, of, count] :
       {std::array{0, 0, 0}, std::array{1, 1, 0}, std::array{-1, 1, 0}, std::array{0, 30000, 1},
        std::array{0, 1, 13}, std::array{0, 1, -1}}) {
    piece.piece = static_cast<std::int16_t>(at);
    piece.pieces = static_cast<std::int16_t>(of);
    piece.count = static_cast<std::int16_t>(count);
    view.on_obstacles(piece);
    EXPECT_TRUE(view.things().empty());
  }
}

TEST(StackView, RepeatedObstaclesAreNoChange) {
  StackView view(model());
  ObstaclesPiece piece;
  piece.pieces = 1;
  piece.count = 1;
  piece.shape[0] = ObstacleShape::kBox;
  view.on_obstacles(piece);
  const std::int64_t version = view.scene_version();
  view.on_obstacles(piece);
  EXPECT_EQ(view.scene_version(), version);
  piece.scene_id = 1;
  view.on_obstacles(piece);
  EXPECT_GT(view.scene_version(), version);
}

// The simulator's world may lie anywhere: the robot is drawn where the estimate has it, a fall is
// drawn as one.
TEST(StackView, TruthIsAnchoredWhereTheEstimateIs) {
  StackView view(model());
  view.on_state(standing_still(), kStackStart);
  const Eigen::Isometry3d estimate = view.base(kStackStart);
  SimTruth truth;
  truth.run_id = 11;
  truth.base_position = {5.0, -3.0, estimate.translation().z()};
  truth.base_attitude = {std::cos(0.5), 0, 0, std::sin(0.5)};
  view.on_truth(truth, kStackStart);
  EXPECT_TRUE(view.truth_applies(kStackStart));
  EXPECT_LT((view.base(kStackStart).translation() - estimate.translation()).norm(), 1e-9);

  truth.base_position[2] = 0.2;  // it falls
  view.on_truth(truth, kStackStart + kMs);
  EXPECT_NEAR(view.base(kStackStart + kMs).translation().z(), 0.2, 1e-9);
}

TEST(StackView, TruthOfAnotherRunIsNotUsed) {
  StackView view(model());
  view.on_state(standing_still(11), kStackStart);
  SimTruth truth;
  truth.run_id = 99;
  view.on_truth(truth, kStackStart);
  EXPECT_FALSE(view.truth_applies(kStackStart));
}

TEST(StackView, WrongJointCountIsIgnored) {
  StackView view(model());
  RobotState state = standing_still();
  state.joint_count = 3;
  view.on_state(state, kStackStart);
  EXPECT_EQ(view.state().at_ns, 0);
}

TEST(Health, SaysTheWorstThingFirst) {
  StackView view(model());
  std::int64_t now = kStackStart;
  EXPECT_EQ(assess(view, now).level, HealthLevel::kWaiting);

  SourceStatus source;
  source.run_id = 11;
  source.source = SourceKind::kSimulator;
  source.pace = 1;
  view.on_source_status(source, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kBad);  // heard, but none active
  EXPECT_NE(assess(view, now).text.find("Activate"), std::string::npos);

  view.on_state(standing_still(), now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kWaiting);  // the start of a log: who has not spoken may not be silent
  for (int i = 1; i <= 5; ++i) view.on_state(standing_still(), now + i * 100 * kMs);
  EXPECT_EQ(assess(view, now + 500 * kMs).level, HealthLevel::kBad);
  EXPECT_NE(assess(view, now + 500 * kMs).text.find("controller"), std::string::npos);
  now += 500 * kMs;
  ControllerStatus controller;
  controller.mode = Mode::kBalance;
  controller.zmp_margin = 0.05f;
  view.on_controller_status(controller, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kGood);

  controller.zmp_margin = 0.004f;
  view.on_controller_status(controller, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kWarning);

  RobotState stopped = standing_still();
  stopped.role = Role::kStopped;
  stopped.stop_kind = StopKind::kHold;
  view.on_state(stopped, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kStopped);

  SimTruth truth;
  truth.run_id = 11;
  truth.fell = true;
  view.on_truth(truth, now);
  EXPECT_NE(assess(view, now).text.find("fallen"), std::string::npos);

  EXPECT_EQ(assess(view, now + 400 * kMs).level, HealthLevel::kBad);  // the state is silent
}

// Nobody else says so of a robot on hardware.
TEST(Health, ARobotThatLiesHasFallenWhateverItsMode) {
  StackView view(model());
  const std::int64_t now = kStackStart + 500 * kMs;
  RobotState state = test::standing();
  state.sensor_flags |= kImuValid;
  state.attitude = {0.70710678F, 0.0F, -0.70710678F, 0.0F};
  for (int i = 0; i <= 5; ++i) view.on_state(state, kStackStart + i * 100 * kMs);
  ControllerStatus controller;
  controller.mode = Mode::kHold;
  view.on_controller_status(controller, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kBad);
  EXPECT_NE(assess(view, now).text.find("fallen"), std::string::npos);
}

TEST(Health, SaysThatTheSimulatorDoubtsItsSteps) {
  StackView view(model());
  const std::int64_t now = kStackStart + 500 * kMs;
  for (int i = 0; i <= 5; ++i) view.on_state(standing_still(), kStackStart + i * 100 * kMs);
  ControllerStatus controller;
  controller.mode = Mode::kBalance;
  controller.zmp_margin = 0.05f;
  view.on_controller_status(controller, now);
  SimTruth truth;
  truth.run_id = standing_still().run_id;
  view.on_truth(truth, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kGood);
  truth.doubted_steps = 12;
  truth.doubted_since = 3.25;
  truth.last_doubt = StepDoubt::kUnconverged;
  view.on_truth(truth, now);
  EXPECT_EQ(assess(view, now).level, HealthLevel::kWarning);
  EXPECT_EQ(assess(view, now).text, "The simulator doubts 12 of its steps since 3.25 s, the last for contacts that did not settle.");
  controller.zmp_margin = 0.004f;  // what is to be done at once comes first
  view.on_controller_status(controller, now);
  EXPECT_NE(assess(view, now).text.find("Balance"), std::string::npos);
}

// A robot whose simulator nobody can ask: its source has seen the fall.
TEST(Health, AFallenRobotOfHardwareHasItsWayOut) {
  StackView view(model());
  RobotState state = standing_still();
  state.role = Role::kStopped;
  state.stop_kind = StopKind::kOff;
  view.on_state(state, kStackStart);
  SourceStatus source;
  source.run_id = 11;
  source.source = SourceKind::kBridge;
  source.stop_kind = StopKind::kOff;
  source.stop_reason = StopReason::kFallen;
  view.on_source_status(source, kStackStart);
  const Health health = assess(view, kStackStart);
  EXPECT_EQ(health.level, HealthLevel::kBad);
  EXPECT_NE(health.text.find("fallen"), std::string::npos);
  EXPECT_NE(health.remedy.find("Clear"), std::string::npos);
  EXPECT_FALSE(health.anew);
}

TEST(Health, AStandInRobotThatHasFallenBeginsAnew) {
  StackView view(model());
  view.say_stand_in(true);
  RobotState state = test::standing();
  state.attitude = {0.70710678F, 0.0F, -0.70710678F, 0.0F};
  view.on_state(state, kStackStart);
  EXPECT_TRUE(assess(view, kStackStart).anew);
  EXPECT_NE(assess(view, kStackStart).remedy.find("Start anew"), std::string::npos);
  state.source = SourceKind::kReplay;  // a log lies as it lay
  view.on_state(state, kStackStart);
  EXPECT_FALSE(assess(view, kStackStart).anew);
}

TEST(Health, AnotherRobotIsNamed) {
  StackView view(model());
  RobotState state = standing_still();
  state.model_hash += 1;
  view.on_state(state, kStackStart);
  EXPECT_NE(assess(view, kStackStart).text.find("--robot"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
