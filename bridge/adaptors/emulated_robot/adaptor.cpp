// Hardware adaptor of the stand-in robot: an independent process with its own clock, to the bridge
// a robot like any other.
//
// Settings: device.socket=NAME (the robot's --socket).

#include <poll.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "bridge/adaptor/adaptor_abi.h"
#include "bridge/adaptors/emulated_robot/protocol.h"

namespace twinbus::inline bridge {

namespace {

using namespace emulated;

constexpr double kOpenTimeout = 3.0;  // [s]
constexpr double kHelloEvery = 0.1;
constexpr double kStalePeriods =
    2.5;  // a state this old is still the newest there is: clocks differ

std::int64_t now_ns() noexcept {
  timespec t;
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

template <class Array>
bool finite(const Array& numbers, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
}

}  // namespace

class EmulatedRobot final : public RobotAdaptor {
 public:
  ~EmulatedRobot() override { close(); }

  Status open(const Model& model, const AdaptorConfig& config) override {
    close();
    std::string name = kDefaultSocket;
    for (const auto& [key, value] : config.settings) {
      if (key != "device.socket") {
        std::fprintf(stderr,
                     "emulated_robot: unknown setting '%s': the nearest is 'device.socket'\n",
                     key.c_str());
        return Status::kUnsupported;
      }
      name = value;
    }
    count_ = static_cast<std::uint32_t>(model.bus_count());
    model_hash_ = model.hash;
    stale_ns_ = static_cast<std::int64_t>(kStalePeriods * model.period_ns);
    std::random_device random;
    session_ = (std::uint64_t{random()} << 32) | random();
    sequence_ = 0;
    newest_ = {};
    read_sequence_ = 0;

    socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket_ < 0) return Status::kDeviceError;
    sockaddr_un own{};
    own.sun_family = AF_UNIX;  // the kernel picks an abstract name
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own.sun_family) != 0)
      return fail_open();
    device_size_ = abstract_address(name, device_);
    const std::int64_t give_up_ns = now_ns() + static_cast<std::int64_t>(1e9 * kOpenTimeout);
    while (newest_.sequence == 0 && now_ns() < give_up_ns) {
      say_hello();
      wait(kHelloEvery);
      receive();
    }
    if (newest_.sequence == 0) {
      std::fprintf(stderr,
                   "emulated_robot: nobody answers on the socket '@%s'; start the program "
                   "emulated_robot first\n",
                   name.c_str());
      (void)fail_open();
      return Status::kTimeout;
    }
    if (newest_.model_hash != model_hash_ || newest_.joint_count != count_) {
      std::fprintf(
          stderr,
          "emulated_robot: the robot that answers is not a '%s'; start it with the same --robot\n",
          model.name.c_str());
      (void)fail_open();
      return Status::kWrongModel;
    }
    return Status::kOk;
  }

  Status read(RobotState& state, double timeout_s) override {
    if (socket_ < 0) return Status::kNotOpen;
    receive();
    const std::int64_t due_ns = now_ns() + static_cast<std::int64_t>(1e9 * timeout_s);
    while (newest_.sequence == read_sequence_ && now_ns() - newest_ns_ > stale_ns_) {
      const std::int64_t left_ns = due_ns - now_ns();
      if (left_ns <= 0) return Status::kTimeout;
      if (now_ns() - hello_ns_ > static_cast<std::int64_t>(1e9 * kHelloEvery)) say_hello();
      wait(1e-9 * static_cast<double>(left_ns));
      receive();
    }
    read_sequence_ = newest_.sequence;
    state.joint_count = static_cast<std::int16_t>(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      state.q[i] = newest_.q[i];
      state.qd[i] = newest_.qd[i];
      state.tau[i] = newest_.tau[i];
    }
    state.attitude = newest_.attitude;
    state.gyro = newest_.gyro;
    state.accel = newest_.accel;
    state.wrench = newest_.wrench;
    for (std::size_t i = 0; i < state.wrench_kind.size(); ++i)
      state.wrench_kind[i] = static_cast<WrenchKind>(newest_.wrench_kind[i]);
    state.sensor_flags = newest_.sensor_flags;
    state.enabled = newest_.enabled;
    state.source_time_ns = newest_.device_time_ns;
    return Status::kOk;
  }

  Status write(const JointCommand& command) override {
    if (socket_ < 0) return Status::kNotOpen;
    if (command.joint_count != static_cast<std::int16_t>(count_)) return Status::kWrongSize;
    CommandPacket packet;
    packet.kind = CommandKind::kDrive;
    packet.q = command.q;
    packet.qd = command.qd;
    packet.tau = command.tau;
    packet.kp = command.kp;
    packet.kd = command.kd;
    return send(packet);
  }

  Status fall_safe() override {
    if (socket_ < 0) return Status::kNotOpen;
    CommandPacket packet;
    packet.kind = CommandKind::kDamp;
    return send(packet);
  }

  void close() override {
    if (socket_ < 0) return;
    ::close(socket_);
    socket_ = -1;
  }

 private:
  Status fail_open() {
    close();
    return Status::kDeviceError;
  }

  Status send(CommandPacket& packet) noexcept {
    packet.sequence = ++sequence_;
    packet.session = session_;
    packet.model_hash = model_hash_;
    packet.joint_count = count_;
    seal(packet);
    // A full queue means that the robot does not listen; its own watchdog decides.
    return ::sendto(socket_, &packet, sizeof packet, MSG_DONTWAIT | MSG_NOSIGNAL,
                    reinterpret_cast<const sockaddr*>(&device_),
                    device_size_) == static_cast<ssize_t>(sizeof packet)
               ? Status::kOk
               : Status::kDeviceError;
  }

  // So that a robot switched on after us knows whom to tell.
  void say_hello() noexcept {
    hello_ns_ = now_ns();
    CommandPacket hello;
    hello.kind = CommandKind::kHello;
    (void)send(hello);
  }

  bool from_device(const sockaddr_un& from, socklen_t size) const noexcept {
    return size == device_size_ && std::memcmp(&from, &device_, size) == 0;
  }

  void wait(double seconds) noexcept {
    pollfd poll{socket_, POLLIN, 0};
    timespec t;
    t.tv_sec = static_cast<time_t>(seconds);
    t.tv_nsec = static_cast<long>(1e9 * (seconds - static_cast<double>(t.tv_sec)));
    (void)::ppoll(&poll, 1, &t, nullptr);
  }

  // Empties the socket; the newest whole state wins.
  void receive() noexcept {
    StatePacket packet;
    alignas(StatePacket) unsigned char data[sizeof(StatePacket) + 1];
    for (int i = 0; i < 1000; ++i) {
      sockaddr_un from{};
      socklen_t from_size = 0;
      const ssize_t size = receive_waiting(socket_, data, from, from_size);
      if (size < 0) return;
      if (!from_device(from, from_size)) continue;
      if (!unseal(data, static_cast<std::size_t>(size), packet) || packet.joint_count > kJoints)
        continue;
      if (!finite(packet.q, packet.joint_count) || !finite(packet.qd, packet.joint_count) ||
          !finite(packet.tau, packet.joint_count)) {
        continue;
      }
      // A robot that was switched off and on counts from the start again.
      if (packet.sequence <= newest_.sequence && packet.device_time_ns <= newest_.device_time_ns &&
          newest_.sequence - packet.sequence < 100) {
        continue;
      }
      newest_ = packet;
      newest_ns_ = now_ns();
    }
  }

  int socket_ = -1;
  std::uint32_t count_ = 0;
  std::int64_t model_hash_ = 0;
  std::int64_t stale_ns_ = 0;
  sockaddr_un device_{};
  socklen_t device_size_ = 0;
  std::int64_t hello_ns_ = 0;
  std::uint64_t session_ = 0, sequence_ = 0, read_sequence_ = 0;
  std::int64_t newest_ns_ = 0;
  StatePacket newest_;
};

}  // namespace twinbus::bridge

TWINBUS_ADAPTOR(twinbus::EmulatedRobot)
