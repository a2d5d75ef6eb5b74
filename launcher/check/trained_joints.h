// Of the specification of a policy (doc/policy.md), what it says of the gears of the robot that it was trained with.

#pragma once

#include <string>
#include <vector>

#include "robot/onboarding/proposal.h"

namespace twinbus::inline launcher {

// Throws std::runtime_error naming file, line and key, also where it names a joint that the robot has not or says nothing.
std::vector<TrainedJoint> read_trained_joints(const std::string& spec_file, const Model& model);

}  // namespace twinbus::launcher
