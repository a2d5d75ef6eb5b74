#include "launcher/bus/live_table.h"

#include <utility>

#include "common/process/command_word.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/pace.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline launcher {

namespace {

std::string age_text(double seconds) {
  if (seconds > 1e6) return "never";
  return seconds < 1.0 ? formatted("%.1f ms", 1e3 * seconds) : formatted("%.1f s", seconds);
}

std::string stream_line(const char* name, const Meter& meter, std::int64_t now_ns) {
  return formatted("  %-10s %7.1f %9s %7lld", name, meter.rate(now_ns),
                   age_text(meter.age(now_ns)).c_str(), static_cast<long long>(meter.lost()));
}

std::string source_line(const SeenSource& source, std::int64_t now_ns) {
  const SourceStatus& s = source.status;
  std::string line = formatted(
      "  %-10s %7.1f %9s %5d %8lld %6lld %9lld", source_name(s.source), source.states.rate(now_ns),
      label(s.role), s.term, static_cast<long long>(s.ticks_missed),
      static_cast<long long>(s.commands_late), static_cast<long long>(s.commands_rejected));
  if (has_pace(s, Pace::kPatient)) line += "  waits for late commands";
  if (s.stop_kind != StopKind::kNone) line += std::string("  STOP ") + label(s.stop_kind);
  if (s.adaptor_status != 0)
    line += std::string("  ") + to_text(static_cast<Status>(s.adaptor_status));
  return line;
}

// Viewer, planner and gamepad have no ticks to be missed.
bool has_ticks(ProcessKind kind) {
  return kind == ProcessKind::kSimulator || kind == ProcessKind::kBridge || kind == ProcessKind::kReplay ||
         kind == ProcessKind::kController || kind == ProcessKind::kGuard;
}

std::string process_line(const SeenProcess& process, double cpu) {
  const Heartbeat& b = process.beat;
  std::string line = formatted("  %-10s %7.1f %9d %5.0f", process_name(b.kind),
                               static_cast<double>(b.rate), b.pid, 1e2 * cpu);
  if (!has_ticks(b.kind)) return line;
  return line + formatted(" %8lld %6.0f %6.0f %6.0f %6lld  %s",
                          static_cast<long long>(b.ticks_missed),
                          static_cast<double>(b.tick_median_us), static_cast<double>(b.tick_p99_us),
                          static_cast<double>(b.tick_max_us), static_cast<long long>(b.allocations),
                          realtime_name(b.realtime));
}

const char* guard_word(const StackMonitor& seen, std::int64_t now_ns) {
  if (seen.guard().age(now_ns) > 1.0) return "silent";
  return seen.newest_guard().verdict >= GuardVerdict::kWillCollide ? "holds joints" : "clear";
}

// What a world that waits costs; empty for every other.
std::string pace_text(const StackMonitor& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  if (active == nullptr || !has_pace(active->status, Pace::kPatient) || !(seen.figures().realtime_factor > 0.0)) return "";
  return formatted(", %.2f times real time", seen.figures().realtime_factor);
}

using Lines = std::vector<std::string>;

void add_sources(const StackMonitor& seen, std::int64_t now_ns, Lines& lines) {
  if (seen.sources(now_ns).empty()) return;
  lines.push_back("source            Hz      role  term   missed   late  rejected");
  for (const SeenSource* source : seen.sources(now_ns)) lines.push_back(source_line(*source, now_ns));
}

void add_streams(const StackMonitor& seen, std::int64_t now_ns, Lines& lines) {
  lines.push_back("stream            Hz       age    lost");
  lines.push_back(stream_line("STATE", seen.state(), now_ns));
  lines.push_back(stream_line("COMMAND", seen.command(), now_ns));
  if (seen.guard().received() > 0) lines.push_back(stream_line("GUARD", seen.guard(), now_ns));
}

void add_processes(const StackMonitor& seen, CpuShare& shares, std::int64_t now_ns, Lines& lines) {
  if (seen.processes(now_ns).empty()) return;
  lines.push_back("process           Hz       pid cpu %   missed    p50    p99 max us alloc");
  for (const SeenProcess* process : seen.processes(now_ns))
    lines.push_back(process_line(*process, shares.recent(process->beat.pid, now_ns)));
}

void add_robot(const StackMonitor& seen, std::int64_t now_ns, Lines& lines) {
  if (!(seen.controller_statuses().age(now_ns) < 1.0)) return;
  const ControllerStatus& c = seen.controller();
  const std::string motion = motion_text(c);
  // -1 m: no foot carries, or there is none.
  const std::string margin =
      c.zmp_margin > -1.0F ? formatted(", ZMP margin %.1f mm", 1e3 * static_cast<double>(c.zmp_margin)) : std::string();
  lines.push_back(formatted("robot: mode %s%s%s%s, guard %s", label(c.mode), motion.empty() ? "" : ", ", motion.c_str(),
                            margin.c_str(), guard_word(seen, now_ns)) +
                  pace_text(seen, now_ns));
}

void add_timing(const StackMonitor& seen, std::int64_t now_ns, Lines& lines) {
  const SeenSource* active = seen.active(now_ns);
  for (const SeenProcess* process : seen.processes(now_ns)) {
    const Heartbeat& b = process->beat;
    if (active == nullptr || active->status.run_id != b.process_id || !(b.age_us > 0.0F)) continue;
    lines.push_back(
        formatted("STATE to COMMAND: median %.0f us, 99 %% within %.0f us; machine stood still for "
                  "%lld of the missed",
                  static_cast<double>(b.age_us), static_cast<double>(b.age_p99_us),
                  static_cast<long long>(b.ticks_stalled)));
  }
}

}  // namespace

