// The options of `twinbus up`.

#pragma once

#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "launcher/run/verdict.h"
#include "launcher/stack/stack.h"

namespace twinbus::inline launcher {

Syntax up_syntax();

// Does it record a log?  TWINBUS_RECORD=0 is --no-record.
bool records(const Arguments& arguments);
// What is said to the recorder.
std::vector<std::string> recorder_words(const Arguments& arguments);
// Does a simulated world of this stack wait for late commands?
bool waits_for_late_commands(const Arguments& arguments, const Stack& stack);
// What is said to the simulator of its clock.
std::vector<std::string> pace_words(const Arguments& arguments, bool patient);
// What is said to the robot's face.
std::vector<std::string> face_options(const Arguments& arguments);
// What the placeholders of a stack stand for.  folder: of the run.
Placeholders placeholders_of(const Arguments& arguments, const RunRequest& request, const std::string& folder);
// Throws UsageError for a stack that plays a log when none is named.
void refuse_without_log(const Arguments& arguments, const Stack& stack);

}  // namespace twinbus::launcher
