#include "viewer_log/view/log_view.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "robot/description/load.h"
#include "viewer_log/view/frame.h"
#include "viewer_log/log/log_marks.h"
#include "viewer_log/log/log_library.h"
#include "viewer_log/log/log_writer.h"
#include "viewer_log/server/replay_request.h"

namespace twinbus {
namespace {

constexpr std::int64_t kStart = 1'700'000'000'000'000;  // [us]

// A log whose messages are structs as they lie in memory: what LogView needs to know of messages is told by its feed.
class RawFeed : public LogFeed {
 public:
  Kind kind_of(const LogEvent& event) const override {
    return event.channel == "STATE"    ? Kind::kState
           : event.channel == "STATUS" ? Kind::kEachTick
                                       : Kind::kOther;
  }
  Kind feed(const LogEvent& event, StackView& view, std::int64_t now) override {
    if (event.channel == "STATE") {
      RobotState state;
      std::memcpy(static_cast<void*>(&state), event.data.data(), sizeof state);
      view.on_state(state, now);
      return Kind::kState;
    }
    if (event.channel != "STATUS") return Kind::kOther;
    ControllerStatus status;
    std::memcpy(static_cast<void*>(&status), event.data.data(), sizeof status);
    view.on_controller_status(status, now);
    return Kind::kOther;
  }
};

template <class T>
std::vector<std::uint8_t> raw(const T& value) {
  std::vector<std::uint8_t> bytes(sizeof value);
  std::memcpy(bytes.data(), static_cast<const void*>(&value), sizeof value);
  return bytes;
}

class LogViews : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = (std::filesystem::temp_directory_path() / "log_view_XXXXXX").string();
    ASSERT_NE(mkdtemp(folder_.data()), nullptr);
    file_ = folder_ + "/run.log";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  // Ten seconds of standing; the first state comes after half a second, the controller believes to be at x = 3.
  void write_log() {
    LogWriter writer(file_);
    ControllerStatus status;
    status.base_position = {3.0F, 1.0F, 0.7F};
    writer.add(kStart, "OTHER", raw(status));
    for (int tick = 0; tick < 5000; ++tick) {
      RobotState state;
      state.tick = 100 + tick;
      state.time_ns = 2'000'000LL * tick;
      state.run_id = 7;
      state.term = 1;
      state.joint_count = static_cast<std::int16_t>(model_.bus_count());
      state.period_ns = 2'000'000;
      state.attitude = {1, 0, 0, 0};
      state.sensor_flags = kImuValid;
      const std::int64_t at = kStart + 500'000 + 2000LL * tick;
      writer.add(at, "STATE", raw(state));
      writer.add(at + 300, "STATUS", raw(status));
    }
    writer.close();
  }

