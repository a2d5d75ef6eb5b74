// The C++ end of a comparison of frames with another implementation of Unitree's messages (test/process/unitree_peer.py).
//
//   unitree_probe unitree_hg|unitree_go COUNT INTERFACE DOMAIN [KIND]
//
// State k goes out; the peer checks it and answers with command k, which is checked here; then k + 1.  Every number follows from
// k by mixed(), which both ends have.  KIND robot (default): writes states; program: writes commands and checks states.

#include <poll.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "bridge/adaptors/unitree_dds/unitree_dds.h"
#include "common/process/process.h"

namespace twinbus {
namespace {

constexpr std::int64_t kAgain = 200'000'000;       // a frame that was not answered is sent again [ns]
constexpr std::int64_t kPatience = 60'000'000'000;  // [ns]

std::uint32_t mixed(std::uint32_t k, std::uint32_t item) {
  std::uint32_t h = k * 2654435761U + item * 2246822519U + 374761393U;
  h ^= h >> 15;
  h *= 2246822519U;
  h ^= h >> 13;
  return h;
}
// A float that has no rounding, -512 to 512.
float number(std::uint32_t k, std::uint32_t item) { return static_cast<float>(mixed(k, item) & 0xFFFF) / 64.0F - 512.0F; }

LowCommand command_of(std::uint32_t k, UnitreeFamily family) {
  LowCommand c;
  if (family == UnitreeFamily::kHg) {
    c.mode_pr = static_cast<std::uint8_t>(mixed(k, 900) & 1);
    c.mode_machine = static_cast<std::uint8_t>(mixed(k, 901));
  }
  for (std::uint32_t m = 0; m < static_cast<std::uint32_t>(motor_count(family)); ++m) {
    const std::uint32_t i = 10 * m;
    if ((mixed(k, i) & 7) == 0) continue;  // off
    c.motor[m] = {true, number(k, i + 1), number(k, i + 2), number(k, i + 3), number(k, i + 4) + 512.0F, number(k, i + 5) + 512.0F};
  }
  return c;
}

LowReading reading_of(std::uint32_t k, UnitreeFamily family) {
  const bool hg = family == UnitreeFamily::kHg;
  LowReading r;
  r.tick = k;
  if (hg) r.mode_machine = static_cast<std::uint8_t>(mixed(k, 901));
  for (std::uint32_t a = 0; a < 3; ++a) {
    r.gyro[a] = number(k, 910 + a);
    r.accel[a] = number(k, 913 + a);
  }
  for (std::uint32_t m = 0; m < static_cast<std::uint32_t>(motor_count(family)); ++m) {
    const std::uint32_t i = 10 * m;
    r.motor[m] = {(mixed(k, i) & 7) != 0, number(k, i + 1), number(k, i + 2), number(k, i + 3),
                  static_cast<float>(mixed(k, i + 4) & 0x7F), hg ? number(k, i + 5) : 0.0F};
  }
  for (std::uint32_t b = 0; b < kRemoteBytes; ++b) r.remote[b] = static_cast<std::uint8_t>(mixed(k, 950 + b));
  if (!hg) {
    for (std::uint32_t f = 0; f < 4; ++f) r.foot_force[f] = static_cast<float>(mixed(k, 920 + f) & 0x3FF);
    r.volts = number(k, 930);
    r.amperes = number(k, 931);
  }
  return r;
}

// The frame of step k that this end writes, or the one that it expects.
template <class Content>
std::array<std::byte, kLargestFrame> frame_of(const Content& content, UnitreeFamily family) {
  std::array<std::byte, kLargestFrame> frame{};
  encode(content, family, frame);
  return frame;
}

int run(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: unitree_probe unitree_hg|unitree_go COUNT INTERFACE DOMAIN [robot|program]\n");
    return 2;
  }
  const UnitreeFamily family = std::string(argv[1]) == "unitree_hg" ? UnitreeFamily::kHg : UnitreeFamily::kGo;
  const bool robot = argc < 6 || std::string(argv[5]) == "robot";
  const auto count = static_cast<std::uint32_t>(std::atoi(argv[2]));
  UnitreeDds dds(family, robot ? UnitreeDds::Side::kRobot : UnitreeDds::Side::kProgram, {.interface = argv[3], .domain = std::atoi(argv[4])});
  std::printf("ready\n");
  std::fflush(stdout);
  const std::size_t out_size = robot ? state_bytes(family) : command_bytes(family);
  std::int64_t wrong = 0, again = 0, repeated = 0;
  for (std::uint32_t k = 1; k <= count; ++k) {
    const auto out = robot ? frame_of(reading_of(k, family), family) : frame_of(command_of(k, family), family);
    const auto expected = robot ? frame_of(command_of(k, family), family) : frame_of(reading_of(k, family), family);
    const auto before = robot ? frame_of(command_of(k - 1, family), family) : frame_of(reading_of(k - 1, family), family);
    const std::int64_t begin = monotonic_ns();
    std::int64_t sent = 0;
    bool answered = false;
    while (!answered) {
      const std::int64_t now = monotonic_ns();
      if (now - begin > kPatience) {
        std::printf("no answer to frame %u of %u, %lld wrong\n", k, count, static_cast<long long>(wrong));
        return 1;
      }
      if (sent == 0 || now - sent > kAgain) {
        if (sent != 0) ++again;
        sent = now;
        if (!dds.write(std::span(out).first(out_size))) std::fprintf(stderr, "not written\n");
      }
      pollfd wait = {dds.fileno(), POLLIN, 0};
      ::poll(&wait, 1, 20);
      dds.quiet();
      dds.serve();
      for (DdsSample sample; dds.take(sample);) {
        // Bytes: every field, padding and checksum at once.
        if (std::memcmp(sample.bytes.data(), expected.data(), sample.bytes.size()) == 0) {
          answered = true;
        } else if (std::memcmp(sample.bytes.data(), before.data(), sample.bytes.size()) == 0) {
          ++repeated;
        } else {
          ++wrong;
          answered = true;
        }
      }
    }
  }
  std::printf("%u frames each way: %lld wrong here, %lld sent again, %lld repeated\n", count, static_cast<long long>(wrong),
              static_cast<long long>(again), static_cast<long long>(repeated));
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("unitree_probe", twinbus::run, argc, argv); }
