#include "launcher/bus/stack_monitor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "common/math/pose_math.h"
#include "common/text/printable.h"
#include "lcmtypes/msg/lies_down.h"
#include "lcmtypes/msg/pace.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::size_t kMostSenders = 64;  // a flood of invented ids must not grow the maps
constexpr std::size_t kMostEvents = 200;

double age(std::int64_t heard_ns, std::int64_t now_ns) {
  return 1e-9 * static_cast<double>(now_ns - heard_ns);
}

// Angle between the z axis of this attitude (w x y z) and the vertical.
double tilt_of(const std::array<double, 4>& q) {
  const double up = 1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]);
  return std::acos(std::clamp(up, -1.0, 1.0));
}

const char* word(int index, std::initializer_list<const char*> words) {
  return index >= 0 && index < static_cast<int>(words.size()) ? words.begin()[index] : "unknown";
}

template <class Map>
auto* slot(Map& map, std::int64_t id) {
  auto found = map.find(id);
  if (found == map.end()) {
    if (map.size() >= kMostSenders) return static_cast<typename Map::mapped_type*>(nullptr);
    found = map.try_emplace(id).first;
  }
  return &found->second;
}

}  // namespace

void StackMonitor::keep(const RobotState& state, bool on_state, std::int64_t now_ns) {
  if (auto* source = slot(sources_, state.run_id)) {
    source->states.add(state.tick, now_ns);
    source->on_state = on_state;
    source->state = state;
  }
}

void StackMonitor::on_standby_state(const RobotState& state, std::int64_t now_ns) { keep(state, false, now_ns); }

void StackMonitor::on_state(const RobotState& state, std::int64_t now_ns) {
  keep(state, true, now_ns);
  state_.add(state.tick, now_ns);
  newest_state_ = state;
}

void StackMonitor::on_estimate(const Estimate& estimate, std::int64_t /*now_ns*/) {
  if (auto* source = slot(sources_, estimate.run_id)) source->lies = lies_down(estimate);
}

void StackMonitor::on_command(const JointCommand& command, std::int64_t now_ns) {
  command_.add(command.tick, now_ns);
}

void StackMonitor::on_source_status(const SourceStatus& status, std::int64_t now_ns) {
  if (auto* source = slot(sources_, status.run_id)) {
    source->status = status;
    source->heard_ns = now_ns;
  }
}

void StackMonitor::on_heartbeat(const Heartbeat& beat, std::int64_t now_ns) {
  if (auto* process = slot(processes_, beat.process_id)) {
    process->beat = beat;
    process->heard_ns = now_ns;
  }
}

void StackMonitor::on_truth(const SimTruth& truth, std::int64_t now_ns) {
  if (state_.received() > 0 && truth.run_id != newest_state_.run_id)
    return count_doubts(truth, false);  // of a standby simulator
  truth_.add(truth.tick, now_ns);
  RunFigures& f = figures_;
  ++f.truths;
  f.fell = f.fell || truth.fell;
  f.max_tilt = std::max(f.max_tilt, tilt_of(truth.base_attitude));
  f.zmp_margin_min = std::min(f.zmp_margin_min, static_cast<double>(truth.zmp_margin));
  const double dt = last_truth_time_ < 0.0 ? 0.0 : truth.sim_time - last_truth_time_;
  for (std::size_t foot = 0; foot < kMaxFeet; ++foot) {
    if (dt > 0.0 && dt < 0.1) f.slip[foot] += dt * static_cast<double>(truth.foot_slip[foot]);
    f.slip_max = std::max(f.slip_max, f.slip[foot]);
  }
  last_truth_time_ = truth.sim_time;
  f.penetration_max = std::max(f.penetration_max, static_cast<double>(truth.penetration));
  if (f.first_sim_time < 0.0) f.first_sim_time = truth.sim_time;
  f.sim_time = truth.sim_time;
  f.base[0] = truth.base_position[0];
  f.base[1] = truth.base_position[1];
  f.base[2] = yaw_of(truth.base_attitude);
  f.realtime_factor = static_cast<double>(truth.realtime_factor);
  count_doubts(truth, true);
}

// Another run is another world, and so is one that begins anew.  What a world doubts while it is not the active one is not of this run.
void StackMonitor::count_doubts(const SimTruth& truth, bool active) {
  if (worlds_.size() >= kMostWorlds && !worlds_.contains(truth.run_id)) worlds_.erase(worlds_.begin());
  SimTruth& last = worlds_[truth.run_id];
  if (truth.sim_time < last.sim_time) last = {};
  if (active && truth.doubted_steps > last.doubted_steps) {
    RunFigures& f = figures_;
    if (f.doubted_since < 0.0) f.doubted_since = last.doubted_steps > 0 ? truth.sim_time : truth.doubted_since;
    f.doubted_steps += truth.doubted_steps - last.doubted_steps;
    for (std::size_t i = 0; i < f.doubted.size(); ++i) f.doubted[i] += std::max(0, truth.doubted[i] - last.doubted[i]);
  }
  last = truth;
}

