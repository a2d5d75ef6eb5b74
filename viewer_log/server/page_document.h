// The page as it is given to a browser: its index.html, which says how the program is typed here.
//
// The page's own texts are written with ./twinbus, as ours are, and also those that are shown before the viewer has answered
// anything: so the word comes with the page, in data-command of its first element.

#pragma once

#include <string>

#include "viewer_log/server/web_path.h"

namespace twinbus::inline viewer_log {

// Throws std::runtime_error where that folder holds no page.
WebDocument page_document(const std::string& folder);
WebDocument page_document(const std::string& folder, bool installed);

}  // namespace twinbus::viewer_log
