#include "bridge/unitree/crc.h"

#include <array>

namespace twinbus::inline bridge {

namespace {

constexpr std::uint32_t kPolynomial = 0x04C11DB7;

// What eight bits in front of the register do to it.
constexpr std::array<std::uint32_t, 256> kTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t r = byte << 24;
    for (int bit = 0; bit < 8; ++bit) r = (r << 1) ^ ((r >> 31) != 0 ? kPolynomial : 0);
    table[byte] = r;
  }
  return table;
}();

}  // namespace

std::uint32_t crc_of_words(std::span<const std::byte> bytes) noexcept {
  std::uint32_t r = 0xFFFFFFFF;
  for (std::size_t word = 0; word + 4 <= bytes.size(); word += 4) {
    for (std::size_t byte = 4; byte-- > 0;)  // little-endian words, their highest byte first
      r = (r << 8) ^ kTable[(r >> 24) ^ std::to_integer<std::uint32_t>(bytes[word + byte])];
  }
  return r;
}

}  // namespace twinbus::bridge
