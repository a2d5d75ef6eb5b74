// What a simulator does when it is asked for what only a simulated world can do.

#pragma once

#include <array>

#include "bridge/adaptor/adaptor.h"
#include "bridge/source/sim_pace.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline bridge {

// Does it; gives the sentence for people, zero-terminated.
std::array<char, 160> obey_sim_request(const SimRequest& request, const Model& model,
                                       SimPace& clock, RobotAdaptor& adaptor) noexcept;

}  // namespace twinbus::bridge
