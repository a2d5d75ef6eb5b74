#include "viewer_log/server/open_browser.h"

#include <unistd.h>

#include <cstdlib>

namespace twinbus::inline viewer_log {

void open_browser(const std::string& address) {
  const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (!display || isatty(1) != 1 || fork() != 0) return;
  setsid();
  execlp("xdg-open", "xdg-open", address.c_str(), nullptr);
  _exit(1);
}

}  // namespace twinbus::viewer_log
