#include "launcher/run/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace twinbus {
namespace {

constexpr std::int64_t kVerdictPeriod = 2'000'000;
constexpr int kTicks = 10000;

struct FakeRun {
  StackMonitor seen;
  RunRequest request;
  std::int64_t end = kTicks * kVerdictPeriod;

  // every: one COMMAND in so many ticks; missed: as the source counts; stalled: of these, by the machine.
  FakeRun(int every, std::int64_t missed, std::int8_t realtime, std::int64_t stalled = 0) {
    RobotState state;
    state.run_id = 7;
    JointCommand command;
    for (int tick = 0; tick < kTicks; ++tick) {
      state.tick = command.tick = tick;
      seen.on_state(state, tick * kVerdictPeriod);
      if (tick % every == 0) seen.on_command(command, tick * kVerdictPeriod);
    }
    SourceStatus status;
    status.run_id = 7;
    status.role = Role::kActive;
    status.ticks_missed = 100 + missed;
    seen.on_source_status(status, end);
    Heartbeat beat;
    beat.realtime = realtime;
    beat.kind = ProcessKind::kSimulator;
    beat.process_id = 7;
    beat.ticks_missed = 100 + missed;
    beat.ticks_stalled = 50 + stalled;
    beat.timer_missed = 60 + stalled;
    beat.age_us = 210.0F;
    beat.age_p99_us = 640.0F;
    seen.on_heartbeat(beat, end);
    beat.ticks_missed = beat.ticks_stalled = 0;
    beat.kind = ProcessKind::kController;
    beat.process_id = 8;
    seen.on_heartbeat(beat, end);
  }

  RunVerdict verdict() const {
    return judge(seen, request, {.source = 100, .source_stalled = 50, .timer = 60}, end);
  }
};

TEST(Verdict, ACleanRunPasses) { EXPECT_TRUE(FakeRun(1, 0, 1).verdict().passed); }

TEST(Verdict, MissedTicksAreJudgedByWhetherFifoWasThere) {
  EXPECT_TRUE(FakeRun(1, 10, 2).verdict().passed);  // 0.1 % with FIFO
  EXPECT_FALSE(FakeRun(1, 11, 2).verdict().passed);
  EXPECT_TRUE(FakeRun(1, 100, 0).verdict().passed);  // 1 % without
  EXPECT_FALSE(FakeRun(1, 101, 0).verdict().passed);
  EXPECT_FALSE(FakeRun(1, 11, 0).verdict().fifo);
}

TEST(Verdict, AUsersProgramIsTheControllerWhereThereIsNoOther) {
  const auto beat = [](StackMonitor& seen, ProcessKind kind, int id, std::int8_t realtime) {
    Heartbeat heartbeat;
    heartbeat.kind = kind;
    heartbeat.process_id = id;
    heartbeat.realtime = realtime;
    seen.on_heartbeat(heartbeat, kVerdictPeriod);
  };
  for (const ProcessKind source : {ProcessKind::kSimulator, ProcessKind::kBridge, ProcessKind::kReplay}) {
    StackMonitor seen;
    beat(seen, source, 7, 2);
    EXPECT_EQ(real_time_of(seen, kVerdictPeriod), 0);
    beat(seen, ProcessKind::kUser, 9, 1);
    EXPECT_EQ(real_time_of(seen, kVerdictPeriod), 1);
    beat(seen, ProcessKind::kController, 8, 2);
    EXPECT_EQ(real_time_of(seen, kVerdictPeriod), 2);
  }
}

TEST(Verdict, WhatTheMachineMissedIsToldAndNotJudged) {
  const FakeRun run(1, 90, 1, 85);
  const RunVerdict verdict = run.verdict();
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.missed, 90);
  EXPECT_EQ(verdict.stalled, 85);
  EXPECT_EQ(verdict.timer_missed, 85);
  EXPECT_FALSE(FakeRun(1, 96, 1, 85).verdict().passed);
  std::string all;
  for (const std::string& line : verdict_lines(verdict, run.request)) all += line + "\n";
  EXPECT_NE(all.find("of which 85 while the machine itself stood still"), std::string::npos) << all;
  EXPECT_NE(all.find("our own: 5 ticks (0.050 %, at most 0.1 % with FIFO)"), std::string::npos)
      << all;
  EXPECT_NE(all.find("median 210 us, 99 % within 640 us"), std::string::npos) << all;
  EXPECT_EQ(all.find("too restless"), std::string::npos) << all;
}

TEST(Verdict, AMachineThatIsTooRestlessIsNamed) {
  const FakeRun run(1, 300, 1, 298);
  std::string all;
  for (const std::string& line : verdict_lines(run.verdict(), run.request)) all += line;
  EXPECT_NE(all.find("a bare timer misses 3.0 % of the ticks"), std::string::npos) << all;
}

TEST(Verdict, ASlowStreamFails) {
  const RunVerdict verdict = FakeRun(2, 0, 1).verdict();
  EXPECT_FALSE(verdict.passed);
  EXPECT_NEAR(verdict.command_rate, 250.0, 1.0);
}

TEST(Verdict, AWorldThatWaitsMayBeSlowAndIsToldToBe) {
  FakeRun run(1, 0, 0);
  run.request.rate = 2.0;  // asked for twice what came
  EXPECT_FALSE(run.verdict().passed);
  run.request.patient = true;
  const RunVerdict verdict = run.verdict();
  EXPECT_TRUE(verdict.passed);
  std::string all;
  for (const std::string& line : verdict_lines(verdict, run.request)) all += line + "\n";
  EXPECT_NE(all.find("waited for late commands: 0.500 times real time"), std::string::npos) << all;
  FakeRun deaf(2, 0, 0);  // who commands it does not keep up
  deaf.request.patient = true;
  EXPECT_FALSE(deaf.verdict().passed);
}

