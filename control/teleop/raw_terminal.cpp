#include "control/teleop/raw_terminal.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "control/teleop/teleop.h"

namespace twinbus::inline control {

RawTerminal::RawTerminal(int descriptor) : descriptor_(descriptor) {
  is_terminal_ = isatty(descriptor_) == 1 && tcgetattr(descriptor_, &saved_) == 0;
  if (!is_terminal_) return;
  termios raw = saved_;
  // Ctrl-C comes as a key, so that leaving always sends zeros first; Ctrl-Z does nothing.
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  tcsetattr(descriptor_, TCSANOW, &raw);
}

RawTerminal::~RawTerminal() {
  if (is_terminal_) tcsetattr(descriptor_, TCSANOW, &saved_);
}

std::array<int, 64> RawTerminal::read_keys() {
  std::array<int, 64> keys{};
  std::array<char, 63> bytes;
  pollfd descriptor{descriptor_, POLLIN, 0};
  if (at_end_ || poll(&descriptor, 1, 0) <= 0) return keys;
  const ssize_t got = read(descriptor_, bytes.data(), bytes.size());
  if (got <= 0) {
    at_end_ = got == 0 || (errno != EINTR && errno != EAGAIN);
    return keys;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
    const auto left = static_cast<std::size_t>(got) - i;
    // Arrow keys: ESC [ A .. D, or ESC O A .. D.  Any other sequence is skipped up to its letter.
    if (bytes[i] == 27 && left >= 3 && (bytes[i + 1] == '[' || bytes[i + 1] == 'O')) {
      static constexpr std::array<int, 4> kArrows{kKeyUp, kKeyDown, kKeyRight, kKeyLeft};
      i += 2;
      if (bytes[i] >= 'A' && bytes[i] <= 'D') {
        keys[count++] = kArrows[static_cast<std::size_t>(bytes[i] - 'A')];
      } else {
        while (i + 1 < static_cast<std::size_t>(got) && bytes[i] >= '0' && bytes[i] <= '?') ++i;
      }
      continue;
    }
    if (bytes[i] == 4) {  // Ctrl-D
      at_end_ = true;
      break;
    }
    keys[count++] = static_cast<unsigned char>(bytes[i]);
  }
  return keys;
}

}  // namespace twinbus::control
