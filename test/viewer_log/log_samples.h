// Logs in memory for tests: events of known sizes, and which of them a reader gives back.

#pragma once

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "viewer_log/log/log_reader.h"
#include "viewer_log/log/log_writer.h"

namespace twinbus {

struct SampleLog {
  std::vector<std::uint8_t> bytes;
  std::vector<std::size_t> begins;  // of each event, then the end
};

// Events numbered from 0 as lcm-logger does; data of random bytes, now and then with a mark inside.
inline SampleLog sample_log(int events, std::uint32_t seed = 1,
                            std::int64_t first_utime = 1'000'000) {
  std::mt19937 random(seed);
  SampleLog log;
  const char* channels[] = {"STATE", "COMMAND", "GUARD", "EVENT"};
  for (int i = 0; i < events; ++i) {
    std::vector<std::uint8_t> data(20 + random() % 300);
    for (auto& byte : data) byte = static_cast<std::uint8_t>(random());
    if (i % 7 == 3) write_u32(data.data() + 5, kEventMark);
    log.begins.push_back(log.bytes.size());
    append_event(log.bytes, first_utime + 2000 * i, channels[i % 4], data);
    write_i64(log.bytes.data() + log.begins.back() + 4, i);
  }
  log.begins.push_back(log.bytes.size());
  return log;
}

// The events that come back byte for byte, by their place in the sample.
inline std::set<int> recovered(const SampleLog& log, std::span<const std::uint8_t> damaged,
                               LogDamage* damage = nullptr) {
  std::set<std::string> there;
  LogReader reader(damaged);
  for (LogEvent event; reader.next(event);) there.insert({event.bytes.begin(), event.bytes.end()});
  if (damage != nullptr) *damage = reader.damage();
  std::set<int> found;
  for (std::size_t i = 0; i + 1 < log.begins.size(); ++i) {
    const auto begin = log.bytes.begin() + static_cast<std::ptrdiff_t>(log.begins[i]);
    const auto end = log.bytes.begin() + static_cast<std::ptrdiff_t>(log.begins[i + 1]);
    if (there.count({begin, end}) != 0) found.insert(static_cast<int>(i));
  }
  return found;
}

}  // namespace twinbus
