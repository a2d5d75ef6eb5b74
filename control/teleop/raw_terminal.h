// A terminal that gives single keys: no echo, no line editing, put back as it was on leaving.
//
// A pipe works as well.  The end of input counts as the operator having gone away.

#pragma once

#include <termios.h>

#include <array>

namespace twinbus::inline control {

class RawTerminal {
 public:
  explicit RawTerminal(int descriptor = 0);
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  // Keys typed since the last call, arrow keys as Key of control/teleop/teleop.h; 0 marks the end of the
  // list.  Does not wait.
  std::array<int, 64> read_keys();
  bool at_end() const { return at_end_; }  // end of file or hang-up
  bool is_terminal() const { return is_terminal_; }

 private:
  int descriptor_;
  bool is_terminal_ = false;
  bool at_end_ = false;
  termios saved_{};
};

}  // namespace twinbus::control
