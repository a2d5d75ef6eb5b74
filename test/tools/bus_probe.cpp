// A small process on the bus for tests: sends numbered STATE messages, listens to the usual
// channels, and at its end prints what it counted as one line of JSON.
//
//   bus_probe [--url URL] [--prefix P] [--allow A] [--send N] [--rate HZ] [--run-id R] [--term T]
//   [--for S]
//
// It ends after --for seconds, or on a signal.  With --send it sends N states at --rate.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "common/process/process.h"
#include "lcmtypes/msg/state_admission.h"
#include "test/lcmtypes/samples.h"
#include "common/allocation/no_alloc.h"
#include "test/tools/bus_options.h"

using namespace twinbus;

namespace {

struct Arguments {
  BusOptions bus;
  long send = 0;
  double rate = 500.0;    // [Hz]
  double duration = 1e9;  // [s]
  std::int64_t run_id = 77;
  int term = 1;
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    if (take_bus_option(argc, argv, i, arguments.bus)) continue;
    const std::string name = argv[i];
    if (i + 1 >= argc) throw std::invalid_argument(name + ": unknown, or needs a value");
    const char* value = argv[++i];
    if (name == "--send")
      arguments.send = std::atol(value);
    else if (name == "--rate")
      arguments.rate = std::atof(value);
    else if (name == "--for")
      arguments.duration = std::atof(value);
    else if (name == "--run-id")
      arguments.run_id = std::atoll(value);
    else if (name == "--term")
      arguments.term = std::atoi(value);
    else
      throw std::invalid_argument(name + ": unknown");
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse(argc, argv);
  catch_quit_signals();
  Bus bus(arguments.bus);

  StateAdmission admission;
  const auto admit = [&](const RobotState& candidate, const RobotState&) noexcept {
    return admission.admit(candidate, monotonic_ns());
  };
  Latest<RobotState> state;
  state.admit_by(admit);
  Latest<JointCommand> command;
  Slots<Heartbeat> heartbeats;
  long stops = 0;
  const auto on_stop = [&](const StopRequest&) noexcept { ++stops; };
  bus.listen(channel::kState, state);
  bus.listen(channel::kCommand, command);
  bus.listen(channel::kHeartbeat, heartbeats);
  bus.listen(channel::kStop, on_stop);
  std::printf("ready\n");
  std::fflush(stdout);

  RobotState mine = sample<RobotState>();
  mine.run_id = arguments.run_id;
  mine.term = arguments.term;
  mine.grant_run_id = 0;
  const std::int64_t period = static_cast<std::int64_t>(1e9 / arguments.rate);
  const std::int64_t start = monotonic_ns();
  const std::int64_t end = start + static_cast<std::int64_t>(1e9 * arguments.duration);
  std::int64_t due = start;
  std::int64_t allocations = -1;
  for (long n = 0; !quit_requested() && monotonic_ns() < end; ++n) {
    if (n < arguments.send) {
      mine.tick = n + 1;
      (void)bus.send(channel::kState, mine);
    }
    if (n == 200) allocations = thread_allocations();
    due += period;
    for (std::int64_t left = due - monotonic_ns(); left > 0; left = due - monotonic_ns()) {
      (void)bus.receive(1e-9 * static_cast<double>(left));
    }
  }
  allocations = allocations < 0 || !allocations_counted() ? -1 : thread_allocations() - allocations;

  const BusCounters& c = bus.counters();
  std::printf(
      "{\"received\": %lld, \"rejected\": %lld, \"lost\": %lld, \"repeated\": %lld, "
      "\"sent\": %lld, \"send_failures\": %lld, \"dropped\": %lld, \"stops\": %ld, "
      "\"states\": %lld, \"run_id\": %lld, \"ignored\": %lld, \"allocations\": %lld}\n",
      static_cast<long long>(c.received), static_cast<long long>(c.rejected),
      static_cast<long long>(c.lost), static_cast<long long>(c.repeated),
      static_cast<long long>(c.sent), static_cast<long long>(c.send_failures),
      static_cast<long long>(bus.dropped_datagrams()), stops,
      static_cast<long long>(state.received), static_cast<long long>(admission.run_id()),
      static_cast<long long>(admission.ignored()), static_cast<long long>(allocations));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bus_probe: %s\n", error.what());
  return dynamic_cast<const std::invalid_argument*>(&error) != nullptr ? 2 : 1;
}
