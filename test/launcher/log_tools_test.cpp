// The log tools on small logs: what is missing, who asked, and what is said of a channel that is not there.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_gaps.h"
#include "launcher/log/log_scan.h"
#include "launcher/log/rerun.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/messages.h"
#include "viewer_log/log/log_writer.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

class LogTools : public ::testing::Test {
 protected:
  LogTools() : folder_(fs::temp_directory_path() / ("log_tools_test_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    file_ = (folder_ / "run.log").string();
    writer_.emplace(file_);
  }
  ~LogTools() override { fs::remove_all(folder_); }

  template <class Message>
  void write(const char* channel, const Message& message) {
    writer_->add(utime_ += 500, channel, encoded(message));
  }
  // Ticks `from` to `to` of a source that holds STATE, each answered by controller 7 and judged by guard 8.
  void ticks(std::int64_t run, std::int32_t term, std::int64_t from, std::int64_t to) {
    for (std::int64_t tick = from; tick <= to; ++tick) {
      RobotState state;
      state.tick = tick;
      state.run_id = run;
      state.term = term;
      state.joint_count = 2;
      state.period_ns = 2'000'000;
      state.attitude = {1, 0, 0, 0};
      state.q[0] = 1e-3 * static_cast<double>(tick) + static_cast<double>(run);
      write("STATE", state);
      write("COMMAND", JointCommand{.tick = tick, .run_id = run, .controller_id = 7, .term = term, .joint_count = 2});
      GuardReport guard;
      guard.tick = tick;
      guard.run_id = run;
      guard.guard_id = 8;
      write("GUARD", guard);
    }
  }
  std::int64_t missing(const char* channel) {
    writer_->close();
    LogGaps gaps;
    scan_log(file_, 0.0, kWholeLog, [&](const LogEvent& event) {
      gaps.add(event);
      return true;
    });
    return gaps.missing(channel);
  }
  // Exit status, or 2 and the sentence of what was thrown.
  int run(int (*tool)(const std::vector<std::string>&), const std::vector<std::string>& words) {
    ::testing::internal::CaptureStdout();
    int status = 2;
    said_.clear();
    try {
      status = tool(words);
    } catch (const std::exception& error) {
      said_ = error.what();
    }
    said_ = ::testing::internal::GetCapturedStdout() + said_;
    return status;
  }
  bool says(const std::string& text) const { return said_.find(text) != std::string::npos; }

  fs::path folder_;
  std::string file_, said_;
  std::optional<LogWriter> writer_;
  std::int64_t utime_ = 1'700'000'000'000'000;
};

TEST_F(LogTools, TicksThatALogLacksAreCountedPerHolder) {
  ticks(1, 1, 1, 20);
  ticks(1, 1, 24, 40);
  for (const char* channel : {"STATE", "COMMAND", "GUARD"}) EXPECT_EQ(missing(channel), 3) << channel;
}

// Source 2 holds STATE from tick 21 to 120; while it does, source 1 sends its ticks elsewhere.
TEST_F(LogTools, AfterASwitchAndBackNothingIsMissing) {
  ticks(1, 1, 1, 20);
  ticks(2, 2, 21, 120);
  ticks(1, 3, 121, 140);
  for (const char* channel : {"STATE", "COMMAND", "GUARD"}) EXPECT_EQ(missing(channel), 0) << channel;
}

TEST_F(LogTools, AWorldThatIsBegunAnewIsCountedByItself) {
  ticks(1, 1, 1, 20);
  ticks(2, 1, 1, 10);
  ticks(2, 1, 13, 40);  // 11 and 12 are missing, though another run had them
  for (const char* channel : {"STATE", "COMMAND", "GUARD"}) EXPECT_EQ(missing(channel), 2) << channel;
}

TEST_F(LogTools, AChannelThatIsNotInTheLogIsNamedWithTheNearOneAndWhereAllAreListed) {
  ticks(1, 1, 1, 20);
  writer_->close();
  const std::string out = (folder_ / "out").string();
  const auto refused = [&](int (*tool)(const std::vector<std::string>&), std::vector<std::string> words, const std::string& name,
                           const std::string& near) {
    EXPECT_EQ(run(tool, words), 2) << said_;
    EXPECT_TRUE(says("has no channel '" + name + "'; did you mean " + near + "? (./twinbus log info " + file_)) << said_;
    EXPECT_FALSE(fs::exists(out)) << "nothing is left behind";
  };
  refused(&log_csv, {file_, "STAET", out}, "STAET", "STATE");
  EXPECT_EQ(run(&log_csv, {file_, "STATE_SIM", out}), 2);  // ours, but not in this log
  EXPECT_TRUE(says("has no channel 'STATE_SIM'; known: COMMAND, GUARD, STATE (./twinbus log info")) << said_;
  refused(&log_mcap, {file_, out, "--channels", "GUARD,COMAND"}, "COMAND", "COMMAND");
  refused(&log_rename, {file_, out, "GARD=GUARD_2"}, "GARD", "GUARD");
  refused(&log_compare, {file_, "--channels", "STATE,STATES"}, "STATES", "STATE");
  EXPECT_EQ(run(&log_events, {file_, "--prefix", "R1_"}), 2);
  EXPECT_TRUE(says("begins with --prefix 'R1_'")) << said_;
  EXPECT_EQ(run(&log_csv, {file_, "STATE", out, "--from", "100"}), 2);
  EXPECT_TRUE(says("nothing on STATE of " + file_ + " between --from and --to")) << said_;
  EXPECT_EQ(run(&log_csv, {file_, "STATE", out, "--type", "robot_stat_t"}), 2);
  EXPECT_TRUE(says("no type 'robot_stat_t'; did you mean robot_state_t?")) << said_;
  EXPECT_EQ(run(&log_csv, {file_, "STATE", out}), 0) << said_;
  EXPECT_TRUE(fs::exists(out));
}

// The source that is asked to hand over asks its controller for rest: not the scene, and no stop.
TEST_F(LogTools, EventsOfASwitchNameWhoAskedForIt) {
  const auto beat = [&](std::int64_t id, ProcessKind kind) {
    Heartbeat heartbeat;
    heartbeat.process_id = id;
    heartbeat.kind = kind;
    write("HEARTBEAT", heartbeat);
  };
  beat(1, ProcessKind::kSimulator);
  beat(5, ProcessKind::kViewer);
  ticks(1, 1, 1, 5);
  write("SOURCE_REQUEST", SourceRequest{.sender_id = 5, .run_id = 1, .target_run_id = 2, .sequence = 1,
                                        .action = SourceAction::kSwitch, .policy = SwitchPolicy::kWhenSafe});
  write("STOP", StopRequest{.sender_id = 1, .sequence = 1, .kind = StopKind::kBalanced, .reason = StopReason::kSwitch});
  write("STOP", StopRequest{.sender_id = 99, .sequence = 1, .kind = StopKind::kHold, .reason = StopReason::kOperator});
  write("MODE_REQUEST", ModeRequest{.sender_id = 1, .sequence = 9, .mode = Mode::kBalance});
  writer_->close();
  ASSERT_EQ(run(&log_events, {file_}), 0) << said_;
  EXPECT_TRUE(says("switch asked for run 2, by the viewer")) << said_;
  EXPECT_TRUE(says("rest asked before a switch, by the simulator; the switch was asked by the viewer")) << said_;
  EXPECT_TRUE(says("stop asked: hold, by a command or program")) << said_;
  EXPECT_TRUE(says("mode asked: balance, by the scene")) << said_;
}

TEST_F(LogTools, ACompareEndsWhereTheWorldIsBegunAnew) {
  ticks(1, 1, 1, 300);
  writer_->close();
  const std::string once = (folder_ / "once.log").string();
  fs::copy_file(file_, once);
  writer_.emplace(file_);
  ticks(1, 1, 1, 300);
  ticks(2, 1, 1, 600);  // ticks 301 to 600 are of another world
  writer_->close();
  ASSERT_EQ(run(&log_compare, {file_, once}), 0) << said_;
  EXPECT_TRUE(says("300 ticks, ")) << said_;
  const std::string twice = (folder_ / "twice.log").string();
  fs::copy_file(file_, twice);
  ASSERT_EQ(run(&log_compare, {file_, twice}), 0) << said_;
  EXPECT_TRUE(says("300 ticks, ")) << "not 600: " << said_;
  EXPECT_TRUE(says("where the world was begun anew")) << said_;
}

TEST_F(LogTools, WhatTheSimulatorDoubtsIsSaidOncePerKindAndCountedInTheEnd) {
  ticks(3, 1, 0, 3);
  SimTruth truth;
  truth.run_id = 3;
  for (int i = 0; i < 40; ++i) {
    truth.sim_time = 0.1 * i;
    if (i == 20) {
      truth.doubted_since = truth.sim_time;
      truth.last_doubt = StepDoubt::kUnconverged;
    }
    if (i >= 20) truth.doubted_steps = truth.doubted[0] = i - 19;
    if (i >= 30) truth.doubted[4] = 1;
    write("TRUTH", truth);
  }
  writer_->close();
  const auto said = [&](int (*tool)(const std::vector<std::string>&), const std::vector<std::string>& words) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(tool(words), 0);
    return testing::internal::GetCapturedStdout();
  };
  const std::string events = said(&log_events, {file_});
  EXPECT_NE(events.find("simulator: doubts a physics step: contacts that did not settle\n"), std::string::npos) << events;
  EXPECT_EQ(events.find("contacts that did not settle"), events.rfind("contacts that did not settle"));
  EXPECT_NE(events.find("simulator: doubts a physics step: tunnelling\n"), std::string::npos) << events;
  for (const std::vector<std::string>& words : {std::vector<std::string>{file_}, {file_, "--check"}}) {
    const std::string info = said(&log_info, words);
    EXPECT_NE(info.find("not to be trusted: 20 physics steps of run 3 since its 2.000 s (unconverged 20, tunnelling 1)"),
              std::string::npos)
        << info;
  }
}

// Two messages of 820,000 that a recorder lost are no answer that differs.
TEST(RerunVerdict, WhatTheLogLacksIsToldApartFromWhatDiffers) {
  RerunFigures good;
  good.steps = good.answers = good.inputs = 1000;
  EXPECT_TRUE(is_same({good}));
  EXPECT_EQ(rerun_verdict({good}), "bit for bit the same");
  RerunFigures lacks = good;
  lacks.missing = 2;
  EXPECT_FALSE(is_same({good, lacks}));
  EXPECT_EQ(rerun_verdict({good, lacks}).find("NOT the same"), std::string::npos);
  EXPECT_NE(rerun_verdict({good, lacks}).find("NOT COMPARABLE: 2 messages are missing"), std::string::npos);
  RerunFigures differs = good;
  differs.different = 1;
  EXPECT_EQ(rerun_verdict({good, differs}), "NOT the same");
  EXPECT_EQ(rerun_verdict({lacks, differs}).find("NOT the same; that may come of the log alone: 2 messages"), 0U);
  RerunFigures cut = good;
  cut.whole = false;
  EXPECT_NE(rerun_verdict({cut}).find("it is not whole"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
