// 01 Listen: prints time, load of the feet and a joint of whatever robot is active, in C++ with stock LCM.
//
//   ./twinbus up               (in another terminal)
//   build/release/bin/example_listen [SECONDS]

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>

#include "twinbus/robot_state_t.hpp"

struct Listener {
  std::int64_t printed_ns = 0;

  void on_state(const lcm::ReceiveBuffer*, const std::string&,
                const twinbus::robot_state_t* state) {
    if (state->time_ns - printed_ns < 100'000'000 && state->time_ns >= printed_ns) return;
    printed_ns = state->time_ns;
    const char* sources[] = {"?", "simulator", "bridge", "replay"};
    const float load = state->wrench[0][2] + state->wrench[1][2];  // of both soles [N]
    std::printf("%8.3f s  %s, tick %lld, term %d, %d joints, q[3] %+.4f rad, feet %.0f N\n",
                1e-9 * static_cast<double>(state->time_ns), sources[state->source & 3],
                static_cast<long long>(state->tick), state->term, state->joint_count, state->q[3],
                static_cast<double>(load));
    std::fflush(stdout);
  }
};

int main(int argc, char** argv) {
  const char* url = std::getenv("LCM_DEFAULT_URL");
  lcm::LCM bus(url != nullptr ? url : "udpm://239.255.76.67:17667?ttl=0");
  if (!bus.good()) return 1;
  Listener listener;
  bus.subscribe("STATE", &Listener::on_state, &listener);
  using Clock = std::chrono::steady_clock;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 1e9;
  const auto begin = Clock::now();
  while (std::chrono::duration<double>(Clock::now() - begin).count() < seconds) {
    if (bus.handleTimeout(1000) == 0) std::puts("no robot is heard");
  }
}
