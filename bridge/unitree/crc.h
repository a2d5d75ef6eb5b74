// The checksum of Unitree's low-level frames.
//
// Over 32-bit little-endian words w0, w1, ... of a frame without its last word, each from its highest bit:
//
//     r = 0xFFFFFFFF;   per bit b:  r = (r << 1) ^ ((r >> 31) ^ b ? 0x04C11DB7 : 0)
//
// and no final xor.  It is not the CRC-32 of Ethernet, which takes bits in the other order.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace twinbus::inline bridge {

// bytes.size() must be a multiple of 4; what is beyond the last whole word is left out.
std::uint32_t crc_of_words(std::span<const std::byte> bytes) noexcept;

}  // namespace twinbus::bridge
