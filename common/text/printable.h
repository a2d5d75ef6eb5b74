// Text of others, made fit for a terminal and for one screen.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace twinbus::inline common {

inline constexpr std::size_t kLongestError = 4000;  // of a sentence and its last lines [bytes]

// How many bytes at the head of text are one letter that a terminal may be given, 0 if none: ASCII from the space on, or
// well-formed UTF-8 of U+00A0 and above without the marks that change the direction of writing.
std::size_t printable_letter(std::string_view text) noexcept;

// What is no printable letter becomes '?', byte by byte; of a text longer than `most` bytes the middle is left out.
// lines: line ends stay.
std::string printable(std::string_view text, std::size_t most = 2000, bool lines = false);

// The same in place, as long as it is.
void make_printable(char* text, std::size_t size) noexcept;

}  // namespace twinbus::common
