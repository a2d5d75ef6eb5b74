// Shows a page in the user's browser.

#pragma once

#include <string>

namespace twinbus::inline viewer_log {

// Only where there is a display and the standard output is a terminal; the browser goes on without us.
void open_browser(const std::string& address);

}  // namespace twinbus::viewer_log
