#include "control/teleop/raw_terminal.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "control/teleop/teleop.h"

namespace twinbus {
namespace {

class Terminal : public testing::Test {
 protected:
  void SetUp() override {
    if (openpty(&master_, &slave_, nullptr, nullptr, nullptr) != 0)  // qemu-user has none
      GTEST_SKIP() << "no pseudo terminal here: " << std::strerror(errno);
  }
  void TearDown() override {
    if (master_ >= 0) close(master_);
    close(slave_);
  }
  void type(const std::string& bytes) {
    ASSERT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  static std::vector<int> keys(RawTerminal& terminal) {
    std::vector<int> list;
    for (int key : terminal.read_keys()) {
      if (key == 0) break;
      list.push_back(key);
    }
    return list;
  }
  int master_ = -1, slave_ = -1;
};

TEST_F(Terminal, KeysComeSinglyWithoutReturn) {
  RawTerminal terminal(slave_);
  EXPECT_TRUE(terminal.is_terminal());
  EXPECT_TRUE(keys(terminal).empty());
  type("w ");
  EXPECT_EQ(keys(terminal), (std::vector<int>{'w', ' '}));
}

TEST_F(Terminal, ArrowsAreKeysAndOtherSequencesAreSkipped) {
  RawTerminal terminal(slave_);
  type("\x1b[A\x1b[B\x1bOC\x1b[D\x1b[5~q");
  EXPECT_EQ(keys(terminal), (std::vector<int>{kKeyUp, kKeyDown, kKeyRight, kKeyLeft, 'q'}));
}

TEST_F(Terminal, ControlCIsAKeyAndControlDTheEnd) {
  RawTerminal terminal(slave_);
  type("\x03");
  EXPECT_EQ(keys(terminal), std::vector<int>{3});
  EXPECT_FALSE(terminal.at_end());
  type("\x04");
  keys(terminal);
  EXPECT_TRUE(terminal.at_end());
}

TEST_F(Terminal, AHungUpTerminalIsTheEnd) {
  RawTerminal terminal(slave_);
  close(master_);
  master_ = -1;
  keys(terminal);
  EXPECT_TRUE(terminal.at_end());
}

TEST_F(Terminal, SettingsArePutBack) {
  termios before, during, after;
  ASSERT_EQ(tcgetattr(slave_, &before), 0);
  {
    RawTerminal terminal(slave_);
    tcgetattr(slave_, &during);
    EXPECT_EQ(during.c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0u);
  }
  tcgetattr(slave_, &after);
  EXPECT_EQ(before.c_lflag, after.c_lflag);
}

TEST(Pipe, EndOfInputIsTheEnd) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  RawTerminal terminal(ends[0]);
  EXPECT_FALSE(terminal.is_terminal());
  ASSERT_EQ(write(ends[1], "w", 1), 1);
  close(ends[1]);
  EXPECT_EQ(terminal.read_keys()[0], 'w');
  terminal.read_keys();
  EXPECT_TRUE(terminal.at_end());
  close(ends[0]);
}

}  // namespace
}  // namespace twinbus
