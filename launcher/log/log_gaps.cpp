#include "launcher/log/log_gaps.h"

#include <algorithm>
#include <array>
#include <span>

#include "lcmtypes/bus/older.h"
#include "lcmtypes/bus/wire.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kMostCounted = std::int64_t{1} << 53;  // ticks of a run, pages of a journal

struct Counted {
  const char *channel, *count, *sender;
  bool of_a_run;  // and not of a process, whatever it answers
};
constexpr Counted kCounted[] = {{"STATE", "tick", "run_id", true},
                                {"COMMAND", "tick", "controller_id", true},
                                {"GUARD", "tick", "guard_id", true},
                                {"CONTROLLER_STATUS", "tick", "controller_id", true},
                                {"TRUTH", "tick", "run_id", true},
                                {"ESTIMATE", "tick", "run_id", true},
                                {"JOURNAL", "page", "process_id", false}};

}  // namespace

LogGaps::Columns LogGaps::columns_of(std::string_view channel) {
  for (const Counted& one : kCounted) {
    if (channel != one.channel) continue;
    const MessageSchema* schema = find_schema(find_channel(one.channel)->type);
    const auto field = [&](const char* name) -> const MessageField* {
      const int found = schema->find(name);
      return found < 0 ? nullptr : &schema->fields[static_cast<std::size_t>(found)];
    };
    return {schema, field(one.count), field(one.sender), one.of_a_run ? field("run_id") : nullptr,
            channel == "STATE" ? field("term") : nullptr};
  }
  return {};
}

// What was said for the holder before it says nothing of what is said from now on, though the same run may come back.
void LogGaps::see_holder(std::int64_t run, std::int64_t term) {
  if (run == holder_ && term == term_) return;
  holder_ = run;
  term_ = term;
  std::erase_if(last_, [](const auto& one) { return std::get<0>(one.first) != "JOURNAL"; });
}

void LogGaps::add(const LogEvent& event) {
  auto found = columns_.find(event.channel);
  if (found == columns_.end()) found = columns_.emplace(event.channel, columns_of(event.channel)).first;
  const Columns& c = found->second;
  std::array<std::uint8_t, kLargestMessage> room;
  const std::span<const std::uint8_t> data = renewed(event.data, room);
  if (c.schema == nullptr || data.size() != c.schema->bytes) return;
  const std::int64_t count = field_integer(*c.count, data);
  const std::int64_t sender = field_integer(*c.sender, data);
  const std::int64_t run = c.run != nullptr ? field_integer(*c.run, data) : 0;
  // So many nobody has sent: a forged or a damaged one says nothing of what is missing.
  if (count < 0 || count >= kMostCounted) return;
  if (c.term != nullptr) see_holder(run, field_integer(*c.term, data));
  const auto [last, is_new] = last_.try_emplace(std::tuple(std::string(event.channel), sender, run), count);
  if (!is_new && count > last->second + 1) missing_[std::string(event.channel)] += count - last->second - 1;
  last->second = std::max(last->second, count);
}

std::int64_t LogGaps::missing(const std::string& channel) const {
  const auto found = missing_.find(channel);
  return found == missing_.end() ? 0 : found->second;
}

}  // namespace twinbus::launcher
