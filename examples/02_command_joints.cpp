// 02 Command joints: a whole controller in C++ with stock LCM.  It holds the posture it finds;
// `example_command_joints K RAD` moves joint K by so much and back.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <random>

#include "twinbus/joint_command_t.hpp"
#include "twinbus/robot_state_t.hpp"
#include "twinbus/source_status_t.hpp"

constexpr float kGains[][4] = {  // of hrp1s: first and last joint, kp [N m/rad], kd [N m s/rad]
    {0, 5, 15000, 300},   {6, 9, 3000, 60},   {10, 12, 600, 6}, {13, 18, 15000, 300}, {19, 22, 3000, 60},
    {23, 25, 600, 6}, {26, 28, 15000, 300}};
struct Controller {
  lcm::LCM bus;  // $LCM_DEFAULT_URL
  twinbus::joint_command_t command{};
  bool told = false;
  int joint = -1;
  double by = 0.0, start = 0.0;  // [rad]
  std::int64_t begin_ns = 0, stopped_ns = 0;
  void on_status(const lcm::ReceiveBuffer*, const std::string&, const twinbus::source_status_t* status) {
    const bool other = status->role == 2 && status->controller_id != 0 && status->controller_id != command.controller_id;
    if (other && !told) std::puts("command_joints: NOT OBEYED, another controller is; end it, then ./twinbus clear");
    told = other;
  }
  void on_state(const lcm::ReceiveBuffer*, const std::string&, const twinbus::robot_state_t* state) {
    if (begin_ns == 0) {
      begin_ns = stopped_ns = state->time_ns;
      std::memcpy(command.q, state->q, sizeof command.q);
      std::memcpy(command.tau, state->tau, sizeof command.tau);
      start = state->q[joint < 0 ? 0 : joint];
    }
    const double t = 1e-9 * static_cast<double>(state->time_ns - begin_ns);
    if (state->stop_kind != 1) stopped_ns = state->time_ns;  // a balanced stop: it rests by itself, then is held
    command.flags = state->time_ns > stopped_ns && state->time_ns - stopped_ns < 500000000 ? 1 : 0;
    if (joint >= 0 && state->stop_kind != 1) command.q[joint] = start + by * 0.5 * (1.0 - std::cos(0.5 * M_PI * t));
    command.tick = state->tick;  // which tick, source, term and robot this answers
    command.run_id = state->run_id, command.term = state->term;
    command.model_hash = state->model_hash, command.joint_count = state->joint_count;
    bus.publish("COMMAND", &command);
  }
};
int main(int argc, char** argv) {
  setenv("LCM_DEFAULT_URL", "udpm://239.255.76.67:17667?ttl=0", 0);
  Controller self;
  if (!self.bus.good()) return 1;
  if (argc == 3) self.joint = std::atoi(argv[1]) % 48, self.by = std::atof(argv[2]);
  for (const auto& [first, last, kp, kd] : kGains) {
    for (int j = static_cast<int>(first); j <= static_cast<int>(last); ++j) self.command.kp[j] = kp, self.command.kd[j] = kd;
  }
  self.command.controller_id = 1 + (std::random_device{}() & 0x7fffffff);
  self.bus.subscribe("STATE", &Controller::on_state, &self);
  self.bus.subscribe("SOURCE_STATUS", &Controller::on_status, &self);
  std::setvbuf(stdout, nullptr, _IOLBF, 0), std::puts("command_joints: ready");
  while (self.bus.handle() == 0) continue;
}
