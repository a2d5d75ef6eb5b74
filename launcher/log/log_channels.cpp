#include "launcher/log/log_channels.h"

#include <algorithm>
#include <sstream>

#include "common/process/arguments.h"
#include "common/text/closest_name.h"
#include "common/text/printable.h"
#include "launcher/log/log_scan.h"
#include "viewer_log/log/log_reader.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kTail = 16 << 20;  // that is searched for the last index [bytes]

// Adds what the last index of a part says, and what follows it.  False for a part without one, or one that another log
// was joined to.
bool add_part_from_index(LogReader& reader, int part, LogSummary& summary) {
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
      if (found) count_event(event, channels);
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

std::string where_they_are_listed(const std::string& file) { return " (./twinbus log info " + file + " lists them)"; }

}  // namespace

std::vector<std::string> parts_of(const std::string& text, char sign) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, sign);) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

void count_event(const LogEvent& event, ChannelCounts& channels) {
  auto found = channels.find(event.channel);
  if (found == channels.end()) found = channels.emplace(event.channel, ChannelCount{}).first;
  ++found->second.events;
  found->second.bytes += static_cast<std::int64_t>(event.data.size());
}

std::optional<LogSummary> summary_of_index(const std::string& file) {
  LogReader reader(file);
  LogSummary summary;
  summary.first_utime = first_time(reader, file);
  for (int part = 0; part < reader.parts(); ++part) {
    if (!add_part_from_index(reader, part, summary)) return {};
  }
  return summary;
}

std::vector<std::string> channels_of_log(const std::string& file) {
  ChannelCounts channels;
  if (std::optional<LogSummary> summary = summary_of_index(file)) {
    channels = std::move(summary->channels);
  } else {
    scan_log(file, 0.0, kWholeLog, [&](const LogEvent& event) {
      if (event.channel != kLogIndex) count_event(event, channels);
      return true;
    });
  }
  std::vector<std::string> names;
  for (const auto& [name, count] : channels) names.push_back(printable(name));
  return names;
}

std::string nothing_on(const std::string& tool, const std::string& channel, const std::string& file) {
  const std::vector<std::string> there = channels_of_log(file);
  if (std::find(there.begin(), there.end(), channel) != there.end())
    return tool + ": nothing on " + channel + " of " + file + " between --from and --to; ./twinbus log info " + file +
           " says how long it is";
  return tool + ": " + file + " has no channel '" + channel + "'" + suggestion(channel, there) + where_they_are_listed(file);
}

void require_channels(const std::string& tool, const std::vector<std::string>& names, const std::string& file) {
  const std::vector<std::string> there = channels_of_log(file);
  for (const std::string& name : names) {
    if (std::find(there.begin(), there.end(), name) == there.end())
      throw UsageError(nothing_on(tool, name, file));
  }
}

void require_prefix(const std::string& tool, const std::string& prefix, const std::string& file) {
  if (prefix.empty()) return;
  const std::vector<std::string> there = channels_of_log(file);
  if (std::any_of(there.begin(), there.end(), [&](const std::string& name) { return name.starts_with(prefix); })) return;
  throw UsageError(tool + ": no channel of " + file + " begins with --prefix '" + prefix + "'" + where_they_are_listed(file));
}

}  // namespace twinbus::launcher
