// What goes over the wire between the stand-in robot (sim/emulated_robot_main.cpp) and its adaptor.
//
// Two datagrams of fixed size over an abstract Unix socket of this machine (and network namespace):
// the robot sends a StatePacket every cycle of its own clock to whoever last spoke to it, the
// adaptor sends CommandPackets.  Each carries a magic number, the version, a sequence number and a
// CRC-32 of everything before the CRC; whatever does not fit is dropped and counted.  Not LCM: a
// robot does not speak it either.

#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace twinbus::inline bridge::emulated {

inline constexpr std::uint32_t kCommandMagic = 0x31435245;  // "ERC1"
inline constexpr std::uint32_t kStateMagic = 0x31535245;    // "ERS1"
inline constexpr std::uint16_t kVersion = 2;
inline constexpr int kJoints = 48, kWrenches = 8;
inline constexpr char kDefaultSocket[] = "twinbus/emulated_robot";

enum class CommandKind : std::uint16_t {
  kHello = 1,    // send me your state
  kDrive = 2,    // obey these numbers; the first one switches the servos on
  kRelease = 3,  // servos off: the robot holds its posture on its brakes
  kDamp = 4,     // torque off but for damping, until the next kDrive
};

// What the robot does with its motors.
enum class DeviceMode : std::uint16_t {
  kBraked = 1,   // servos off, holding a posture by itself
  kDriven = 2,   // obeying
  kHolding = 3,  // watchdog: no command for too long, holding the last set-point
  kDamping = 4,  // watchdog for longer still, or asked for
};

struct CommandPacket {
  std::uint32_t magic = kCommandMagic;
  std::uint16_t version = kVersion;
  CommandKind kind = CommandKind::kHello;
  std::uint64_t sequence = 0;  // counts up from 1; an old one is dropped
  std::uint64_t session = 0;   // random, drawn at open; a new one starts a new sequence
  std::int64_t model_hash = 0;
  std::uint32_t joint_count = 0;
  std::uint32_t spare = 0;
  std::array<double, kJoints> q{};  // torque = tau + kp (q - q_measured) + kd (qd - qd_measured)
  std::array<float, kJoints> qd{}, tau{}, kp{}, kd{};
  std::uint32_t pad = 0;
  std::uint32_t crc = 0;
};

struct StatePacket {
  std::uint32_t magic = kStateMagic;
  std::uint16_t version = kVersion;
  DeviceMode mode = DeviceMode::kBraked;
  std::uint64_t sequence = 0;         // cycles since the robot was switched on
  std::uint64_t command_session = 0;  // of the newest command obeyed
  std::uint64_t command_sequence = 0;
  std::int64_t device_time_ns = 0;  // the robot's own clock
  std::int64_t model_hash = 0;
  std::int64_t enabled = 0;   // bit per joint: servo on
  std::uint64_t dropped = 0;  // datagrams that were not for it or damaged
  std::uint32_t joint_count = 0;
  std::int32_t sensor_flags = 0;
  std::array<double, kJoints> q{};
  std::array<float, kJoints> qd{}, tau{};
  std::array<float, 4> attitude{1, 0, 0, 0};
  std::array<float, 3> gyro{}, accel{};
  std::array<std::array<float, 6>, kWrenches> wrench{};
  std::array<std::int8_t, kWrenches> wrench_kind{};
  std::uint32_t pad = 0;
  std::uint32_t crc = 0;
};

// CRC-32 of Ethernet (reflected 0x04c11db7).
inline std::uint32_t crc32(const void* data, std::size_t size) noexcept {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
      table[i] = c;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffU;
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) crc = kTable[(crc ^ bytes[i]) & 0xffU] ^ (crc >> 8);
  return ~crc;
}

template <class Packet>
void seal(Packet& packet) noexcept {
  packet.crc = crc32(&packet, offsetof(Packet, crc));
}

// Copies a datagram into packet if size, magic, version and CRC are right.
template <class Packet>
bool unseal(const void* data, std::size_t size, Packet& packet) noexcept {
  if (size != sizeof(Packet)) return false;
  Packet candidate;
  std::memcpy(&candidate, data, sizeof candidate);
  const Packet ours;
  if (candidate.magic != ours.magic || candidate.version != ours.version ||
      candidate.crc != crc32(&candidate, offsetof(Packet, crc))) {
    return false;
  }
  packet = candidate;
  return true;
}

// The next datagram that waits in the socket, and who sent it; its size, negative: there is none.  data may hold a byte more than
// the packet, so that a longer one is not taken for it.
template <std::size_t n>
ssize_t receive_waiting(int socket, unsigned char (&data)[n], sockaddr_un& from, socklen_t& from_size) noexcept {
  from_size = sizeof from;
  return ::recvfrom(socket, data, n, MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &from_size);
}

// Address in the abstract namespace; no file is left behind.  Returns its length.
inline socklen_t abstract_address(const std::string& name, sockaddr_un& address) noexcept {
  address = {};
  address.sun_family = AF_UNIX;
  const std::size_t length =
      name.size() < sizeof address.sun_path - 1 ? name.size() : sizeof address.sun_path - 1;
  std::memcpy(address.sun_path + 1, name.data(), length);
  return static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
}

}  // namespace twinbus::bridge::emulated