  const Model model_ = load_robot("hrp1s");
  RawFeed feed_;
  std::string folder_, file_;
};

TEST_F(LogViews, BeginsAtTheFirstStateAndStepsByStates) {
  write_log();
  LogView log(model_, file_, feed_);
  EXPECT_NEAR(log.first_state(), 0.5, 1e-9);
  EXPECT_EQ(log.view().state().value.tick, 100);
  log.step(1);
  EXPECT_EQ(log.view().state().value.tick, 101);
  log.step(1);
  log.step(-1);
  EXPECT_EQ(log.view().state().value.tick, 101);
  log.step(-1);
  log.step(-1);
  EXPECT_EQ(log.view().state().value.tick, 100) << "there is none before the first";
}

TEST_F(LogViews, AMomentLooksTheSameHoweverItIsReached) {
  write_log();
  LogView played(model_, file_, feed_), jumped(model_, file_, feed_);
  for (int i = 0; i < 400; ++i) played.advance(0.01);
  jumped.seek(9.0);
  jumped.seek(played.position());
  EXPECT_EQ(played.view().state().value.tick, jumped.view().state().value.tick);
  EXPECT_EQ(played.now_ns(), jumped.now_ns());
  const Eigen::Isometry3d a = played.place() * played.view().estimator().configuration().base,
                          b = jumped.place() * jumped.view().estimator().configuration().base;
  EXPECT_LT((a.translation() - b.translation()).norm(), 1e-6);
  EXPECT_NEAR(b.translation().x(), 3.0, 1e-6) << "where the controller believed to be";
  EXPECT_NEAR(jumped.view().rates().state(), 500.0, 3.0);
}

TEST_F(LogViews, APictureIsDrawnWhereTheRobotWas) {
  write_log();
  LogView log(model_, file_, feed_);
  log.seek(5.0);
  const Recorded here{.seconds = 5.0};
  Recorded there{.seconds = 5.0};
  there.place =
      Eigen::Translation3d(3.0, 1.0, 0.0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  const auto a = nlohmann::json::parse(live_frame(log.view(), log.now_ns(), &here));
  const auto b = nlohmann::json::parse(live_frame(log.view(), log.now_ns(), &there));
  for (const auto& [from, to] :
       {std::pair(a["base"], b["base"]), std::pair(a["com"], b["com"]),
        std::pair(a["soles"][0][1], b["soles"][0][1]), std::pair(a["hands"][1], b["hands"][1])}) {
    EXPECT_NEAR(to[0].get<double>(), 3.0 - from[1].get<double>(), 2e-4);
    EXPECT_NEAR(to[1].get<double>(), 1.0 + from[0].get<double>(), 2e-4);
    EXPECT_EQ(to[2], from[2]);
  }
}

TEST_F(LogViews, SeeksBeyondTheEndsStayInside) {
  write_log();
  LogView log(model_, file_, feed_);
  for (const double s : {-5.0, 0.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    log.seek(s);
    EXPECT_GE(log.position(), 0.0);
    EXPECT_LE(log.position(), log.duration());
  }
  log.seek(1e9);
  log.advance(1.0);
  log.step(1);
  EXPECT_EQ(log.view().state().value.tick, 5099);
  EXPECT_EQ(log.damage().places, 0);
}

TEST_F(LogViews, AReadableLogWithoutStatesIsRefusedWithARemedy) {
  {
    LogWriter writer(file_);
    writer.add(kStart, "SOMETHING", raw(ControllerStatus{}));
    writer.close();
  }
  try {
    LogView log(model_, file_, feed_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("--robot"), std::string::npos) << error.what();
  }
}

TEST_F(LogViews, TheShelfKnowsRunsByNameAndNothingElse) {
  write_log();
  std::filesystem::create_directories(folder_ + "/runs/2026-01-01-000000");
  std::filesystem::copy(file_, folder_ + "/runs/2026-01-01-000000/run.log");
  std::filesystem::create_directories(folder_ + "/runs/empty");
  LogShelf shelf(folder_ + "/runs");
  ASSERT_EQ(shelf.logs().size(), 1U);
  EXPECT_EQ(shelf.add(""), "2026-01-01-000000");
  EXPECT_EQ(shelf.find("../run.log"), nullptr);
  EXPECT_THROW(shelf.add(folder_ + "/nothing.log"), std::runtime_error);
  EXPECT_THROW(shelf.add("/dev/null"), std::runtime_error);
  const std::string name = shelf.add(file_);
  ASSERT_NE(shelf.find(name), nullptr);
  EXPECT_EQ(shelf.find(name)->file, file_);
  EXPECT_EQ(shelf.add(file_), name) << "twice is once";
  EXPECT_THROW(LogShelf("").add(""), std::runtime_error);
}

TEST(MarkFinder, NamesSwitchStopFallGuardMissedAndMessagesOnce) {
  MarkFinder finder(kStart);
  RobotState state;
  state.attitude = {1, 0, 0, 0};
  state.sensor_flags = kImuValid;
  state.source = SourceKind::kSimulator;
  state.run_id = 1;
  state.term = 1;
  std::int64_t at = kStart;
  const auto say = [&](int count) {
    for (int i = 0; i < count; ++i) finder.on_state(state, at += 2000);
  };
  say(10);
  state.run_id = 2, state.term = 2, state.source = SourceKind::kBridge;
  say(10);
  state.stop_kind = StopKind::kHold;
  say(3);
  state.stop_kind = StopKind::kNone;
  say(3);
  Estimate estimate;
  estimate.base_attitude = {0.6, 0.8, 0, 0};
  for (int i = 0; i < 3; ++i) finder.on_estimate(estimate, at += 2000);
  say(3);
  at += 100'000;
  say(3);
  GuardReport guard;
  guard.hold_mask = 4;
  for (int i = 0; i < 10; ++i) finder.on_guard(guard, at += 2000);
  SourceStatus status;
  status.run_id = 2;
  finder.on_source_status(status, at);
  status.ticks_missed = 3;
  finder.on_source_status(status, at);
  Event event;
  event.sender_id = 5;
  std::strcpy(event.text.data(), "the robot has fallen");
  for (int i = 0; i < 3; ++i) finder.on_event(event, at);
  std::vector<std::string> kinds;
  for (const LogMark& mark : finder.marks()) kinds.emplace_back(label(mark.kind));
  EXPECT_EQ(kinds, (std::vector<std::string>{"switch", "switch", "stop", "stop", "fall", "missed",
                                             "guard", "missed", "fall"}));
  EXPECT_NEAR(finder.marks().front().seconds, 0.002, 1e-9);
}

TEST(MarkFinder, AWorldThatIsBegunAnewOrPausedHasMissedNothing) {
  MarkFinder finder(kStart);
  RobotState state;
  state.attitude = {1, 0, 0, 0};
  state.sensor_flags = kImuValid;
  state.run_id = 1;
  std::int64_t at = kStart;
  const auto say = [&](int count) {
    for (int i = 0; i < count; ++i) {
      ++state.tick;
      finder.on_state(state, at += 2000);
    }
  };
  say(100);
  SourceStatus status;
  status.run_id = 1;
  status.pace = 4;
  finder.on_source_status(status, at);
  at += 5'000'000;
  say(100);
  at += 3'000'000;
  state.run_id = 2;
  state.tick = 0;
  say(10);
  at += 60'000;
  say(10);
  std::vector<std::string> said;
  for (const LogMark& mark : finder.marks()) said.push_back(std::string(label(mark.kind)) + ": " + mark.text);
  EXPECT_EQ(said, (std::vector<std::string>{"switch: none holds STATE, term 0", "message: paused for 5002 ms",
                                            "message: the world ended; it was begun anew after 3002 ms",
                                            "switch: none holds STATE, term 0", "missed: no STATE for 62 ms"}));
}

TEST(MarkFinder, IsBounded) {
  MarkFinder finder(kStart);
  Event event;
  for (int i = 0; i < 5000; ++i) {
    event.sequence = i;
    finder.on_event(event, kStart + i);
  }
  EXPECT_EQ(finder.marks().size(), kMostMarks);
  EXPECT_EQ(finder.left_out(), 2000);
}

TEST(ReplayRequest, IsReadStrictly) {
  ReplayRequest request;
  std::string problem;
  using What = ReplayRequest::What;
  EXPECT_TRUE(read_replay_request(R"({"do":"hello"})", false, request, problem));
  EXPECT_TRUE(read_replay_request(R"({"do":"seek","s":1.5})", true, request, problem));
  EXPECT_EQ(request.what, What::kSeek);
  EXPECT_EQ(request.seconds, 1.5);
  EXPECT_TRUE(read_replay_request(R"({"do":"mark","in":null,"out":2})", true, request, problem));
  EXPECT_LT(request.in, 0.0);
  EXPECT_EQ(request.out, 2.0);
  EXPECT_TRUE(
      read_replay_request(R"({"do":"beside","log":"a","shift":-0.5})", true, request, problem));
  EXPECT_EQ(request.log, "a");
  for (const char* text :
       {R"({"do":"seek","s":-1})", R"({"do":"seek","s":1e300})", R"({"do":"seek"})",
        R"({"do":"step","by":0.5})", R"({"do":"speed","x":0})", R"({"do":"speed","x":1e9})",
        R"({"do":"loop","on":1})", R"({"do":"mark","in":3,"out":2})", R"({"do":"open","log":7})",
        R"({"do":"fill","seconds":1e6})", R"({"do":"mode","mode":"walk"})",
        R"({"do":"stop","kind":1})", "[]", "{", "", R"({"do":7})"}) {
    EXPECT_FALSE(read_replay_request(text, true, request, problem)) << text;
    EXPECT_FALSE(problem.empty());
  }
  EXPECT_FALSE(read_replay_request(R"({"do":"play"})", false, request, problem))
      << "without the token";
}

}  // namespace
}  // namespace twinbus
