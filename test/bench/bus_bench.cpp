// How long the bus takes: STATE sent to COMMAND received through another process, memq, and the
// cost of sending; with plain LCM (its C++ class, default queue, a new message each time) in the
// same minute as the peer.
//
//   bus_bench [--csv F] [--samples N] [--rate HZ]
//
// Prints bench,case,metric,unit,median,p99,p999,max,peer,peer_median,ratio.  Uses ports of its own,
// so a running stack is not disturbed.

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "test/lcmtypes/samples.h"
#include "twinbus/joint_command_t.hpp"
#include "twinbus/robot_state_t.hpp"

using namespace twinbus;

namespace {

constexpr char kOurs[] = "udpm://239.255.76.67:17693?ttl=0&recv_buf_size=4194304";
constexpr char kPeers[] = "udpm://239.255.76.67:17694?ttl=0&recv_buf_size=4194304";
constexpr char kPeerName[] = "lcm C++ class";

struct Figures {
  double median, p99, p999, max;  // [us]
};

Figures figures(std::vector<double>& us) {
  if (us.empty()) throw std::runtime_error("nothing came back");
  std::sort(us.begin(), us.end());
  const auto at = [&](double share) {
    return us[std::min(us.size() - 1,
                       static_cast<std::size_t>(share * static_cast<double>(us.size())))];
  };
  return {at(0.5), at(0.99), at(0.999), us.back()};
}

double us_since(std::int64_t start_ns) {
  return 1e-3 * static_cast<double>(monotonic_ns() - start_ns);
}

// Two processes speak over udpm: this one sends STATE, the other answers with COMMAND.

[[noreturn]] void our_echo() {
  Bus bus({.url = kOurs, .prefix = "", .allow = {}});
  Latest<RobotState> newest;
  bus.listen(channel::kState, newest);
  RobotState state;
  JointCommand command = sample<JointCommand>();
  for (;;) {
    bus.receive(1.0);
    if (!newest.take(state)) continue;
    command.tick = state.tick;
    (void)bus.send(channel::kCommand, command);
  }
}

struct OurSide {
  Bus bus{{.url = kOurs, .prefix = "", .allow = {}}};
  Latest<JointCommand> newest;
  RobotState state = sample<RobotState>();
  JointCommand command;
  OurSide() {
    state.tick = 0;
    bus.listen(channel::kCommand, newest);
  }
  // [us], or below zero if no answer came in 50 ms.
  double round_trip() {
    ++state.tick;
    const std::int64_t start = monotonic_ns();
    (void)bus.send(channel::kState, state);
    while (us_since(start) < 50000) {
      bus.receive(0.01);
      if (newest.take(command) && command.tick == state.tick) return us_since(start);
    }
    return -1;
  }
};

struct PeerEcho {
  lcm::LCM* bus;
  void on_state(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* state) {
    joint_command_t command{};
    command.tick = state->tick;
    bus->publish("COMMAND", &command);
  }
};

[[noreturn]] void peer_echo() {
  lcm::LCM bus(kPeers);
  PeerEcho echo{&bus};
  bus.subscribe("STATE", &PeerEcho::on_state, &echo);
  while (bus.handle() == 0) {
  }
  _exit(1);
}

struct PeerSide {
  lcm::LCM bus{kPeers};
  robot_state_t state{};
  std::int64_t answered = 0;
  PeerSide() { bus.subscribe("COMMAND", &PeerSide::on_command, this); }
  void on_command(const lcm::ReceiveBuffer*, const std::string&, const joint_command_t* command) {
    answered = command->tick;
  }
  double round_trip() {
    ++state.tick;
    const std::int64_t start = monotonic_ns();
    bus.publish("STATE", &state);
    while (us_since(start) < 50000) {
      bus.handleTimeout(10);
      if (answered == state.tick) return us_since(start);
    }
    return -1;
  }
};

pid_t start(void (*echo)()) {
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("cannot fork");
  if (pid > 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    echo();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bus_bench: %s\n", error.what());
  }
  _exit(1);
}

// In turns of 200, so that both meet the same load of the machine.
template <class Ours, class Peers>
std::pair<Figures, Figures> in_turns(int samples, double rate, Ours&& ours, Peers&& peers) {
  std::vector<double> our_us, peer_us;
  std::int64_t due = monotonic_ns();
  const auto pause = [&] {
    if (rate <= 0) return;
    due = std::max(due + static_cast<std::int64_t>(1e9 / rate), monotonic_ns());
    sleep_until_ns(due);
  };
  for (int done = 0; done < samples; done += 200) {
    for (int i = 0; i < 200; ++i, pause()) {
      if (const double us = ours(); us >= 0) our_us.push_back(us);
    }
    for (int i = 0; i < 200; ++i, pause()) {
      if (const double us = peers(); us >= 0) peer_us.push_back(us);
    }
  }
  return {figures(our_us), figures(peer_us)};
}

class Table {
 public:
  explicit Table(const std::string& csv)
      : file_(csv.empty() ? nullptr : std::fopen(csv.c_str(), "w")) {
    if (!csv.empty() && file_ == nullptr) throw std::runtime_error("cannot write " + csv);
    line("bench,case,metric,unit,median,p99,p999,max,peer,peer_median,ratio");
  }
  ~Table() {
    if (file_ != nullptr) std::fclose(file_);
  }
  void row(const char* name, const char* metric, const std::pair<Figures, Figures>& both) {
    const auto& [f, peer] = both;
    char text[256];
    std::snprintf(text, sizeof text, "bus,%s,%s,us,%.2f,%.2f,%.2f,%.2f,%s,%.2f,%.2f", name, metric,
                  f.median, f.p99, f.p999, f.max, kPeerName, peer.median, f.median / peer.median);
    line(text);
  }

