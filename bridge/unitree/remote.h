// The wireless remote in a LowState: 40 bytes, filled from our gamepad.
//
// Bytes 0-1 0x55 0x51; 2-3 buttons, a bit each from the lowest: R1 L1 start select R2 L2 F1 F2, A B X Y up right down left;
// floats lx at 4, rx at 8, ry at 12, ly at 20, -1..1: right and forward positive.  All zero: no remote.

#pragma once

#include <array>
#include <cstdint>

#include "bridge/unitree/frames.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline bridge {

// pad.connected false gives zeros.
std::array<std::uint8_t, kRemoteBytes> remote_of(const Gamepad& pad) noexcept;

}  // namespace twinbus::bridge
