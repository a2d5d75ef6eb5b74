#include "launcher/up/shadow.h"

#include <stdexcept>

#include "common/process/process.h"

namespace twinbus::inline launcher {

namespace {
constexpr double kShadowTimeout = 10.0, kAskForShadow = 0.25;  // [s]
}

bool put_in_shadow(BusLink& bus, const Supervisor& supervisor, const std::string& name) {
  SourceRequest request;
  request.action = SourceAction::kStandbyShadow;
  request.policy = SwitchPolicy::kNow;
  for (const Supervised& one : supervisor.processes()) {
    if (one.process.name != name || one.child.empty()) continue;
    if (const SeenProcess* process = bus.seen().process_of_pid(one.child.front().pid()))
      request.run_id = request.target_run_id = process->beat.process_id;
  }
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && request.run_id != 0 && seconds_since(begin) < kShadowTimeout) {
    request.sequence = 0;  // a new one each time
    bus.send(request);
    bus.listen(kAskForShadow);
    const SeenSource* source = bus.seen().source(request.run_id);
    if (source != nullptr && source->status.role == Role::kStandbyShadow) return true;
  }
  if (quit_requested()) return false;
  throw std::runtime_error("'" + name + "' does not shadow the active source within 10 s");
}

}  // namespace twinbus::launcher
