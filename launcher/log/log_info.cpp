#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <tuple>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/log/log_command.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/log/log_index.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus {

namespace {

constexpr std::int64_t kTail = 16 << 20;  // that is searched for the last index [bytes]

constexpr std::int64_t kMostCounted = std::int64_t{1} << 53;  // ticks of a run, pages of a journal

struct Summary {
  ChannelCounts channels;
  std::int64_t first_utime = 0, last_utime = 0;
  bool from_index = false;
};

void count(const LogEvent& event, ChannelCounts& channels) {
  auto found = channels.find(event.channel);
  if (found == channels.end()) found = channels.emplace(event.channel, ChannelCount{}).first;
  ++found->second.events;
  found->second.bytes += static_cast<std::int64_t>(event.data.size());
}

// Adds what the last index of a part says, and what follows it.  False for a part without one, or one that another log
// was joined to.
bool add_part_from_index(LogReader& reader, int part, Summary& summary) {
  const std::int64_t begin = reader.part_begin(part), end = reader.part_end(part);
  reader.go_to(begin);
  LogEvent event;
  if (!reader.next(event)) return false;
  const std::int64_t first_utime = event.utime;
  reader.go_to(std::max(begin, end - kTail));
  bool found = false;
  ChannelCounts channels;
  while (reader.offset() < end && reader.next(event) && event.offset < end) {
    summary.last_utime = std::max(summary.last_utime, event.utime);
    if (event.channel != kLogIndex) {
      if (found) count(event, channels);
      continue;
    }
    std::optional<LogIndex> index = decode_index(event.data);
    found = index.has_value() && index->offset == event.offset_in_part &&
            index->first_utime == first_utime;
    if (found) channels = std::move(index->channels);
  }
  for (const auto& [name, of_part] : channels) {
    ChannelCount& sum = summary.channels[name];
    sum.events += of_part.events;
    sum.bytes += of_part.bytes;
  }
  return found;
}

std::optional<Summary> from_index(const std::string& file) {
  LogReader reader(file);
  Summary summary;
  summary.first_utime = first_time(reader, file);
  for (int part = 0; part < reader.parts(); ++part) {
    if (!add_part_from_index(reader, part, summary)) return {};
  }
  summary.from_index = true;
  return summary;
}

// Ticks and sequences that a sender of a channel must have sent and the log does not have.
class Gaps {
 public:
  void add(const LogEvent& event) {
    auto found = columns_.find(event.channel);
    if (found == columns_.end())
      found = columns_.emplace(event.channel, columns_of(event.channel)).first;
    const Columns& c = found->second;
    if (c.schema == nullptr || event.data.size() != c.schema->bytes) return;
    const std::int64_t count = field_integer(*c.count, event.data);
    const std::int64_t sender = field_integer(*c.sender, event.data);
    // So many nobody has sent: a forged or a damaged one says nothing of what is missing.
    if (count < 0 || count >= kMostCounted) return;
    const auto [last, is_new] =
        last_.try_emplace(std::tuple(std::string(event.channel), sender), count);
    if (!is_new && count > last->second + 1)
      missing_[std::string(event.channel)] += count - last->second - 1;
    last->second = std::max(last->second, count);
  }
  std::int64_t missing(const std::string& channel) const {
    const auto found = missing_.find(channel);
    return found == missing_.end() ? 0 : found->second;
  }

 private:
  struct Columns {
    const MessageSchema* schema = nullptr;
    const MessageField* count = nullptr;
    const MessageField* sender = nullptr;
  };
  static Columns columns_of(std::string_view channel) {
    constexpr std::tuple<const char*, const char*, const char*> kCounted[] = {
        {"STATE", "tick", "run_id"},   {"COMMAND", "tick", "controller_id"},
        {"GUARD", "tick", "guard_id"}, {"CONTROLLER_STATUS", "tick", "controller_id"},
        {"TRUTH", "tick", "run_id"},   {"ESTIMATE", "tick", "run_id"},
          {"JOURNAL", "page", "process_id"}};
    for (const auto& [name, count, sender] : kCounted) {
      if (channel != name) continue;
      const MessageSchema* schema = find_schema(find_channel(name)->type);
      return {schema, &schema->fields[static_cast<std::size_t>(schema->find(count))],
              &schema->fields[static_cast<std::size_t>(schema->find(sender))]};
    }
    return {};
  }
  std::map<std::string, Columns, std::less<>> columns_;
  std::map<std::tuple<std::string, std::int64_t>, std::int64_t> last_;
  std::map<std::string, std::int64_t> missing_;
};

void print(const Summary& summary, const Gaps* gaps, const LogReader& log,
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
  const Arguments arguments(
      {"log info",
       "FILE",
       "Channels, counts, rates and duration; of our own logs from their index, however long they "
       "are.",
       {{"--check", "",
         "reads all: damage, checksums, missing ticks; exit status 1 if anything is wrong"}},
       1,
       1},
      words);
  catch_quit_signals();
  const std::string file = arguments.word(0);
  if (!arguments.has("--check")) {
    if (const std::optional<Summary> summary = from_index(file)) {
      print(*summary, nullptr, LogReader(file), file);
      std::printf("counted by the index of the log; damage in between shows with --check, which reads all\n");
      return 0;
    }
  }
  Summary summary;
  LogCheck check;
  Gaps gaps;
  LogReader reader(file);
  summary.first_utime = first_time(reader, file);
  const bool thorough = arguments.has("--check");
  const LogDamage found = scan_log(file, 0.0, kWholeLog, [&](const LogEvent& event) {
    count(event, summary.channels);
    summary.last_utime = std::max(summary.last_utime, event.utime);
    if (thorough) {
      check.add(event);
      gaps.add(event);
    }
    return true;
  });
  print(summary, thorough ? &gaps : nullptr, reader, file);
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

}  // namespace twinbus
