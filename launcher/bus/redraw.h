// Lines that are written over the ones before, on a terminal of any size.
//
// Nothing wraps and nothing scrolls: a line that wrapped would take two rows, and a table taller than the terminal
// cannot be taken back, so every line is cut to the width and the table to the height.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline launcher {

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

// Of standard output; 80 x 24 where it does not tell.
TerminalSize terminal_size() noexcept;

// Columns that a UTF-8 text takes: 2 for a letter of East Asia or an emoji, 0 for a mark on the letter before.  A byte that
// is no letter counts 1.
std::size_t display_columns(std::string_view text) noexcept;

// As much of a line as columns hold; a cut line ends with '>'.
std::string cut_to_columns(const std::string& line, std::size_t columns);

// The lines of a table on this terminal, one row less than it has, since the cursor waits below: what does not fit is
// left out at the end and counted in the last line.
std::vector<std::string> fit_to_terminal(const std::vector<std::string>& lines, TerminalSize terminal);

// Only for a terminal.
class Redraw {
 public:
  void draw(const std::vector<std::string>& lines);
  // What draw writes on a terminal of that size.
  std::string drawn(const std::vector<std::string>& lines, TerminalSize terminal);
  // Leaves the lines standing; what is printed next comes below them.
  void leave() { widths_.clear(); }
  // Takes the lines away, so that something else can be printed in their place.
  void clear();

 private:
  // Takes them away; a terminal that has become narrower has wrapped them.
  std::string erased(TerminalSize terminal);

  std::vector<std::size_t> widths_;  // of the lines that stand [columns]
};

}  // namespace twinbus::launcher
