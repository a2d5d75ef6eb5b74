#include "launcher/up/first_command.h"

#include <stdexcept>

#include "common/process/process.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kTellOfWaiting = 1.5;                  // [s]
constexpr double kPatience = 10.0, kUserPatience = 60.0;  // [s]
constexpr double kDevicePatience = 3.0;                  // a bridge tries again [s]
constexpr double kClearWithin = 2.0, kClearAgain = 0.15;  // [s]

double seconds_since(std::int64_t begin_ns) { return 1e-9 * static_cast<double>(monotonic_ns() - begin_ns); }

// A source whose device fails publishes no STATE to answer.
std::string device_fault(BusLink& bus) {
  for (const SeenSource* source : bus.seen().sources(monotonic_ns())) {
    const SourceStatus& status = source->status;
    if (status.adaptor_status == 0) continue;
    return std::string("the device of the ") + source_name(status.source) +
           " fails: " + to_text(static_cast<Status>(status.adaptor_status));
  }
  return "";
}

// Whoever has commanded nothing yet was stopped for that.
bool clear_early_stop(BusLink& bus) {
  bool cleared = false;
  for (const std::int64_t begin = monotonic_ns(); !quit_requested() && seconds_since(begin) < kClearWithin;) {
    bool stopped = false;
    for (const SeenSource* source : bus.seen().sources(monotonic_ns())) {
      const SourceStatus& status = source->status;
      if (status.stop_kind == StopKind::kNone || status.stop_reason != StopReason::kCommandTimeout) continue;
      if (status.commands_accepted > 0) continue;
      stopped = cleared = true;
      StopRequest request;
      request.kind = StopKind::kNone;
      request.reason = StopReason::kLauncher;
      request.stop_nonce = status.stop_nonce;
      bus.send(request);
    }
    if (!stopped) return cleared;
    bus.listen(kClearAgain);
  }
  return false;
}

}  // namespace

void wait_for_command(BusLink& bus, Supervisor& supervisor, const FirstCommand& first) {
  const bool own = first.log.empty();
  const double patience = own ? kUserPatience : kPatience;
  const std::int64_t begin = monotonic_ns();
  bool told = false;
  while (!quit_requested() && bus.seen().command().received() == 0) {
    bus.receive(0.02);
    if (!told && seconds_since(begin) > kTellOfWaiting) {
      told = true;
      first.say(formatted("no COMMAND yet: waits up to %.0f s for a controller%s", patience,
                          own ? " of your own, as examples/02_command_joints.py" : ""));
    }
    supervisor.watch(monotonic_ns());
    if (supervisor.broken()) throw std::runtime_error("a required process ended before the robot was running");
    const std::string fault = seconds_since(begin) > kDevicePatience ? device_fault(bus) : "";
    if (!fault.empty()) throw std::runtime_error(fault);
    if (seconds_since(begin) <= patience) continue;
    const std::string none = formatted("no COMMAND within %.0f s: ", patience);
    throw std::runtime_error(own ? none + "nobody answers STATE; start your controller before this stack or within that time "
                                          "(doc/controllers.md), or take a stack with ours (without --stack client)"
                                 : none + "the controller does not answer STATE (its output: " + first.log + ")");
  }
  if (own && !quit_requested() && clear_early_stop(bus)) first.say("the stop that waiting for your controller had caused is cleared");
}

}  // namespace twinbus::launcher
