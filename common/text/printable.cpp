#include "common/text/printable.h"

#include <cstdint>

namespace twinbus::inline common {

std::size_t printable_letter(std::string_view text) noexcept {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 && first < 0xf5   ? 4
                           : first >= 0xe0 && first < 0xf0 ? 3
                           : first >= 0xc2 && first < 0xe0 ? 2
                                                           : 0;
  if (size == 0 || text.size() < size) return 0;
  std::uint32_t point = first & (0x7fU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0U) != 0x80U) return 0;
    point = point << 6 | (next & 0x3fU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xd800 && point < 0xe000;
  const bool turns = (point >= 0x200b && point <= 0x200f) || (point >= 0x2028 && point <= 0x202e) ||
                     (point >= 0x2066 && point <= 0x2069) || point == 0xfeff;
  return point >= 0xa0 && point >= kLeast[size] && point < 0x110000 && !surrogate && !turns ? size
                                                                                            : 0;
}

void make_printable(char* text, std::size_t size) noexcept {
  for (std::size_t at = 0; at < size;) {
    const std::size_t letter = printable_letter({text + at, size - at});
    if (letter == 0) text[at] = '?';
    at += letter == 0 ? 1 : letter;
  }
}

std::string printable(std::string_view text, std::size_t most, bool lines) {
  std::string result;
  if (text.size() > most) {
    const std::size_t half = most / 2;
    result = printable(text.substr(0, half), most, lines);
    result += " ... (" + std::to_string(text.size() - 2 * half) + " bytes left out) ... ";
    return result + printable(text.substr(text.size() - half), most, lines);
  }
  result = text;
  for (std::size_t at = 0; at < result.size();) {
    const std::size_t letter = printable_letter(std::string_view(result).substr(at));
    if (letter == 0 && !(lines && result[at] == '\n')) result[at] = '?';
    at += letter == 0 ? 1 : letter;
  }
  return result;
}

}  // namespace twinbus::common
