// What carries the arms of a robot nobody has described: a lift below two of them, a base that moves on the plane.

#pragma once

#include <string>

#include "robot/description/model.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

// A line of each hand in robot.yaml: the upright sliding joint of the trunk on which both arms hang.  Empty when there is none, or more
// joints than one plan moves hang on it.
std::string carried_by_yaml(const Model& model, const Anatomy& anatomy, const Hand& hand);

// The map `planar` of robot.yaml: its height puts what is of no arm 2 mm above the ground where it would reach lower.
std::string planar_yaml(const Model& model, const Anatomy& anatomy);

}  // namespace twinbus::robot
