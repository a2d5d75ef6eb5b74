// How much of a CPU each process of this machine uses.

#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace twinbus::inline launcher {

// CPU time of a process since its start [s], all threads; negative if there is no such process here.
double cpu_seconds(std::int32_t pid);
// The same from the text of /proc/PID/stat, whose second field may hold blanks and brackets.
double cpu_seconds_in(const std::string& stat, double ticks_per_second);

class CpuShare {
 public:
  // Share of one CPU since begin() or the first question about this process; 0 before there is a measurement.
  double of(std::int32_t pid, std::int64_t now_ns);
  // The same over the last second or so, for a table that is drawn again and again.
  double recent(std::int32_t pid, std::int64_t now_ns);

 private:
  struct Sample {
    double seconds = 0.0;
    std::int64_t at_ns = 0;
  };
  struct Known {
    Sample first, window;
    double recent = 0.0;
  };
  Known& known(std::int32_t pid, const Sample& now);

  std::map<std::int32_t, Known> known_;
};

}  // namespace twinbus::launcher
