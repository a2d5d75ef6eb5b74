// What an operator's tool sees on the bus: every source, every process, the streams between them.
//
// Only looks and counts; knows nothing of LCM, so a test can feed it.  Control never uses it.

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "launcher/bus/meter.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline launcher {

// One source, from its SOURCE_STATUS and the states it publishes.
struct SeenSource {
  SourceStatus status{};
  std::int64_t heard_ns = 0;  // newest status
  Meter states;               // on whichever channel
  RobotState state{};         // the newest one
  bool on_state = false;      // the newest one came on STATE
  bool lies = false;          // its robot, by its newest estimate
};

struct SeenProcess {
  Heartbeat beat{};
  std::int64_t heard_ns = 0;
};

// Worst and sums over TRUTH and GUARD of one run.
struct RunFigures {
  std::int64_t truths = 0;
  bool fell = false;
  double max_tilt = 0.0;        // of the base against its first attitude's vertical [rad]
  double zmp_margin_min = 1e9;  // [m]
  double slip_max = 0.0;        // distance a sole slid in all [m]
  std::array<double, kMaxFeet> slip{};
  double penetration_max = 0.0;  // [m]
  double sim_time = 0.0;         // [s]
  double first_sim_time = -1.0;
  double base[3] = {0.0, 0.0, 0.0};  // x, y [m], yaw [rad]
  double realtime_factor = 0.0;
  std::int64_t self_collision_ticks = 0;
  std::array<std::int64_t, std::tuple_size_v<decltype(SimTruth::doubted)>> doubted{};  // physics steps, as TRUTH has them
  std::int64_t doubted_steps = 0;
  double doubted_since = -1.0;  // sim_time of the first of them [s]
};

class StackMonitor {
 public:
  void on_state(const RobotState& state, std::int64_t now_ns);          // on STATE
  void on_standby_state(const RobotState& state, std::int64_t now_ns);  // on STATE_SIM, STATE_BRIDGE or STATE_REPLAY
  void on_estimate(const Estimate& estimate, std::int64_t now_ns);
  void on_command(const JointCommand& command, std::int64_t now_ns);
  void on_source_status(const SourceStatus& status, std::int64_t now_ns);
  void on_heartbeat(const Heartbeat& beat, std::int64_t now_ns);
  void on_truth(const SimTruth& truth, std::int64_t now_ns);
  void on_guard(const GuardReport& report, std::int64_t now_ns);
  void on_controller_status(const ControllerStatus& status, std::int64_t now_ns);
  void on_event(const Event& event);

  // Sources and processes heard within seconds.
  std::vector<const SeenSource*> sources(std::int64_t now_ns, double seconds = 1.0) const;
  std::vector<const SeenProcess*> processes(std::int64_t now_ns, double seconds = 1.0) const;
  // The source whose role is active, releasing or stopped; null if there is none.
  const SeenSource* active(std::int64_t now_ns) const;
  const SeenSource* source(std::int64_t run_id) const;
  const SeenProcess* process_of_pid(std::int32_t pid) const;

  const Meter& state() const { return state_; }
  const Meter& command() const { return command_; }
  const Meter& guard() const { return guard_; }
  const Meter& truth() const { return truth_; }
  const RobotState& newest_state() const { return newest_state_; }
  const ControllerStatus& controller() const { return controller_; }
  const Meter& controller_statuses() const { return controller_meter_; }
  const GuardReport& newest_guard() const { return newest_guard_; }
  const RunFigures& figures() const { return figures_; }
  // Events since the last call, as lines.
  std::vector<std::string> take_events();

  // Forgets counts and figures (not who is there): the measured part of a run begins.
  void restart_counts();

 private:
  void keep(const RobotState& state, bool on_state, std::int64_t now_ns);
  void count_doubts(const SimTruth& truth, bool active);

  std::map<std::int64_t, SeenSource> sources_;
  std::map<std::int64_t, SeenProcess> processes_;
  Meter state_, command_, guard_, truth_, controller_meter_;
  RobotState newest_state_{};
  ControllerStatus controller_{};
  GuardReport newest_guard_{};
  RunFigures figures_;
  std::vector<std::string> events_;
  double last_truth_time_ = -1.0;
  static constexpr std::size_t kMostWorlds = 64;
  std::map<std::int64_t, SimTruth> worlds_;  // by run: what each doubted by then is not counted twice
};

// Words for what messages carry as numbers.
// Does the active source stand still because somebody asked it to?
bool is_paused(const StackMonitor& seen, std::int64_t now_ns);
// Does its clock run otherwise than time does: paused, slowed or hurried?
bool has_own_clock(const StackMonitor& seen, std::int64_t now_ns);
// Throws std::runtime_error with the remedy: what is sent to a world that stands still is obeyed when nobody thinks of it any
// more.
void refuse_while_paused(const StackMonitor& seen, std::int64_t now_ns);
// Throws while a log is replayed: it goes its way, whatever a controller asks for.
void refuse_in_replay(const StackMonitor& seen, std::int64_t now_ns);
// "sways"; empty when it does nothing that has a name.
std::string motion_text(const ControllerStatus& status);
const char* source_name(SourceKind source);
const char* process_name(ProcessKind kind);
const char* realtime_name(std::int8_t realtime);  // as in Heartbeat

}  // namespace twinbus::launcher
