// The structs of robot/ as bytes on the bus.
//
// decode() accepts exactly one encoded size per type, with the right fingerprint, or a message of an older version (older.h), with
// every number finite and in range (convert.h); anything else is refused whole.  encode() refuses the same, so
// no process can send what no process would take.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lcmtypes/bus/wire_table.h"  // made by lcmtypes/generate.py
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline lcmtypes {

inline constexpr int kLargestMessage = 1400;  // one Ethernet frame, so never split [bytes]

// Writes the encoded form to bytes and returns its size; 0 if there is no room or a number is not
// fit to send.
template <class T>
[[nodiscard]] int encode(const T& value, std::span<std::uint8_t> bytes) noexcept;

// Fills value.  When it is not kOk, value is unspecified.
template <class T>
Status decode(std::span<const std::uint8_t> bytes, T& value) noexcept;

// What a receiver needs to know of each type besides its bytes, Wire<T> of wire_table.h:
//   kBytes        encoded size
//   sender(x)     who sent it: one slot per sender
//   kCounted      whether count(x) goes up by one per message of one sender (ticks, sequences)

// The bytes of a message, for who keeps them; none when it is not fit to send.
template <class T>
std::vector<std::uint8_t> encoded(const T& value) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(kLargestMessage));
  bytes.resize(static_cast<std::size_t>(encode(value, bytes)));
  return bytes;
}

// Every channel with its type, for tools that take whatever comes (status, viewer, logs).
struct ChannelInfo {
  const char* channel;
  const char* type;                                         // "robot_state_t"
  int bytes;                                                // encoded size
  std::int64_t fingerprint;                                 // type hash, the first 8 encoded bytes
  Status (*check)(std::span<const std::uint8_t>) noexcept;  // decodes and forgets
};
std::span<const ChannelInfo> channel_table();
// Null for a channel that is not ours.  A name without its prefix.
const ChannelInfo* find_channel(const char* channel) noexcept;

}  // namespace twinbus::lcmtypes