TEST(Verdict, CommandsThatTheMachineSwallowedAreNoSlowStream) {
  EXPECT_TRUE(FakeRun(2, 5000, 1, 5000).verdict().passed);
  EXPECT_FALSE(FakeRun(2, 4000, 1, 4000).verdict().passed);
}

TEST(Verdict, AFallFails) {
  FakeRun run(1, 0, 1);
  SimTruth truth;
  truth.run_id = 7;
  truth.fell = true;
  run.seen.on_truth(truth, run.end);
  EXPECT_FALSE(run.verdict().passed);
}

TEST(Verdict, NothingHeardFails) {
  const StackMonitor nothing;
  EXPECT_FALSE(judge(nothing, {}, {}, 0).passed);
}

TEST(Verdict, TheReportHasThePromisedKeys) {
  const FakeRun run(1, 3, 1);
  const auto report =
      nlohmann::json::parse(report_json(run.verdict(), run.request, run.seen, 20.0, "00ff"));
  for (const char* key : {"scene",
                          "robot",
                          "engine",
                          "contact",
                          "step_s",
                          "seed",
                          "sim_time_s",
                          "wall_s",
                          "realtime_factor",
                          "ticks",
                          "missed_ticks",
                          "fell",
                          "max_tilt_deg",
                          "base_final_xyyaw",
                          "zmp_margin_min_mm",
                          "slip_max_mm",
                          "penetration_max_mm",
                          "self_collision_ticks",
                          "foot_force_rms_error_n",
                          "state_hash",
                          "passed"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["missed_ticks"], 3);
  EXPECT_EQ(report["passed"], true);
}

TEST(Verdict, WhatTheSimulatorDoubtsIsInLinesAndReport) {
  FakeRun run(1, 0, 1);
  EXPECT_EQ(run.verdict().doubts, "");
  SimTruth truth;
  truth.run_id = 7;
  truth.sim_time = 0.5;
  truth.doubted = {2, 0, 0, 1, 0, 0};
  truth.doubted_steps = 3;
  truth.doubted_since = 0.25;
  run.seen.on_truth(truth, run.end);
  const RunVerdict verdict = run.verdict();
  const std::string said = "not to be trusted: 3 physics steps (unconverged 2, first_seen_deep 1), the first at 0.250 s";
  EXPECT_EQ(verdict.doubts, said);
  const std::vector<std::string> lines = verdict_lines(verdict, run.request);
  EXPECT_NE(std::find(lines.begin(), lines.end(), said), lines.end());
  EXPECT_EQ(std::find(lines.begin(), lines.end(), "passed"), lines.end()) << "one verdict, not two";
  EXPECT_EQ(passed_line(3), "passed with 3 doubted steps: ./twinbus tune finds a step without");
  EXPECT_EQ(passed_line(0), "passed");
  const auto json = nlohmann::json::parse(report_json(verdict, run.request, run.seen, 1.0, ""));
  EXPECT_EQ(json["doubted_steps"]["any"], 3);
  EXPECT_EQ(json["doubted_steps"]["unconverged"], 2);
  EXPECT_EQ(json["doubted_steps"]["tunnelling"], 0);
  EXPECT_EQ(json["doubted_steps"]["first_at_s"], 0.25);
}

// A disk that is full costs the log, not the robot: it is said, and held against a run that asked for its log.
TEST(Verdict, RepeatsThatTheLogIsCut) {
  FakeRun run(1, 0, 1);
  Heartbeat recorder;
  recorder.process_id = 9;
  recorder.kind = ProcessKind::kLog;
  recorder.messages_lost = 1234;
  run.seen.on_heartbeat(recorder, run.end);
  const auto said = [&] {
    std::string all;
    for (const std::string& line : verdict_lines(run.verdict(), run.request)) all += line + "\n";
    return all;
  };
  EXPECT_TRUE(run.verdict().passed);
  EXPECT_NE(said().find("the log is cut: the recorder lost 1234 messages"), std::string::npos) << said();
  EXPECT_NE(said().find("passed, but the log is cut"), std::string::npos) << said();
  const nlohmann::json report = nlohmann::json::parse(report_json(run.verdict(), run.request, run.seen, 20.0, ""));
  EXPECT_EQ(report["messages_not_recorded"], 1234);
  run.request.whole_log = true;
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_NE(said().find("FAILED: the log is cut"), std::string::npos) << said();
  FakeRun well(1, 0, 1);
  well.request.whole_log = true;
  EXPECT_TRUE(well.verdict().passed);
}

TEST(Verdict, WhatTheOperatorEndedIsWhatWasMeasured) {
  FakeRun run(1, 0, 1);
  RunVerdict verdict = run.verdict();
  end_by_operator(verdict, run.request, 20.0);
  EXPECT_TRUE(verdict.passed);  // nothing was asked to last longer
  const nlohmann::json report = nlohmann::json::parse(report_json(verdict, run.request, run.seen, 20.0, ""));
  EXPECT_EQ(report["ended_by"], "the operator");
  EXPECT_EQ(report["ticks"], kTicks);
  run.request.duration = 60.0;
  end_by_operator(verdict, run.request, 20.0);
  EXPECT_FALSE(verdict.passed);
  std::string all;
  for (const std::string& line : verdict_lines(verdict, run.request)) all += line + "\n";
  EXPECT_NE(all.find("ended by the operator after 20.0 s"), std::string::npos) << all;
  EXPECT_NE(all.find("FAILED: 60.0 s were asked"), std::string::npos) << all;
}

}  // namespace
}  // namespace twinbus
