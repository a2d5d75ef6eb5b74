// A posture that somebody asks for, joint by joint.

#pragma once

#include <string>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

// The joint of that name shall move to q [rad or m].  Returns an empty text, or one sentence why not and leaves the request as
// it was: the robot moves none of that name, or q is not within the limits of the joint.
std::string add_joint(const Model& model, const std::string& name, double q, ModeRequest& pose);

}  // namespace twinbus::robot
