// The stand-in robot as a process of its own: own clock, own body, own watchdog; speaks
// bridge/adaptors/emulated_robot's datagrams on an abstract Unix socket.

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "common/process/ticker.h"
#include "sim/emulated_robot.h"
#include "sim/scene/settings.h"

namespace twinbus::inline sim {
namespace {

constexpr std::int64_t kGiveUpAfter = 5;  // periods behind; then the robot's time is let slip

class Socket {
 public:
  explicit Socket(const std::string& name)
      : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    sockaddr_un address;
    const socklen_t size = emulated::abstract_address(name, address);
    if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
      throw std::runtime_error(
          "socket '@" + name + "': " + std::strerror(errno) +
          "; is another emulated_robot running? Give this one another --socket");
    }
  }
  ~Socket() { ::close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // Takes every datagram that is waiting.
  void receive(EmulatedRobot& robot, std::int64_t now_ns) noexcept {
    alignas(emulated::CommandPacket) unsigned char data[sizeof(emulated::CommandPacket) + 1];
    emulated::CommandPacket packet;
    for (int i = 0; i < 100; ++i) {
      sockaddr_un from{};
      socklen_t from_size = 0;
      const ssize_t size = emulated::receive_waiting(socket_, data, from, from_size);
      if (size < 0) return;
      if (!emulated::unseal(data, static_cast<std::size_t>(size), packet) ||
          !robot.accept(packet, now_ns))
        continue;
      client_ = from;
      client_size_ = from_size;
    }
  }

  // To whoever last spoke to the robot; nobody hears it if nobody listens.
  void send(const emulated::StatePacket& packet) noexcept {
    if (client_size_ == 0) return;
    (void)::sendto(socket_, &packet, sizeof packet, MSG_DONTWAIT | MSG_NOSIGNAL,
                   reinterpret_cast<const sockaddr*>(&client_), client_size_);
  }

 private:
  int socket_;
  sockaddr_un client_{};
  socklen_t client_size_ = 0;
};

int run(int argc, char** argv) {
  std::string robot_name = "hrp1s", scene_name = "stand", name = emulated::kDefaultSocket;
  double clock_ppm = 80.0;
  double duration = 0.0;
  std::int64_t seed = 1;
  EmulatedRobotOptions device;
  std::string differences, start_pose;
  for (const auto& [key, value] : EmulatedRobot::differences())
    differences += "  " + key + "=" + value + "\n";
  Options parser("emulated_robot",
                 "A stand-in for a real robot: its own process, clock, watchdog and wrong body.\n\n"
                 "Differs from the nominal robot by\n" +
                     differences + "\nSettings of --set:\n" + settings_help());
  parser.text("--robot", "NAME_OR_DIR", robot_name, "robot");
  parser.positional("SCENE", scene_name, false,
                    "start pose, obstacles and settings; its motions are ignored");
  parser.text("--start-pose", "POSE", start_pose, "of the SRDF, in which the robot begins; default the scene's");
  parser.text("--socket", "NAME", name, "abstract Unix socket to listen on");
  parser.settings("--set", device.settings, "key=value, see above");
  parser.number("--watchdog", "S", device.watchdog, 0.001, 10.0,
                "without a command for so long it holds");
  parser.number("--hold", "S", device.hold, 0.0, 1e6, "after holding for so long it damps");
  parser.number("--clock-ppm", "PPM", clock_ppm, -1000.0, 1000.0, "its clock is so much slower");
  parser.number("--for", "S", duration, 0.0, 1e6, "ends after so long; 0: never");
  parser.integer("--seed", "N", seed, 0, 1'000'000'000, "of the sensor noise");
  parser.parse(argc, argv);
  device.settings.insert(device.settings.begin(), {"sensor.seed", std::to_string(seed)});

  Scene scene = load_scene(scene_name);
  if (!parser.given("--robot")) robot_name = scene.robot;
  const Model model = load_robot(robot_name);
  if (parser.given("--start-pose")) start_in(start_pose, model, scene);
  SimSettings checked;
  for (const auto& [key, value] : device.settings) {
    const std::string complaint = apply_setting(key, value, model.period(), checked);
    if (complaint.empty()) continue;
    std::fprintf(stderr, "emulated_robot: %s\n", complaint.c_str());
    return 2;
  }
  EmulatedRobot robot(model, scene, device);
  Socket socket(name);
  catch_quit_signals();
  std::string why;
  const RealTime real_time = enter_real_time(70, &why);
  std::printf("emulated_robot: %s in %s on socket '@%s', %s\n", model.name.c_str(),
              scene.name.c_str(), name.c_str(),
              real_time == RealTime::kNone ? why.c_str() : "real time");

  // Its own clock: another phase and a slightly different rate than anybody else's.
  const auto period_ns = static_cast<std::int64_t>(model.period_ns * (1.0 + 1e-6 * clock_ppm));
  Ticker ticker(period_ns, kGiveUpAfter);
  std::int64_t clock_ns = 0;
  emulated::StatePacket packet;
  while (!quit_requested() &&
         !(duration > 0.0 && 1e-9 * static_cast<double>(clock_ns) > duration)) {
    ticker.wait();
    clock_ns += model.period_ns;
    socket.receive(robot, clock_ns);
    robot.cycle(clock_ns, packet);
    socket.send(packet);
  }
  return 0;
}

}  // namespace
}  // namespace twinbus::sim

int main(int argc, char** argv) { return twinbus::run_process("emulated_robot", twinbus::run, argc, argv); }
