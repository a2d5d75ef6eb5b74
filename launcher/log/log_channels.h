// The channels that a log has, and what is said of one that it has not.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viewer_log/log/log_index.h"

namespace twinbus::inline launcher {

struct LogSummary {
  ChannelCounts channels;
  std::int64_t first_utime = 0, last_utime = 0;  // [us]
};

// From the indexes of its parts, however long it is; nothing for a log without them, or one that another was joined to.
// Throws std::runtime_error when there is no event in it.
std::optional<LogSummary> summary_of_index(const std::string& file);

// What is there between the signs, as in "STATE,COMMAND"; nothing between two of them is left out.
std::vector<std::string> parts_of(const std::string& text, char sign);

void count_event(const LogEvent& event, ChannelCounts& channels);

// From the index, else all of it is read.  Throws std::runtime_error when there is no event in it.
std::vector<std::string> channels_of_log(const std::string& file);

// "TOOL: LOG has no channel 'STAET'; did you mean STATE? (...)", or, of a channel that it has, "... nothing on STATE between
// --from and --to", with the command that lists channels and duration.
std::string nothing_on(const std::string& tool, const std::string& channel, const std::string& file);

// Throws UsageError, as nothing_on says it, for the first of the names that is no channel of the log.
void require_channels(const std::string& tool, const std::vector<std::string>& names, const std::string& file);

// Throws UsageError when no channel of the log begins with the prefix; an empty one is always there.
void require_prefix(const std::string& tool, const std::string& prefix, const std::string& file);

}  // namespace twinbus::launcher
