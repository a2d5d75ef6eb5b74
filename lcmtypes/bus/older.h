// Messages as older logs have them: lcmtypes/older has those versions of the types.
//
// What is new in a type is there as its .lcm file says ({older ...} behind a field), else as zeros.

#pragma once

#include <cstdint>
#include <span>

namespace twinbus::inline lcmtypes {

// The bytes that a message of an older version has now, written to room; any other message as it is.  They are as good as room
// and bytes are.
std::span<const std::uint8_t> renewed(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> room) noexcept;

// The bytes that a message of now had in the version before (of several: in that whose file comes first), written to room; none when there is
// no other version.
std::span<const std::uint8_t> as_before(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> room) noexcept;

}  // namespace twinbus::lcmtypes
