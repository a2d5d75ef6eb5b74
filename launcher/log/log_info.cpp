// `log info`: channels, counts, rates and duration of a log; --check reads all of it.

#include <algorithm>
#include <cstdio>
#include <optional>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_doubts.h"
#include "launcher/log/log_gaps.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/log/log_index.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kEnd = 1.0;  // of a log, in which the newest TRUTH is looked for [s]

// Of the world that ran last: what it counted is in the end of the log.
std::string doubts_at_the_end(const LogSummary& summary, const std::string& file) {
  LogDoubts doubts;
  const double seconds = 1e-6 * static_cast<double>(summary.last_utime - summary.first_utime);
  (void)scan_log(file, std::max(0.0, seconds - kEnd), kWholeLog, [&](const LogEvent& event) {
    (void)doubts.add(event.channel, event.data);
    return true;
  });
  const bool simulated = std::any_of(summary.channels.begin(), summary.channels.end(),
                                     [](const auto& channel) { return channel.first.ends_with(channel::kTruth); });
  if (simulated && !doubts.heard()) return "no simulator is in the last second: whether it doubted a step shows with --check\n";
  return doubts.text();
}

void print(const LogSummary& summary, const LogGaps* gaps, const LogReader& log,
           const std::string& file) {
  const double seconds =
      1e-6 * (static_cast<double>(summary.last_utime) - static_cast<double>(summary.first_utime));
  std::int64_t events = 0;
  for (const auto& [name, c] : summary.channels) events += c.events;
  const std::string parts = log.parts() > 1 ? std::to_string(log.parts()) + " parts, " : "";
  std::printf("%s: %s%.1f s, %.1f MB, %lld events on %zu channels\n", file.c_str(), parts.c_str(),
              seconds, 1e-6 * static_cast<double>(log.size()), static_cast<long long>(events),
              summary.channels.size());
  if (const std::string whole = log_of_part(file); !whole.empty())
    std::printf("this is one part of %s, which stands for all of them\n", whole.c_str());
  std::printf("%-20s %-20s %10s %9s %10s%s\n", "channel", "type", "events", "Hz", "kB/s",
              gaps != nullptr ? "    missing" : "");
  for (const auto& [name, c] : summary.channels) {
    const ChannelInfo* info = find_channel(name.c_str());
    const double span = std::max(seconds, 1e-6);
    std::printf("%-20s %-20s %10lld %9.1f %10.1f", name.c_str(), info != nullptr ? info->type : "-",
                static_cast<long long>(c.events), static_cast<double>(c.events) / span,
                1e-3 * static_cast<double>(c.bytes) / span);
    if (gaps != nullptr) std::printf(" %10lld", static_cast<long long>(gaps->missing(name)));
    std::printf("\n");
  }
}

}  // namespace

int log_info(const std::vector<std::string>& words) {
  const Arguments arguments({"log info", 1, 1, R"(FILE
Channels, counts, rates and duration; of our own logs from their index, however long they are.
  --check  reads all: damage, checksums, missing ticks; exit status 1 if anything is wrong)"}, words);
  catch_quit_signals();
  const std::string file = arguments.word(0);
  if (!arguments.has("--check")) {
    if (const std::optional<LogSummary> summary = summary_of_index(file)) {
      print(*summary, nullptr, LogReader(file), file);
      std::printf("%s", doubts_at_the_end(*summary, file).c_str());
      std::printf("counted by the index of the log; damage in between shows with --check, which reads all\n");
      return 0;
    }
  }
  LogSummary summary;
  LogCheck check;
  LogGaps gaps;
  LogDoubts doubts;
  LogReader reader(file);
  summary.first_utime = first_time(reader, file);
  const bool thorough = arguments.has("--check");
  const LogDamage found = scan_log(file, 0.0, kWholeLog, [&](const LogEvent& event) {
    count_event(event, summary.channels);
    summary.last_utime = std::max(summary.last_utime, event.utime);
    (void)doubts.add(event.channel, event.data);
    if (thorough) {
      check.add(event);
      gaps.add(event);
    }
    return true;
  });
  print(summary, thorough ? &gaps : nullptr, reader, file);
  std::printf("%s", doubts.text().c_str());
  if (!thorough) return 0;
  const std::string damage = damage_text(found);
  std::printf("%s\n", damage.empty() ? "no damage" : damage.c_str());
  std::printf("checksums: %lld events as written, %lld changed, %lld gone\n",
              static_cast<long long>(check.checked()), static_cast<long long>(check.wrong()),
              static_cast<long long>(check.missing()));
  for (const std::int64_t place : check.places())
    std::printf("  changed: the event at byte %lld\n", static_cast<long long>(place));
  return damage.empty() && check.wrong() == 0 && check.missing() == 0 ? 0 : 1;
}

}  // namespace twinbus::launcher
