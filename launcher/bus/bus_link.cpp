#include "launcher/bus/bus_link.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/labels.h"

namespace twinbus::inline launcher {

namespace {

BusOptions options_of(const std::string& url, const std::string& prefix,
                      const std::vector<std::string>& allow) {
  BusOptions options;
  if (!url.empty()) options.url = url;
  options.prefix = prefix;
  options.allow = allow;
  return options;
}

}  // namespace

struct BusLink::Impl {
  Impl(const BusOptions& options, StackMonitor& seen) : bus(options) {
    bus.listen<&StackMonitor::on_state>(channel::kState, seen);
    for (const Channel<RobotState>& own : {channel::kStateSim, channel::kStateBridge, channel::kStateReplay})
      bus.listen<&StackMonitor::on_standby_state>(own, seen);
    bus.listen<&StackMonitor::on_estimate>(channel::kEstimate, seen);
    bus.listen<&StackMonitor::on_command>(channel::kCommand, seen);
    bus.listen<&StackMonitor::on_source_status>(channel::kSourceStatus, seen);
    bus.listen<&StackMonitor::on_heartbeat>(channel::kHeartbeat, seen);
    bus.listen<&StackMonitor::on_truth>(channel::kTruth, seen);
    bus.listen<&StackMonitor::on_guard>(channel::kGuard, seen);
    bus.listen<&StackMonitor::on_controller_status>(channel::kControllerStatus, seen);
    bus.listen<&StackMonitor::on_event>(channel::kEvent, seen);
  }

  void operator()(const char*, std::span<const std::uint8_t> bytes, std::int64_t) const {
    if (raw_state) raw_state(bytes);
  }

  template <class T>
  void send(const Channel<T>& channel, const T& message) {
    if (!bus.send(channel, message)) {
      throw std::runtime_error(
          std::string("cannot send on ") + channel.name +
          ": no route, or a number that is not fit to send; try ./twinbus doctor");
    }
  }

  std::function<void(std::span<const std::uint8_t>)> raw_state;
  Bus bus;
};

BusLink::BusLink(const std::string& url, const std::string& prefix,
                 const std::vector<std::string>& allow)
    : sender_id_(random_id()), sequence_(static_cast<std::int32_t>(sender_id_ & 0x3fffffff)) {
  const BusOptions options = options_of(url, prefix, allow);
  url_ = options.url;
  impl_ = std::make_unique<Impl>(options, seen_);
}

BusLink::~BusLink() = default;

void BusLink::receive(double seconds) {
  if (impl_->bus.receive(seconds) < 0)
    throw std::runtime_error("the bus is gone: the network was taken down");
}

void BusLink::listen(double seconds) {
  const std::int64_t end = monotonic_ns() + static_cast<std::int64_t>(seconds * 1e9);
  for (std::int64_t now = monotonic_ns(); now < end && !quit_requested(); now = monotonic_ns()) {
    receive(std::min(0.05, 1e-9 * static_cast<double>(end - now)));
  }
}

void BusLink::on_raw_state(std::function<void(std::span<const std::uint8_t>)> handler) {
  const bool first = !impl_->raw_state;
  impl_->raw_state = std::move(handler);
  if (first) impl_->bus.listen_raw(channel::kState, *impl_);
}

template <class T>
void BusLink::stamp(T& message) {
  message.utime = wall_us();
  message.sender_id = sender_id_;
  if (message.sequence == 0) message.sequence = ++sequence_;
}

template <class T>
void BusLink::send(T& message) {
  stamp(message);
  impl_->send(channel_of(message), message);
}
template void BusLink::send(SourceRequest&);
template void BusLink::send(ControllerRequest&);
template void BusLink::send(ModeRequest&);
template void BusLink::send(StopRequest&);
template void BusLink::send(WalkCommand&);
template void BusLink::send(StepList&);
template void BusLink::send(MotionPiece&);
template void BusLink::send(SimRequest&);
template void BusLink::send(ArmGoal&);
template void BusLink::send(Gamepad&);

void BusLink::alarm(const std::string& sentence) { tell(sentence, 2); }

void BusLink::tell(const std::string& sentence, int severity) {
  Event event;
  event.run_id = seen_.newest_state().run_id;
  event.tick = seen_.newest_state().tick;
  event.severity = static_cast<std::int8_t>(severity);
  event.kind = ProcessKind::kLauncher;
  std::snprintf(event.text.data(), event.text.size(), "%s", sentence.c_str());
  stamp(event);
  impl_->send(channel::kEvent, event);
}

BusOptions bus_options(const Arguments& arguments) {
  return options_of(arguments.text("--url", ""), arguments.text("--prefix", ""), arguments.all("--allow"));
}

BusLink open_bus(const Arguments& arguments) {
  catch_quit_signals();
  return BusLink(arguments.text("--url", ""), arguments.text("--prefix", ""),
                 arguments.all("--allow"));
}

const SeenSource* wait_for_active(BusLink& bus, double seconds) {
  // Everyone publishes SOURCE_STATUS at 10 Hz, so a quarter of a second hears all who are there.
  const std::int64_t start = monotonic_ns();
  for (;;) {
    bus.listen(0.25);
    const SeenSource* active = bus.seen().active(monotonic_ns());
    if (active != nullptr || quit_requested()) return active;
    if (1e-9 * static_cast<double>(monotonic_ns() - start) > seconds) return nullptr;
  }
}

const SeenSource& active_source(BusLink& bus) {
  const SeenSource* active = wait_for_active(bus, 1.0);
  if (active == nullptr) {
    std::string parked;
    for (const SeenSource* source : bus.seen().sources(monotonic_ns())) parked += (parked.empty() ? "" : ", ") + std::string(source_name(source->status.source));
    throw std::runtime_error("no source is active on " + bus.url() +
                             (parked.empty() ? "; start one with ./twinbus up" : "; parked: " + parked + "; ./twinbus switch NAME makes one active"));
  }
  return *active;
}

std::string describe(const SeenSource& source) {
  return std::string(source_name(source.status.source)) + " run " +
         std::to_string(source.status.run_id) + " (term " + std::to_string(source.status.term) +
         ", " + label(source.status.role) + ")";
}

}  // namespace twinbus::launcher
