#include "launcher/bus/redraw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace twinbus {
namespace {

// What a terminal shows and what has scrolled off it: rows that wrap, cursor up, erasure to the end.  ASCII alone.
class Terminal {
 public:
  explicit Terminal(TerminalSize size) : size_(size) {}

  void resize(std::size_t columns) {
    std::vector<std::string> narrow;
    for (const std::string& row : rows_) {
      for (std::size_t at = 0; at == 0 || at < row.size(); at += columns) narrow.push_back(row.substr(at, columns));
    }
    rows_ = std::move(narrow);
    row_ = rows_.size() - 1;
    size_.columns = columns;
    scroll();
  }

  void write(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\x1b') {
        const std::size_t end = text.find_first_of("AJ", i);
        if (text[end] == 'A') row_ -= std::min<std::size_t>(row_, std::stoul(text.substr(i + 2, end - i - 2)));
        if (text[end] == 'J') rows_.resize(row_ + 1), rows_[row_].clear();
        i = end;
        continue;
      }
      if (text[i] == '\n' || rows_[row_].size() == size_.columns) next_row();
      if (text[i] != '\n') rows_[row_] += text[i];
    }
  }

  const std::vector<std::string>& rows() const { return rows_; }
  const std::vector<std::string>& gone() const { return gone_; }

 private:
  void next_row() {
    ++row_;
    if (row_ == rows_.size()) rows_.emplace_back();
    scroll();
  }

  void scroll() {
    while (rows_.size() > size_.rows) {
      gone_.push_back(rows_.front());
      rows_.erase(rows_.begin());
      row_ -= row_ > 0 ? 1 : 0;
    }
  }

  TerminalSize size_;
  std::vector<std::string> rows_{""}, gone_;
  std::size_t row_ = 0;
};

std::vector<std::string> table(std::size_t lines, std::size_t width) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < lines; ++i) all.push_back("row " + std::to_string(i) + " " + std::string(width - 8, 'x'));
  return all;
}

// The first command on the terminal that everybody has: lines wider than it, and more of them than it has rows.
TEST(Redraw, TakesItsTableBackOnATerminalOf80By24) {
  const TerminalSize size{80, 24};
  for (const auto& [lines, width] : {std::pair<std::size_t, std::size_t>{16, 60}, {16, 130}, {23, 81}, {24, 20}, {40, 200}}) {
    Terminal terminal(size);
    Redraw redraw;
    terminal.write("a message\n");
    for (int k = 0; k < 20; ++k) terminal.write(redraw.drawn(table(lines, width), size));
    std::vector<std::string> all = terminal.gone();
    all.insert(all.end(), terminal.rows().begin(), terminal.rows().end());
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const std::string& row) { return row.starts_with("row 0 "); }), 1) << lines << " x " << width;
    EXPECT_EQ(all.front(), "a message");
    EXPECT_LE(all.size(), size.rows + 1);
  }
}

TEST(Redraw, TakesItsTableBackWhenTheTerminalHasBecomeNarrower) {
  Terminal terminal({80, 24});
  Redraw redraw;
  terminal.write("a message\n");
  terminal.write(redraw.drawn(table(6, 79), {80, 24}));
  terminal.resize(40);
  terminal.write(redraw.drawn(table(6, 79), {40, 24}));
  EXPECT_EQ(terminal.rows().size(), 8u);  // the message, six lines, and where the cursor waits
  EXPECT_EQ(terminal.rows().front(), "a message");
}

TEST(FitToTerminal, LeavesOutTheEndAndCountsIt) {
  const std::vector<std::string> fitting = fit_to_terminal(table(40, 100), {80, 24});
  ASSERT_EQ(fitting.size(), 23u);
  EXPECT_TRUE(fitting.front().starts_with("row 0 "));
  EXPECT_TRUE(fitting.back().starts_with("... 18 more lines")) << fitting.back();
  EXPECT_EQ(fit_to_terminal(table(23, 80), {80, 24}), table(23, 80));
}

TEST(CutToColumns, CountsColumnsNotBytes) {
  EXPECT_EQ(display_columns("\u00e9\u2026a"), 3u);      // two and three bytes, one column each
  EXPECT_EQ(display_columns("e\u0301"), 1u);            // a mark on the letter before
  EXPECT_EQ(display_columns("\u6a5f\u68b0"), 4u);       // two columns each
  EXPECT_EQ(display_columns("\xff"), 1u);
  EXPECT_EQ(cut_to_columns("abcdef", 6), "abcdef");
  EXPECT_EQ(cut_to_columns("abcdefg", 6), "abcde>");
  EXPECT_EQ(cut_to_columns("\u00e9\u00e9\u00e9\u00e9", 3), "\u00e9\u00e9>");
  EXPECT_EQ(cut_to_columns("\u6a5f\u68b0", 3), "\u6a5f>");
  EXPECT_EQ(cut_to_columns("\u6a5f\u68b0", 2), ">");    // half a letter is none
}

}  // namespace
}  // namespace twinbus
