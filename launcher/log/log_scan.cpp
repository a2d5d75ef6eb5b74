#include "launcher/log/log_scan.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "common/process/process.h"

namespace twinbus::inline launcher {

namespace {
constexpr std::int64_t kProgressEvery = 500'000'000;  // [ns]
constexpr std::int64_t kLookEvery = 256;              // events
}  // namespace

std::string damage_text(const LogDamage& damage) {
  if (damage.places == 0) return "";
  return std::to_string(damage.places) + (damage.places == 1 ? " place" : " places") +
         " of damage, " + std::to_string(damage.bytes) + " bytes stepped over" +
         (damage.cut ? "; the log ends in the middle of an event" : "");
}

std::int64_t first_time(LogReader& reader, const std::string& file) {
  LogEvent event;
  reader.go_to(0);
  if (!reader.next(event))
    throw std::runtime_error("log " + file + ": no event in it; is it an LCM log?");
  reader.go_to(0);
  return event.utime;
}

LogDamage scan_log(const std::string& file, double first_s, double last_s,
                   const std::function<bool(const LogEvent&)>& visit) {
  LogReader reader(file);
  const std::int64_t start = first_time(reader, file);
  const auto at_second = [start](double s) {
    return start + std::llround(1e6 * std::clamp(s, 0.0, 1e12));
  };
  if (first_s > 0.0) reader.seek(at_second(first_s));
  const bool to_the_end = last_s >= kWholeLog;
  const std::int64_t last = to_the_end ? 0 : at_second(last_s);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const std::int64_t from = reader.offset();
  std::int64_t events = 0, shown = monotonic_ns();
  LogEvent event;
  bool more = true;
  while (more && reader.next(event)) {
    if (!to_the_end && event.utime > last) break;
    more = visit(event);
    if (++events % kLookEvery != 0) continue;
    if (quit_requested()) throw std::runtime_error("ended by the user");
    if (!terminal || monotonic_ns() - shown < kProgressEvery) continue;
    shown = monotonic_ns();
    std::fprintf(stderr, "\r%3.0f %%  ",
                 1e2 * static_cast<double>(reader.offset() - from) /
                     static_cast<double>(reader.size() - from));
  }
  if (terminal) std::fprintf(stderr, "\r       \r");
  if (const std::string damage = damage_text(reader.damage()); !damage.empty()) {
    std::fprintf(stderr, "log %s: %s\n", file.c_str(), damage.c_str());
  }
  return reader.damage();
}

}  // namespace twinbus::launcher
