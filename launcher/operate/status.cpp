// `./twinbus status`: who is there, rates, roles, terms, timing, once or live.

#include "launcher/commands/commands.h"

#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "launcher/bus/bus_health.h"
#include "launcher/bus/bus_link.h"
#include "launcher/bus/live_table.h"
#include "launcher/bus/redraw.h"
#include "lcmtypes/msg/labels.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kFirstLook = 0.2;  // who is there [s]
constexpr double kLookFor = 1.2;    // two rate windows [s]

nlohmann::ordered_json channels_json(const Heartbeat& b) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < static_cast<std::size_t>(b.channels); ++i) {
    all[heard_channel(b, i)] = {
        {"received", b.channel_received[i]},   {"age_ms", b.channel_age_ms[i]},
        {"jitter_us", b.channel_jitter_us[i]}, {"lost", b.channel_lost[i]},
        {"repeated", b.channel_repeated[i]},   {"rejected", b.channel_rejected[i]}};
  }
  return all;
}

nlohmann::ordered_json as_json(const StackMonitor& seen, std::int64_t now_ns) {
  nlohmann::ordered_json all;
  all["sources"] = nlohmann::ordered_json::array();
  for (const SeenSource* source : seen.sources(now_ns)) {
    const SourceStatus& s = source->status;
    all["sources"].push_back({{"source", source_name(s.source)},
                              {"run_id", s.run_id},
                              {"role", label(s.role)},
                              {"term", s.term},
                              {"rate", source->states.rate(now_ns)},
                              {"ticks_missed", s.ticks_missed},
                              {"commands_late", s.commands_late},
                              {"commands_rejected", s.commands_rejected},
                              {"clamped", s.clamped},
                              {"stop", label(s.stop_kind)},
                              {"controller_id", s.controller_id}});
  }
  const auto stream = [&](const Meter& meter) {
    return nlohmann::ordered_json{
        {"rate", meter.rate(now_ns)}, {"age_s", meter.age(now_ns)}, {"lost", meter.lost()}};
  };
  all["streams"] = {{"STATE", stream(seen.state())},
                    {"COMMAND", stream(seen.command())},
                    {"GUARD", stream(seen.guard())}};
  all["processes"] = nlohmann::ordered_json::array();
  for (const SeenProcess* process : seen.processes(now_ns)) {
    const Heartbeat& b = process->beat;
    all["processes"].push_back(
        {{"process", process_name(b.kind)}, {"pid", b.pid}, {"id", b.process_id}, {"rate", b.rate},
         {"tick_median_us", b.tick_median_us}, {"tick_p99_us", b.tick_p99_us}, {"tick_max_us", b.tick_max_us},
         {"wake_p99_us", b.wake_p99_us}, {"ticks_missed", b.ticks_missed}, {"ticks_stalled", b.ticks_stalled},
         {"age_us", b.age_us}, {"age_p99_us", b.age_p99_us}, {"allocations", b.allocations},
         {"realtime", realtime_name(b.realtime)}, {"hears", channels_json(b)}});
  }
  all["mode"] =
      seen.controller_statuses().received() > 0 ? label(seen.controller().mode) : "none";
  return all;
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
}

}  // namespace

int status_command(const std::vector<std::string>& words) {
  const Arguments arguments({"status", 0, 0, R"(
Shows what somebody has to act on, what the robot does, sources with role, term and rate, and the timing of each process's loop.
Exit status 1 if no source is heard.
  --all  also streams with rate and age, and how every channel that a process hears does: age, jitter, gaps, repetitions, refusals
  --watch  again and again, until Ctrl-C
  --json  for programs
  --prefix --url --allow)"}, words);
  BusLink bus = open_bus(arguments);
  Redraw redraw;
  CpuShare shares;
  bus.listen(kFirstLook);
  for (const SeenProcess* process : bus.seen().processes(monotonic_ns()))
    (void)shares.recent(process->beat.pid, monotonic_ns());  // a share needs two looks
  bus.listen(kLookFor);
  while (arguments.has("--watch") && !quit_requested()) {
    const std::vector<std::string> lines = table_lines(bus.seen(), shares, monotonic_ns());
    if (isatty(STDOUT_FILENO) != 0) {
      redraw.draw(lines);
    } else {
      std::printf("%s\n", summary_line(bus.seen(), monotonic_ns()).c_str());
      std::fflush(stdout);
    }
    bus.listen(0.5);
  }
  const std::int64_t now = monotonic_ns();
  if (arguments.has("--json")) {
    std::printf("%s\n", as_json(bus.seen(), now).dump(2).c_str());
  } else if (arguments.has("--all") && !arguments.has("--watch")) {
    print_lines(table_lines(bus.seen(), shares, now));
    print_lines(channel_lines(bus.seen().processes(now)));
  } else if (!arguments.has("--watch")) {
    print_lines(short_lines(bus.seen(), shares, now));
  }
  if (!bus.seen().sources(now).empty()) return 0;
  if (!arguments.has("--watch")) {
    print_typed(stderr, "status: no source is heard on %s; start one with ./twinbus up\n",
                 bus.url().c_str());
  }
  return 1;
}

}  // namespace twinbus::launcher
