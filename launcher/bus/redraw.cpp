#include "launcher/bus/redraw.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "common/text/formatted.h"
#include "common/text/printable.h"

namespace twinbus::inline launcher {

namespace {

struct Range {
  char32_t first, last;
};

// Unicode: general category Mn of the scripts of Europe and what joins letters; East_Asian_Width W and F, emoji among them.
constexpr std::array<Range, 6> kMarks{
    {{0x0300, 0x036F}, {0x0483, 0x0489}, {0x200B, 0x200F}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}}};
constexpr std::array<Range, 9> kWide{{{0x1100, 0x115F}, {0x2E80, 0x303E}, {0x3041, 0xA4CF}, {0xAC00, 0xD7A3}, {0xF900, 0xFAFF},
                                      {0xFE30, 0xFE6F}, {0xFF00, 0xFF60}, {0x1F300, 0x1FAFF}, {0x20000, 0x3FFFD}}};

bool is_in(char32_t letter, const auto& ranges) noexcept {
  return std::any_of(ranges.begin(), ranges.end(), [&](Range range) { return letter >= range.first && letter <= range.last; });
}

struct Letter {
  std::size_t bytes, columns;
};

// At the head of a text that is not empty.
Letter first_letter(std::string_view text) noexcept {
  const std::size_t bytes = printable_letter(text);
  if (bytes <= 1) return {1, 1};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  char32_t code = byte(0) & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) code = code << 6 | (byte(i) & 0x3FU);
  return {bytes, is_in(code, kMarks) ? 0U : is_in(code, kWide) ? 2U : 1U};
}

}  // namespace

TerminalSize terminal_size() noexcept {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

std::size_t display_columns(std::string_view text) noexcept {
  std::size_t columns = 0;
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    columns += letter.columns;
    text.remove_prefix(letter.bytes);
  }
  return columns;
}

std::string cut_to_columns(const std::string& line, std::size_t columns) {
  if (display_columns(line) <= columns) return line;
  std::size_t bytes = 0;
  for (std::size_t used = 0; bytes < line.size();) {
    const Letter letter = first_letter(std::string_view(line).substr(bytes));
    if (used + letter.columns + 1 > columns) break;
    used += letter.columns;
    bytes += letter.bytes;
  }
  return line.substr(0, bytes) + (columns > 0 ? ">" : "");
}

std::vector<std::string> fit_to_terminal(const std::vector<std::string>& lines, TerminalSize terminal) {
  const std::size_t most = std::max<std::size_t>(terminal.rows, 2) - 1;
  std::vector<std::string> fitting(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(lines.size(), most)));
  if (lines.size() > most) fitting.back() = formatted("... %zu more lines: a taller terminal shows them", lines.size() - most + 1);
  for (std::string& line : fitting) line = cut_to_columns(line, terminal.columns);
  return fitting;
}

std::string Redraw::erased(TerminalSize terminal) {
  const std::size_t columns = std::max<std::size_t>(terminal.columns, 1);
  std::size_t rows = 0;
  for (const std::size_t width : widths_) rows += std::max<std::size_t>((width + columns - 1) / columns, 1);
  widths_.clear();
  return rows > 0 ? formatted("\x1b[%zuA\x1b[J", rows) : "";
}

std::string Redraw::drawn(const std::vector<std::string>& lines, TerminalSize terminal) {
  std::string text = erased(terminal);
  for (const std::string& line : fit_to_terminal(lines, terminal)) {
    text += line + "\n";
    widths_.push_back(display_columns(line));
  }
  return text;
}

void Redraw::clear() { std::fputs(erased(terminal_size()).c_str(), stdout); }

void Redraw::draw(const std::vector<std::string>& lines) {
  std::fputs(drawn(lines, terminal_size()).c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace twinbus::launcher