 private:
  void line(const char* text) {
    std::puts(text);
    std::fflush(stdout);
    if (file_ != nullptr) std::fprintf(file_, "%s\n", text);
  }
  std::FILE* file_;
};

std::pair<Figures, Figures> in_memory(int samples) {
  Bus bus({.url = "memq://", .prefix = "", .allow = {}});
  Latest<RobotState> newest;
  bus.listen(channel::kState, newest);
  RobotState state = sample<RobotState>();
  lcm::LCM peer("memq://");
  struct Sink {
    std::int64_t tick = 0;
    void on_state(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* s) {
      tick = s->tick;
    }
  } sink;
  peer.subscribe("STATE", &Sink::on_state, &sink);
  robot_state_t message{};
  return in_turns(
      samples, 0,
      [&] {
        ++state.tick;
        const std::int64_t start = monotonic_ns();
        (void)bus.send(channel::kState, state);
        bus.receive(0);
        return us_since(start);
      },
      [&] {
        ++message.tick;
        const std::int64_t start = monotonic_ns();
        peer.publish("STATE", &message);
        peer.handleTimeout(0);
        return us_since(start);
      });
}

}  // namespace

int main(int argc, char** argv) try {
  std::string csv;
  std::int64_t asked = 5000;
  double rate = 500;
  Options options("bus_bench", "STATE to COMMAND through another process.");
  options.text("--csv", "F", csv, "also as rows");
  options.integer("--samples", "N", asked, 1, 100'000'000, "of each");
  options.number("--rate", "HZ", rate, 1e-3, 1e6, "of those that are paced");
  options.parse(argc, argv);
  const int samples = static_cast<int>(asked);

  const pid_t echoes[] = {start(our_echo), start(peer_echo)};
  Table table(csv);
  {
    OurSide ours;
    PeerSide peers;
    for (int i = 0; i < 100; ++i) ours.round_trip(), peers.round_trip();  // both echoes are up
    const auto our_trip = [&] { return ours.round_trip(); };
    const auto peer_trip = [&] { return peers.round_trip(); };
    table.row("udpm paced", "state_to_command", in_turns(samples, rate, our_trip, peer_trip));
    table.row("udpm back to back", "state_to_command", in_turns(samples, 0, our_trip, peer_trip));
    table.row("udpm", "send_state",
              in_turns(
                  samples, rate,
                  [&] {
                    ++ours.state.tick;
                    const std::int64_t start = monotonic_ns();
                    (void)ours.bus.send(channel::kState, ours.state);
                    const double us = us_since(start);
                    ours.bus.receive(0);
                    return us;
                  },
                  [&] {
                    ++peers.state.tick;
                    const std::int64_t start = monotonic_ns();
                    peers.bus.publish("STATE", &peers.state);
                    const double us = us_since(start);
                    peers.bus.handleTimeout(0);
                    return us;
                  }));
  }
  table.row("memq", "send_and_receive", in_memory(samples));
  for (const pid_t pid : echoes) {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bus_bench: %s\n", error.what());
  return 1;
}
