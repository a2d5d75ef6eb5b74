#include "launcher/live_table.h"

#include <cstdarg>
#include <cstdio>

#include "robot/status.h"

namespace twinbus {

namespace {

__attribute__((format(printf, 1, 2))) std::string line_of(const char* format, ...) {
  char text[160];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string age_text(double seconds) {
  if (seconds > 1e6) return "never";
  return seconds < 1.0 ? line_of("%.1f ms", 1e3 * seconds) : line_of("%.1f s", seconds);
}

std::string stream_line(const char* name, const Meter& meter, std::int64_t now_ns) {
  return line_of("  %-18s %8.1f Hz %10s %10lld lost", name, meter.rate(now_ns), age_text(meter.age(now_ns)).c_str(),
                 static_cast<long long>(meter.lost()));
}

std::string source_line(const SeenSource& source, std::int64_t now_ns) {
  const SourceStatus& s = source.status;
  std::string line = line_of("  %-10s %-9s %4d %8.1f Hz %7lld missed %6lld late %6lld rejected", source_name(s.source),
                             role_name(s.role), s.term, source.states.rate(now_ns), static_cast<long long>(s.ticks_missed),
                             static_cast<long long>(s.commands_late), static_cast<long long>(s.commands_rejected));
  if (s.stop_kind != StopKind::kNone) line += std::string("  STOP ") + stop_name(s.stop_kind);
  if (s.adaptor_status != 0) line += std::string("  ") + to_text(static_cast<Status>(s.adaptor_status));
  return line;
}

std::string process_line(const SeenProcess& process) {
  const Heartbeat& b = process.beat;
  return line_of("  %-10s %7d %8.1f Hz %7.0f %7.0f %7.0f us %7lld missed %4lld alloc  %s", process_name(b.kind), b.pid,
                 static_cast<double>(b.rate), static_cast<double>(b.tick_median_us), static_cast<double>(b.tick_p99_us),
                 static_cast<double>(b.tick_max_us), static_cast<long long>(b.ticks_missed),
                 static_cast<long long>(b.allocations), realtime_name(b.realtime));
}

}  // namespace

std::vector<std::string> table_lines(const Lookout& seen, std::int64_t now_ns) {
  std::vector<std::string> lines;
  lines.push_back("source     role      term     rate");
  for (const SeenSource* source : seen.sources(now_ns)) lines.push_back(source_line(*source, now_ns));
  lines.push_back("stream                 rate        age");
  lines.push_back(stream_line("STATE", seen.state(), now_ns));
  lines.push_back(stream_line("COMMAND", seen.command(), now_ns));
  if (seen.guard().received() > 0) lines.push_back(stream_line("GUARD", seen.guard(), now_ns));
  lines.push_back("process        pid     rate    median     p99     max");
  for (const SeenProcess* process : seen.processes(now_ns)) lines.push_back(process_line(*process));
  if (seen.controller_statuses().age(now_ns) < 1.0) {
    const ControllerStatus& c = seen.controller();
    lines.push_back(line_of("controller: mode %s, ZMP margin %.1f mm, guard %s", mode_name(c.mode),
                            1e3 * static_cast<double>(c.zmp_margin),
                            seen.guard().age(now_ns) > 1.0                                       ? "silent"
                            : seen.newest_guard().verdict >= GuardVerdict::kWillCollide ? "holds joints"
                                                                                                 : "clear"));
  }
  return lines;
}

std::string summary_line(const Lookout& seen, std::int64_t now_ns) {
  const SeenSource* active = seen.active(now_ns);
  return line_of("STATE %.1f Hz (%s, term %d, %s), COMMAND %.1f Hz, missed %lld, mode %s%s", seen.state().rate(now_ns),
                 active == nullptr ? "no source" : source_name(active->status.source),
                 active == nullptr ? 0 : active->status.term, active == nullptr ? "-" : role_name(active->status.role),
                 seen.command().rate(now_ns), active == nullptr ? 0LL : static_cast<long long>(active->status.ticks_missed),
                 mode_name(seen.controller().mode), seen.figures().fell ? ", FELL" : "");
}

void Redraw::clear() {
  if (lines_ > 0) std::printf("\x1b[%zuA\x1b[J", lines_);
  lines_ = 0;
}

void Redraw::draw(const std::vector<std::string>& lines) {
  clear();
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  lines_ = lines.size();
}

}  // namespace twinbus