std::vector<std::string> acting_lines(const StackMonitor& seen, std::int64_t now_ns) {
  Lines lines;
  const std::vector<const SeenSource*> sources = seen.sources(now_ns);
  const SeenSource* active = seen.active(now_ns);
  if (active == nullptr && !sources.empty()) {
    std::string names;
    for (const SeenSource* source : sources) {
      if (names.find(source_name(source->status.source)) != std::string::npos) continue;
      names += (names.empty() ? "" : ", ") + std::string(source_name(source->status.source));
    }
    lines.push_back("no source is active (" + names + "): ./twinbus switch sim, bridge or replay makes one active");
  }
  if (is_paused(seen, now_ns)) lines.push_back("the simulated world is paused: ./twinbus sim go");
  const bool fell = seen.figures().fell;
  if (fell) lines.push_back("the robot has fallen: ./twinbus sim reset puts a simulated one on its feet");
  if (!fell && active != nullptr && active->lies)
    lines.push_back("the robot lies: put it on its feet, then ./twinbus clear and ./twinbus mode balance; a stand-in robot: ./twinbus sim reset");
  for (const SeenSource* source : sources) {
    const SourceStatus& s = source->status;
    if (s.stop_kind != StopKind::kNone && !fell)
      lines.push_back(formatted("%s is stopped (%s) by %s: ./twinbus clear ends that",
                                source == active ? "the robot" : source_name(s.source), label(s.stop_kind),
                                label(s.stop_reason)));
    if (s.adaptor_status != 0)
      lines.push_back(formatted("the device of the %s fails: %s", source_name(s.source),
                                to_text(static_cast<Status>(s.adaptor_status))));
  }
  if (active != nullptr && !has_own_clock(seen, now_ns) && seen.command().age(now_ns) > 1.0)
    lines.push_back("nobody commands the robot: ./twinbus restart controller, or start one of your own");
  if (active != nullptr && !has_own_clock(seen, now_ns) && seen.guard().received() > 0 && seen.guard().age(now_ns) > 1.0)
    lines.push_back("the guard is silent: ./twinbus restart guard");
  for (std::string& line : lines) line = as_typed(std::move(line));
  return lines;
}

std::vector<std::string> table_lines(const StackMonitor& seen, CpuShare& shares, std::int64_t now_ns) {
  Lines lines = acting_lines(seen, now_ns);
  add_robot(seen, now_ns, lines);
  add_sources(seen, now_ns, lines);
  add_streams(seen, now_ns, lines);
  add_processes(seen, shares, now_ns, lines);
  add_timing(seen, now_ns, lines);
  return lines;
}

std::vector<std::string> short_lines(const StackMonitor& seen, CpuShare& shares, std::int64_t now_ns) {
  Lines lines = acting_lines(seen, now_ns);
  for (std::string& line : lines) line = "ACT: " + line;
  if (lines.empty() && !seen.sources(now_ns).empty()) lines.push_back("nothing needs acting on");
  add_robot(seen, now_ns, lines);
  add_sources(seen, now_ns, lines);
  add_processes(seen, shares, now_ns, lines);
  return lines;
}

std::string summary_line(const StackMonitor& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  return formatted("STATE %.1f Hz (%s, term %d, %s), COMMAND %.1f Hz, missed %lld, mode %s%s",
                   seen.state().rate(now_ns),
                   active == nullptr ? "no source" : source_name(active->status.source),
                   active == nullptr ? 0 : active->status.term,
                   active == nullptr ? "-" : label(active->status.role),
                   seen.command().rate(now_ns),
                   active == nullptr ? 0LL : static_cast<long long>(active->status.ticks_missed),
                   label(seen.controller().mode), seen.figures().fell ? ", FELL" : "") +
         pace_text(seen, now_ns);
}

}  // namespace twinbus::launcher
