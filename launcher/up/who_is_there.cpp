#include "launcher/up/who_is_there.h"

#include <algorithm>

#include "launcher/bus/bus_link.h"

namespace twinbus::inline launcher {

std::string who_is_in_the_way(const StackMonitor& seen, const Stack& stack, std::int64_t now_ns) {
  std::string who;
  if (const auto sources = seen.sources(now_ns); !sources.empty()) who = describe(*sources.front());
  const auto starts = [&stack](const std::string& program) {
    return std::any_of(stack.processes.begin(), stack.processes.end(),
                       [&](const StackProcess& one) { return one.program == program; });
  };
  for (const SeenProcess* process : seen.processes(now_ns)) {
    const ProcessKind kind = process->beat.kind;
    const bool is_source = kind == ProcessKind::kSimulator || kind == ProcessKind::kBridge ||
                           kind == ProcessKind::kReplay;
    const bool is_control = kind == ProcessKind::kController || kind == ProcessKind::kGuard ||
                            kind == ProcessKind::kPlanner;
    if (is_source || (is_control && starts(std::string("twinbus_") + process_name(kind))))
      who =
          std::string(process_name(kind)) + " with process id " + std::to_string(process->beat.pid);
  }
  if (who.empty() && seen.state().received() > 0) who = "an unknown sender on STATE";
  if (who.empty() && seen.command().received() > 0 && starts("twinbus_controller"))
    who = "an unknown sender on COMMAND";
  return who;
}

}  // namespace twinbus::launcher
