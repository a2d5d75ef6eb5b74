// What an operator says to a running robot: stop, clear, pose, mode, sway, squat.

#pragma once

#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "launcher/bus/bus_link.h"

namespace twinbus {

int stop_command(const std::vector<std::string>& words);
int clear_command(const std::vector<std::string>& words);
int pose_command(const std::vector<std::string>& words);
int mode_command(const std::vector<std::string>& words);
int sway_command(const std::vector<std::string>& words);
int squat_command(const std::vector<std::string>& words);

// For these and other commands.
BusLink open_bus(const Arguments& arguments);
// Sends request again and again until the controller shows its sequence.  False when it never does.  Throws
// std::runtime_error before anything is sent when no source is active or the simulated world is paused: a request that
// waited would be obeyed when nobody thinks of it any more.
bool ask_controller(BusLink& bus, ModeRequest& request);
// After it was asked: why the controller does not do it, and the remedy.
std::string why_it_stays(BusLink& bus, const ModeRequest& request);

}  // namespace twinbus
