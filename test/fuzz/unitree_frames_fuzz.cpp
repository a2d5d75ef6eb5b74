// Bytes as a LowCmd or LowState of either family: as they are, and with the checksum made right, so that what lies behind it is
// met too.  What is accepted has finite numbers and gains of 0 or more.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include "bridge/unitree/crc.h"
#include "bridge/unitree/low_frames.h"

namespace {

using namespace twinbus;

void check(bool good) {
  if (!good) std::abort();
}

void check(const LowCommand& command) {
  for (const MotorWish& motor : command.motor) {
    check(std::isfinite(motor.q) && std::isfinite(motor.dq) && std::isfinite(motor.tau));
    check(motor.kp >= 0.0F && motor.kd >= 0.0F && std::isfinite(motor.kp) && std::isfinite(motor.kd));
    check(motor.on || (motor.kp == 0.0F && motor.kd == 0.0F && motor.tau == 0.0F));
  }
}

void check(const LowReading& reading) {
  for (const MotorReading& motor : reading.motor)
    check(std::isfinite(motor.q) && std::isfinite(motor.dq) && std::isfinite(motor.tau) && std::isfinite(motor.volts));
  for (const float x : reading.quaternion) check(std::isfinite(x));
}

template <class Content>
void try_one(std::span<const std::uint8_t> data, UnitreeFamily family, std::size_t size) {
  Content content;
  static_cast<void>(decode(std::as_bytes(data), family, content));
  check(content);
  std::array<std::byte, kLargestFrame> frame{};
  std::memcpy(frame.data(), data.data(), std::min(size, data.size()));
  const std::uint32_t crc = crc_of_words(std::span(frame).first(size - 4));
  std::memcpy(frame.data() + size - 4, &crc, 4);
  if (decode(std::span(frame).first(size), family, content).fault != FrameFault::kNone) return;
  check(content);
  std::array<std::byte, kLargestFrame> again{};
  encode(content, family, again);
  check(decode(std::span(again).first(size), family, content).fault == FrameFault::kNone);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  for (const UnitreeFamily family : {UnitreeFamily::kHg, UnitreeFamily::kGo}) {
    try_one<LowCommand>({data, size}, family, command_bytes(family));
    try_one<LowReading>({data, size}, family, state_bytes(family));
  }
  return 0;
}
