// A process of the stack as the bus knows it: its id, what it sends, its heartbeat and what it tells people.

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include "common/process/options.h"
#include "common/process/process.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/node/pulse.h"

namespace twinbus::inline lcmtypes {

inline BusOptions bus_options(const CommonOptions& common) {
  return {.url = common.url, .prefix = common.prefix, .allow = {common.allow}};
}

inline std::int64_t id_or_random(const CommonOptions& common) {
  return common.id != 0 ? common.id : random_id();
}

class Node {
 public:
  // Throws like Bus.
  Node(const CommonOptions& common, ProcessKind kind, RealTime real_time = RealTime::kNone)
      : id_(id_or_random(common)), kind_(kind), bus_(bus_options(common)), pulse_(kind, id_, real_time) {}

  std::int64_t id() const noexcept { return id_; }
  Bus& bus() noexcept { return bus_; }
  Pulse& pulse() noexcept { return pulse_; }

  // Waits for a message and handles what has come.  Throws std::runtime_error when the network is gone.
  void receive(double timeout_s) {
    if (bus_.receive(timeout_s) < 0) throw std::runtime_error("the bus is gone");
  }

  // The bus counts what could not be sent, the heartbeat says it.
  template <class T>
  void send(const Channel<T>& channel, const T& message) noexcept {
    static_cast<void>(bus_.send(channel, message));
  }

  // A balanced stop, for this reason.
  void ask_for_a_stop(StopReason reason) noexcept {
    StopRequest stop;
    stop.utime = wall_us();
    stop.sender_id = id_;
    stop.sequence = ++stop_sequence_;
    stop.kind = StopKind::kBalanced;
    stop.reason = reason;
    send(channel::kStop, stop);
  }

  // An event with its text, severity and, where there is one, run and tick; the rest is written here.
  void tell(Event& event) noexcept {
    event.utime = wall_us();
    event.sender_id = id_;
    event.sequence = ++event_sequence_;
    event.kind = kind_;
    send(channel::kEvent, event);
  }
  void tell(int severity, const char* sentence, std::int64_t run_id = 0, std::int64_t tick = 0, std::int16_t code = 0) noexcept {
    Event event;
    event.code = code;
    event.run_id = run_id;
    event.tick = tick;
    event.severity = static_cast<std::int8_t>(severity);
    std::snprintf(event.text.data(), event.text.size(), "%s", sentence);
    tell(event);
  }

  // The heartbeat of now with what the bus counted; the process adds its own, then sends it.
  Heartbeat& beat() noexcept {
    Heartbeat& beat = pulse_.beat(monotonic_ns());
    const BusCounters& counters = bus_.counters();
    beat.messages_received = counters.received;
    beat.messages_rejected = counters.rejected;
    beat.messages_lost = counters.lost;
    beat.send_failures = static_cast<std::int32_t>(std::min<std::int64_t>(counters.send_failures, INT32_MAX));
    return beat;
  }
  void send_heartbeat(const Heartbeat& beat) noexcept { static_cast<void>(bus_.send_heartbeat(beat)); }

 private:
  std::int64_t id_;
  ProcessKind kind_;
  Bus bus_;
  Pulse pulse_;
  std::int32_t stop_sequence_ = 0, event_sequence_ = 0;
};

// The send of a JournalWriter.
struct SendPage {
  Node* node;
  void operator()(const JournalPage& page) const noexcept { node->send(channel::kJournal, page); }
};

}  // namespace twinbus::lcmtypes
