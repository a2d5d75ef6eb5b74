#include "launcher/bus/live_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lcmtypes/msg/pace.h"

namespace twinbus {
namespace {

constexpr std::int64_t kNow = 10'000'000'000;  // [ns]

SourceStatus source_of(SourceKind kind, Role role, std::int64_t run) {
  SourceStatus status;
  status.source = kind;
  status.role = role;
  status.run_id = run;
  status.term = 1;
  status.pace = static_cast<std::int8_t>(Pace::kRealTime);
  return status;
}

// A simulator that stands by nothing, and a controller, both heard a moment ago.
StackMonitor healthy(const SourceStatus& status = source_of(SourceKind::kSimulator, Role::kActive, 7)) {
  StackMonitor seen;
  seen.on_source_status(status, kNow);
  Heartbeat beat;
  beat.process_id = 8;
  beat.pid = -1;
  beat.kind = ProcessKind::kController;
  beat.channels = 1;
  beat.channel[0] = 1;
  beat.channel_received[0] = 500;
  seen.on_heartbeat(beat, kNow);
  seen.on_command({}, kNow);
  seen.on_controller_status({}, kNow);
  return seen;
}

bool has(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(ActingLines, AreNoneWhileAllIsWell) { EXPECT_TRUE(acting_lines(healthy(), kNow).empty()); }

TEST(ActingLines, NameWhatIsWrongWithItsRemedy) {
  SourceStatus stopped = source_of(SourceKind::kSimulator, Role::kStopped, 7);
  stopped.stop_kind = StopKind::kHold;
  stopped.stop_reason = StopReason::kOperator;
  EXPECT_TRUE(has(acting_lines(healthy(stopped), kNow), "the robot is stopped (hold) by the operator: ./twinbus clear"));

  StackMonitor standby = healthy();
  SourceStatus bridge = source_of(SourceKind::kBridge, Role::kParked, 9);
  bridge.stop_kind = StopKind::kOff;
  standby.on_source_status(bridge, kNow);
  EXPECT_TRUE(has(acting_lines(standby, kNow), "bridge is stopped (off)"));

  SourceStatus paused = source_of(SourceKind::kSimulator, Role::kActive, 7);
  paused.pace = static_cast<std::int8_t>(Pace::kPaused);
  StackMonitor still = healthy(paused);
  EXPECT_TRUE(has(acting_lines(still, kNow), "./twinbus sim go"));

  const StackMonitor parked = healthy(source_of(SourceKind::kBridge, Role::kParked, 7));
  EXPECT_TRUE(has(acting_lines(parked, kNow), "no source is active (bridge): ./twinbus switch"));

  StackMonitor alone;
  alone.on_source_status(source_of(SourceKind::kSimulator, Role::kActive, 7), kNow);
  EXPECT_TRUE(has(acting_lines(alone, kNow), "nobody commands the robot"));

  StackMonitor unguarded = healthy();
  unguarded.on_guard({}, kNow - 3'000'000'000);
  EXPECT_TRUE(has(acting_lines(unguarded, kNow), "the guard is silent: ./twinbus restart guard"));

  StackMonitor fallen = healthy(stopped);
  SimTruth truth;
  truth.fell = true;
  fallen.on_truth(truth, kNow);
  EXPECT_TRUE(has(acting_lines(fallen, kNow), "the robot has fallen: ./twinbus sim reset"));
  EXPECT_FALSE(has(acting_lines(fallen, kNow), "is stopped"));  // of it, and reset ends that too
}

Estimate lying() {
  Estimate estimate;
  estimate.run_id = 7;
  estimate.base_attitude = {0.70710678, 0.0, -0.70710678, 0.0};  // on its back
  return estimate;
}

// A hardware bridge knows no truth: its own estimate tells, however the IMU is built in.
TEST(ActingLines, ARobotThatLiesIsNamedWithoutASimulator) {
  StackMonitor seen = healthy(source_of(SourceKind::kBridge, Role::kActive, 7));
  Estimate estimate = lying();
  seen.on_estimate(estimate, kNow);
  EXPECT_TRUE(has(acting_lines(seen, kNow), "the robot lies: put it on its feet"));
  EXPECT_TRUE(has(acting_lines(seen, kNow), "a stand-in robot: ./twinbus sim reset"));
  estimate.velocity_from = VelocityFrom::kFixed;  // an arm that hangs on a wall
  seen.on_estimate(estimate, kNow);
  EXPECT_TRUE(acting_lines(seen, kNow).empty());
  estimate = {};
  estimate.run_id = 7;
  seen.on_estimate(estimate, kNow);
  EXPECT_TRUE(acting_lines(seen, kNow).empty());
}

TEST(StackMonitor, AReplayIsAskedForNoMotion) {
  EXPECT_NO_THROW(refuse_in_replay(healthy(), kNow));
  EXPECT_THROW(refuse_in_replay(healthy(source_of(SourceKind::kReplay, Role::kActive, 7)), kNow), std::runtime_error);
}

// An arm has no feet.
TEST(ShortLines, WhereNoFootCarriesNoMarginIsSaid) {
  CpuShare shares;
  for (const bool carried : {false, true}) {
    StackMonitor seen = healthy();
    ControllerStatus status;
    status.zmp_margin = carried ? 0.05F : -1.0F;
    seen.on_controller_status(status, kNow);
    const std::vector<std::string> lines = short_lines(seen, shares, kNow);
    EXPECT_TRUE(has(lines, "robot: mode"));
    EXPECT_EQ(has(lines, "ZMP margin 50.0 mm"), carried);
    EXPECT_EQ(has(lines, "ZMP margin"), carried);
  }
}

TEST(ShortLines, BeginWithWhatHasToBeDoneAndLeaveStreamsOut) {
  CpuShare shares;
  const std::vector<std::string> well = short_lines(healthy(), shares, kNow);
  EXPECT_EQ(well.front(), "nothing needs acting on");
  EXPECT_FALSE(has(well, "stream"));
  EXPECT_TRUE(has(well, "robot: mode") && has(well, "controller") && has(well, "simulator"));
  EXPECT_TRUE(has(table_lines(healthy(), shares, kNow), "stream"));
  const StackMonitor parked = healthy(source_of(SourceKind::kBridge, Role::kParked, 7));
  EXPECT_EQ(short_lines(parked, shares, kNow).front().find("ACT: no source is active"), 0u);
  EXPECT_TRUE(short_lines(StackMonitor(), shares, kNow).empty());  // no table of nobody
}

// A terminal that is too low leaves out the end.
TEST(TableLines, BeginWithWhatHasToBeDone) {
  CpuShare shares;
  const StackMonitor parked = healthy(source_of(SourceKind::kBridge, Role::kParked, 7));
  const std::vector<std::string> lines = table_lines(parked, shares, kNow);
  EXPECT_EQ(lines.front().find("no source is active"), 0u) << lines.front();
  EXPECT_EQ(lines[1].find("robot: mode"), 0u) << lines[1];
}

}  // namespace
}  // namespace twinbus
