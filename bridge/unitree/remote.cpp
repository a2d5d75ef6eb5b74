#include "bridge/unitree/remote.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace twinbus::inline bridge {

namespace {

// Our bit (gamepad_t.buttons) of each of theirs, -1: none; the triggers are 4 and 5.
constexpr int kOurs[16] = {10, 9, 6, 4, -1, -1, 5, -1, 0, 1, 2, 3, 11, 14, 12, 13};
constexpr int kR2 = 4, kL2 = 5;
constexpr float kPulled = 0.5F;  // of a trigger

void put(std::array<std::uint8_t, kRemoteBytes>& bytes, std::size_t at, float value) noexcept {
  const float kept = std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
  std::memcpy(bytes.data() + at, &kept, sizeof kept);
}

}  // namespace

std::array<std::uint8_t, kRemoteBytes> remote_of(const Gamepad& pad) noexcept {
  std::array<std::uint8_t, kRemoteBytes> bytes{};
  if (!pad.connected) return bytes;
  unsigned buttons = 0;
  for (unsigned theirs = 0; theirs < 16; ++theirs) {
    const int ours = kOurs[theirs];
    if (ours >= 0 && (static_cast<unsigned>(pad.buttons) >> ours & 1U) != 0) buttons |= 1U << theirs;
  }
  if (pad.right_trigger > kPulled) buttons |= 1U << kR2;
  if (pad.left_trigger > kPulled) buttons |= 1U << kL2;
  bytes[0] = 0x55;
  bytes[1] = 0x51;
  bytes[2] = static_cast<std::uint8_t>(buttons & 0xFF);
  bytes[3] = static_cast<std::uint8_t>(buttons >> 8);
  put(bytes, 4, -pad.left_x);
  put(bytes, 8, -pad.right_x);
  put(bytes, 12, pad.right_y);
  put(bytes, 20, pad.left_y);
  return bytes;
}

}  // namespace twinbus::bridge
