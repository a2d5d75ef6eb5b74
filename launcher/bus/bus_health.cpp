#include "launcher/bus/bus_health.h"

#include <algorithm>
#include <cstring>

#include "common/process/command_word.h"
#include "common/text/formatted.h"
#include "lcmtypes/bus/wire.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kEvery = 1'000'000'000;  // counts are compared after so long [ns]
constexpr std::int64_t kQuiet =
    10'000'000'000;                 // between two alarms of a process and a channel [ns]
constexpr std::int32_t kMany = 25;  // lost or refused in that time
constexpr std::int64_t kSettle = 5'000'000'000;  // a process and its channels begin [ns]
constexpr std::int32_t kJump =
    10;  // times more lost than received: the numbers of a new run, no loss
constexpr std::int32_t kBusy = 50;  // received in that time: it goes on, or something is wrong
constexpr std::int64_t kMost =
    10'000'000;  // more in that time were never counted: another's counter, or a forged one
constexpr std::int64_t kAfterOwnClock = 2'000'000'000;  // heartbeats still tell of it [ns]
constexpr float kSilence_ms = 250.0F;

// Since the last look, or -1 when no counter counts so.
std::int64_t since(std::int32_t now, std::int32_t before) {
  const std::int64_t more = std::int64_t{now} - before;
  return more <= kMost ? more : -1;
}

// The loop's own: a source that becomes active leaves its standby channel, and an operator may go home.
bool never_ends(const char* channel) {
  return std::strcmp(channel, "STATE") == 0 || std::strcmp(channel, "COMMAND") == 0 ||
         std::strcmp(channel, "GUARD") == 0;
}

std::string sentence(const Heartbeat& beat, std::size_t row, std::int64_t count,
                     const char* what) {
  return formatted("%s (pid %d): %lld messages on %s %s in the last second", process_name(beat.kind), beat.pid,
                   static_cast<long long>(count), heard_channel(beat, row), what);
}

}  // namespace

const char* heard_channel(const Heartbeat& beat, std::size_t row) {
  const auto table = channel_table();
  const auto i = static_cast<std::size_t>(beat.channel[row] - 1);
  return i < table.size() ? table[i].channel : "?";
}

std::vector<std::string> BusHealth::look(const std::vector<const SeenProcess*>& processes,
                                         std::int64_t now_ns, bool own_clock) {
  std::vector<std::string> alarms;
  if (own_clock) own_clock_ns_ = now_ns;
  own_clock = own_clock_ns_ != 0 && now_ns - own_clock_ns_ < kAfterOwnClock;
  for (const SeenProcess* process : processes) {
    const Heartbeat& beat = process->beat;
    for (std::size_t i = 0; i < static_cast<std::size_t>(beat.channels); ++i) {
      Row& row = rows_[{beat.process_id, beat.channel[i]}];
      if (row.since_ns == 0) row.since_ns = now_ns;
      const bool settled = now_ns - row.since_ns > kSettle;
      const bool may_tell = row.told_ns == 0 || now_ns - row.told_ns > kQuiet;
      const std::size_t before = alarms.size();
      const bool silent =
          !own_clock && row.busy && beat.channel_age_ms[i] > kSilence_ms && never_ends(heard_channel(beat, i));
      if (silent && !row.silent && may_tell) {
        alarms.push_back(formatted("%s (pid %d) hears nothing on %s any more", process_name(beat.kind), beat.pid,
                                   heard_channel(beat, i)));
      }
      row.silent = silent;
      if (row.looked_ns == 0 || now_ns - row.looked_ns >= kEvery) {
        const bool first = row.looked_ns == 0;
        const std::int64_t lost = since(beat.channel_lost[i], row.lost);
        const std::int64_t rejected = since(beat.channel_rejected[i], row.rejected);
        const std::int64_t received = since(beat.channel_received[i], row.received);
        // Only the loop's own channels: what a standby source misses, nobody acts on.
        const bool concerns = !first && settled && may_tell && !own_clock && never_ends(heard_channel(beat, i));
        if (concerns && lost >= kMany && lost <= kJump * std::max<std::int64_t>(received, 1))
          alarms.push_back(sentence(beat, i, lost, "are missing"));
        // A page shows what it takes for true; that it refuses the rest, as commands of a robot that is stopped, nobody acts on.
        if (concerns && rejected >= kMany && beat.kind != ProcessKind::kViewer)
          alarms.push_back(sentence(beat, i, rejected, "were refused"));
        if (!first && (received > 0 || !silent)) row.busy = received >= kBusy;
        row.looked_ns = now_ns;
        row.received = beat.channel_received[i];
        row.lost = beat.channel_lost[i];
        row.rejected = beat.channel_rejected[i];
      }
      if (alarms.size() > before) row.told_ns = now_ns;
    }
  }
  return alarms;
}

std::vector<std::string> channel_lines(const std::vector<const SeenProcess*>& processes) {
  std::vector<std::string> lines = {
      "process    hears               received    age ms jitter us     lost repeated rejected"};
  for (const SeenProcess* process : processes) {
    const Heartbeat& b = process->beat;
    for (std::size_t i = 0; i < static_cast<std::size_t>(b.channels); ++i) {
      if (b.channel_received[i] == 0 && b.channel_rejected[i] == 0) continue;
      lines.push_back(formatted("%-10s %-18s %9d %9.1f %9.0f %8d %8d %8d", process_name(b.kind), heard_channel(b, i),
                                b.channel_received[i], static_cast<double>(b.channel_age_ms[i]),
                                static_cast<double>(b.channel_jitter_us[i]), b.channel_lost[i], b.channel_repeated[i],
                                b.channel_rejected[i]));
    }
  }
  for (const char* line : {"since each process began; lost: numbers that never came, repeated: sent again on purpose,",
                           "rejected: of another run or robot, or malformed.  A few of each belong to a start; what matters is",
                           "whether they grow (./twinbus status --all again)."})
    lines.push_back(as_typed(line));
  return lines;
}

}  // namespace twinbus::launcher
