// What the page is told of a recording besides what a live stack tells: where it is, its marks, the logs there are.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viewer_log/log/log_marks.h"
#include "viewer_log/log/log_library.h"
#include "viewer_log/view/log_view.h"

namespace twinbus::inline viewer_log {

struct ReplayState {
  std::string name, beside;  // of the logs shown; beside may be empty
  bool playing = false, loop = false;
  bool beside_shown = false;        // the other log has something at this moment
  double speed = 1.0, shift = 0.0;  // shift of the other log [s]
  double in = -1.0, out = -1.0;     // negative: none
  double scanned = 0.0;             // share of the log whose marks are known
};

std::string replay_frame(const ReplayState& state, const LogView& log);
std::string marks_frame(const std::vector<LogMark>& marks, std::int64_t left_out);
// trouble: why the last one that was asked for could not be opened; or empty.
std::string shelf_frame(const LogShelf& shelf, const std::string& trouble);

}  // namespace twinbus::viewer_log
