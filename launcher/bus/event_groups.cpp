#include "launcher/bus/event_groups.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kWhile = 60'000'000'000;  // [ns]
constexpr std::size_t kMostGroups = 500;  // a flood of invented sentences must not grow the map

}  // namespace

std::string without_numbers(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool digit = (c >= '0' && c <= '9') || c == '.';
    if (!digit) {
      out += c;
    } else if (out.empty() || out.back() != '#') {
      out += '#';
    }
  }
  return out;
}

std::vector<std::string> EventGroups::take(const std::vector<std::string>& events,
                                           std::int64_t now_ns) {
  std::vector<std::string> lines;
  for (auto at = groups_.begin(); at != groups_.end();) {
    Group& group = at->second;
    if (now_ns - group.since_ns < kWhile) {
      ++at;
      continue;
    }
    if (group.more == 0) {
      at = groups_.erase(at);
      continue;
    }
    const std::string times = group.more == 1 ? "once" : std::to_string(group.more) + " times";
    lines.push_back(group.last + " (" + times + " more in a minute)");
    group = {.since_ns = now_ns, .more = 0, .last = {}};
    ++at;
  }
  for (const std::string& event : events) {
    const std::string key = without_numbers(event);
    const auto found = groups_.find(key);
    if (found != groups_.end()) {
      ++found->second.more;
      found->second.last = event;
      continue;
    }
    if (groups_.size() < kMostGroups) groups_[key].since_ns = now_ns;
    lines.push_back(event);
  }
  return lines;
}

}  // namespace twinbus::launcher
