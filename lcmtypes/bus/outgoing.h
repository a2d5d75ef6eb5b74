// Requests of an operator, which are sent several times: what must not be lost with one datagram.

#pragma once

#include <cstdint>

#include "common/process/process.h"
#include "lcmtypes/bus/bus.h"

namespace twinbus::inline lcmtypes {

// A request with its addressing, sent several times under one sequence number.
template <class T>
struct Outgoing {
  T message{};
  int left = 0;
  void start(const T& next) {
    const std::int64_t sender = message.sender_id;
    const std::int32_t sequence = message.sequence + 1;
    message = next;
    message.sender_id = sender;
    message.sequence = sequence;
    left = kRepeats;
  }
  static constexpr int kRepeats = 5;  // same sequence
  // Once per cycle of who sends.
  void send(Bus& bus) {
    if (left == 0) return;
    --left;
    message.utime = wall_us();
    if (!bus.send(channel_of(message), message)) ++left;  // no room now: once more with the next cycle
  }
};

}  // namespace twinbus::lcmtypes