void StackMonitor::on_guard(const GuardReport& report, std::int64_t now_ns) {
  guard_.add(report.tick, now_ns);
  newest_guard_ = report;
  if (report.verdict == GuardVerdict::kInCollision) ++figures_.self_collision_ticks;
}

void StackMonitor::on_controller_status(const ControllerStatus& status, std::int64_t now_ns) {
  controller_meter_.add(status.tick, now_ns);
  controller_ = status;
}

void StackMonitor::on_event(const Event& event) {
  if (events_.size() >= kMostEvents) return;
  if (event.text[0] == '\0') return;  // nothing to tell
  // A terminal obeys control characters; a stranger's datagram must not reach it.
  const std::string_view text(event.text.data(), strnlen(event.text.data(), event.text.size()));
  events_.push_back(std::string(process_name(event.kind)) + ": " + printable(text));
}

std::vector<const SeenSource*> StackMonitor::sources(std::int64_t now_ns, double seconds) const {
  std::vector<const SeenSource*> found;
  for (const auto& [id, source] : sources_) {
    if (source.heard_ns > 0 && age(source.heard_ns, now_ns) < seconds) found.push_back(&source);
  }
  return found;
}

std::vector<const SeenProcess*> StackMonitor::processes(std::int64_t now_ns, double seconds) const {
  std::vector<const SeenProcess*> found;
  for (const auto& [id, process] : processes_) {
    if (age(process.heard_ns, now_ns) < seconds) found.push_back(&process);
  }
  std::sort(found.begin(), found.end(), [](const SeenProcess* a, const SeenProcess* b) {
    return a->beat.kind != b->beat.kind ? a->beat.kind < b->beat.kind : a->beat.pid < b->beat.pid;
  });
  return found;
}

const SeenSource* StackMonitor::active(std::int64_t now_ns) const {
  const SeenSource* best = nullptr;
  for (const SeenSource* source : sources(now_ns)) {
    const Role role = source->status.role;
    if (role != Role::kActive && role != Role::kReleasing && role != Role::kStopped) continue;
    if (best == nullptr || source->status.term > best->status.term) best = source;
  }
  return best;
}

const SeenSource* StackMonitor::source(std::int64_t run_id) const {
  const auto found = sources_.find(run_id);
  return found == sources_.end() ? nullptr : &found->second;
}

const SeenProcess* StackMonitor::process_of_pid(std::int32_t pid) const {
  for (const auto& [id, process] : processes_) {
    if (process.beat.pid == pid) return &process;
  }
  return nullptr;
}

std::vector<std::string> StackMonitor::take_events() { return std::exchange(events_, {}); }

void StackMonitor::restart_counts() {
  for (Meter* meter : {&state_, &command_, &guard_, &truth_, &controller_meter_}) meter->restart();
  figures_ = RunFigures();
  last_truth_time_ = -1.0;
}

bool is_paused(const StackMonitor& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  return active != nullptr && has_pace(active->status, Pace::kPaused);
}

bool has_own_clock(const StackMonitor& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  return active != nullptr && (has_pace(active->status, Pace::kPaused) || has_pace(active->status, Pace::kSlowed));
}

void refuse_while_paused(const StackMonitor& seen, std::int64_t now_ns) {
  if (is_paused(seen, now_ns)) throw std::runtime_error("the simulated world is paused: ./twinbus sim go, then ask again");
}

void refuse_in_replay(const StackMonitor& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  if (active != nullptr && active->status.source == SourceKind::kReplay)
    throw std::runtime_error("a log is replayed, and it obeys nobody: ./twinbus switch sim or bridge, where one runs, then ask again");
}

std::string motion_text(const ControllerStatus& status) {
  if (status.mode != Mode::kBalance) return "";
  switch (status.motion) {
    case Motion::kSway:
      return "sways";
    case Motion::kSquat:
      return "moves up and down";
    case Motion::kPlayed:
      return "plays a motion";
    default:
      return "";
  }
}

const char* source_name(SourceKind source) {
  return word(static_cast<int>(source), {"none", "simulator", "bridge", "replay"});
}

const char* process_name(ProcessKind kind) {
  return word(static_cast<int>(kind),
              {"process", "simulator", "bridge", "replay", "controller", "guard", "planner",
               "viewer", "gamepad", "log", "launcher", "user"});
}

const char* realtime_name(std::int8_t realtime) {
  return word(realtime, {"none", "FIFO", "FIFO+locked"});
}

}  // namespace twinbus::launcher
