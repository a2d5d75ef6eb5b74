// What a command that asks the controller for a mode has in common with the others.

#pragma once

#include <string>

#include "launcher/bus/bus_link.h"

namespace twinbus::inline launcher {

// Sends request again and again until the controller shows its sequence.  False when it never does.  Throws
// std::runtime_error before anything is sent when no source is active or the simulated world is paused: a request that
// waited would be obeyed when nobody thinks of it any more.
bool ask_controller(BusLink& bus, ModeRequest& request);
// After it was asked: why the controller does not do it, and the remedy.
std::string why_it_stays(BusLink& bus, const ModeRequest& request);

// "RF_KFE rests 0.047 rad or m short of it: ...", of the joint of a pose that is the farthest from it.
std::string what_rests(const RobotState& state, const ModeRequest& request);

// When joints that were sent somewhere have come there, or go no further.
struct JointsRest {
  double there = 0.03;   // from where they were sent [rad or m]
  double moved = 2e-3;   // one that moved less rests [rad or m]
  double still = 1.0;    // for so long [s]
};
// Of the joints of a pose, once its time is over.  False when they rest elsewhere or another mode came.
bool wait_for_joints(BusLink& bus, const ModeRequest& request, const JointsRest& rest);

}  // namespace twinbus::launcher
