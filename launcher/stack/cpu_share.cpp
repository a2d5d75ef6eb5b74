#include "launcher/stack/cpu_share.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace twinbus::inline launcher {

namespace {

constexpr double kWindow = 1.0;  // [s]

double share(double seconds, std::int64_t span_ns) {
  return span_ns > 0 && seconds > 0.0 ? 1e9 * seconds / static_cast<double>(span_ns) : 0.0;
}

}  // namespace

double cpu_seconds_in(const std::string& stat, double ticks_per_second) {
  const std::size_t name_end = stat.rfind(')');
  if (name_end == std::string::npos || !(ticks_per_second > 0.0)) return -1.0;
  std::istringstream fields(stat.substr(name_end + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;  // state ... cmajflt
  double user = 0.0, system = 0.0;
  if (!(fields >> user >> system)) return -1.0;
  return (user + system) / ticks_per_second;
}

double cpu_seconds(std::int32_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  const std::string stat{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return cpu_seconds_in(stat, static_cast<double>(sysconf(_SC_CLK_TCK)));
}

CpuShare::Known& CpuShare::known(std::int32_t pid, const Sample& now) {
  return known_.try_emplace(pid, Known{now, now, 0.0}).first->second;
}

double CpuShare::of(std::int32_t pid, std::int64_t now_ns) {
  const Sample now{cpu_seconds(pid), now_ns};
  if (now.seconds < 0.0) return 0.0;
  const Known& past = known(pid, now);
  return share(now.seconds - past.first.seconds, now_ns - past.first.at_ns);
}

double CpuShare::recent(std::int32_t pid, std::int64_t now_ns) {
  const Sample now{cpu_seconds(pid), now_ns};
  if (now.seconds < 0.0) return 0.0;
  Known& past = known(pid, now);
  if (1e-9 * static_cast<double>(now_ns - past.window.at_ns) >= kWindow) {
    past.recent = share(now.seconds - past.window.seconds, now_ns - past.window.at_ns);
    past.window = now;
  }
  return past.recent;
}

}  // namespace twinbus::launcher
