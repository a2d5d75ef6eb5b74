// A HEARTBEAT as it is on the bus: with a row for each channel that its process listens to.
//
// Processes fill in a Heartbeat; the bus, which alone hears every message, adds the rows.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/reports.h"

namespace twinbus {

inline constexpr std::size_t kHeardChannels = 12;

struct FullHeartbeat : Heartbeat {
  template <class T>
  using PerChannel = std::array<T, kHeardChannels>;

  std::int8_t channels = 0;           // rows in use
  PerChannel<std::int8_t> channel{};  // row of the table in lcmtypes/bus/wire.cpp, from 1
  PerChannel<std::int32_t> channel_received{};
  PerChannel<std::int32_t> channel_lost{};      // gaps in ticks or sequences of one sender
  PerChannel<std::int32_t> channel_repeated{};  // the same tick or sequence again
  PerChannel<std::int32_t> channel_rejected{};  // wrong size, type or numbers, or not admitted
  PerChannel<float> channel_age_ms{};           // of the newest
  PerChannel<float> channel_jitter_us{};        // of the time between two
};

}  // namespace twinbus
