// Alarms from heartbeats: a process that loses or refuses messages of a channel, or no longer hears one that was busy.
//
// Looks only; whoever owns it says the sentences and puts them on EVENT.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "launcher/bus/stack_monitor.h"

namespace twinbus::inline launcher {

class BusHealth {
 public:
  // The newest heartbeats, a few times a second; new alarms, as sentences.  own_clock: the world is paused, slowed or hurried;
  // then nobody is asked to keep up, and silence says nothing.
  std::vector<std::string> look(const std::vector<const SeenProcess*>& processes,
                                std::int64_t now_ns, bool own_clock = false);

 private:
  struct Row {  // one channel of one process, a second ago
    std::int64_t since_ns = 0, looked_ns = 0, told_ns = 0;
    std::int32_t received = 0, lost = 0, rejected = 0;
    bool busy = false, silent = false;
  };
  std::map<std::pair<std::int64_t, int>, Row> rows_;
  std::int64_t own_clock_ns_ = 0;  // when the world kept no real time last
};

// One line per process and channel that it has heard: age, jitter, gaps, repetitions, refusals.
std::vector<std::string> channel_lines(const std::vector<const SeenProcess*>& processes);
// Of a row of a heartbeat; "?" for one that this program does not know.
const char* heard_channel(const Heartbeat& beat, std::size_t row);

}  // namespace twinbus::launcher
