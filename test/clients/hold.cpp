// A whole controller in C++ with stock LCM: holds the posture it finds, with the torque that held
// it.
//
//   hold [FIRST-LAST:KP:KD,...]
//
// Knows STATE and COMMAND and nothing else; nothing of twinbus but the message types.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <random>

#include "twinbus/joint_command_t.hpp"
#include "twinbus/robot_state_t.hpp"

namespace {

constexpr char kHrp1s[] =
    "0-5:15000:300,6-9:3000:60,10-12:600:6,13-18:15000:300,19-22:3000:60,23-25:600:6,26-28:15000:"
    "300";

struct Hold {
  lcm::LCM* bus = nullptr;
  twinbus::joint_command_t command{};
  bool holding = false;

  void on_state(const lcm::ReceiveBuffer*, const std::string&,
                const twinbus::robot_state_t* state) {
    if (!holding) {
      holding = true;
      std::memcpy(command.q, state->q, sizeof command.q);
      std::memcpy(command.tau, state->tau, sizeof command.tau);
      std::printf("hold: holding %d joints\n", state->joint_count);
      std::fflush(stdout);
    }
    // Which tick, source, term and robot this answers.
    command.tick = state->tick;
    command.run_id = state->run_id;
    command.term = state->term;
    command.model_hash = state->model_hash;
    command.joint_count = state->joint_count;
    bus->publish("COMMAND", &command);
  }
};

bool read_gains(const char* text, twinbus::joint_command_t& command) {
  while (*text != '\0') {
    int first = 0, last = 0, used = 0;
    float kp = 0, kd = 0;
    if (std::sscanf(text, "%d-%d:%f:%f%n", &first, &last, &kp, &kd, &used) != 4 || first < 0 ||
        last > 47) {
      return false;
    }
    for (int joint = first; joint <= last; ++joint) {
      command.kp[joint] = kp;
      command.kd[joint] = kd;
    }
    text += used;
    if (*text == ',') ++text;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Hold hold;
  if (!read_gains(argc > 1 ? argv[1] : kHrp1s, hold.command)) {
    std::fprintf(stderr, "usage: hold [FIRST-LAST:KP:KD,...], joints 0-47\n");
    return 2;
  }
  const char* url = std::getenv("LCM_DEFAULT_URL");
  lcm::LCM bus(url != nullptr ? url : "udpm://239.255.76.67:17667?ttl=0");
  if (!bus.good()) return 1;
  std::random_device random;
  hold.command.controller_id =
      1 + ((static_cast<std::int64_t>(random()) << 20) ^ random()) % (std::int64_t{1} << 52);
  hold.bus = &bus;
  bus.subscribe("STATE", &Hold::on_state, &hold);
  std::printf("hold: ready\n");
  std::fflush(stdout);
  while (bus.handle() == 0) {
  }
  return 1;
}
