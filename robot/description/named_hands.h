// The arms of a robot by their names under `hands` of robot.yaml, and what opens and closes on each.

#pragma once

#include <string>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// The arm called so; left and right are those of hand_of.  Null: none is.
const Hand* hand_called(const Model& model, const std::string& name) noexcept;

// What its arms are called: "left, right", "east, north, west"; empty of a robot without.
std::string hand_names(const Model& model);

// "the left hand", "arm north".
std::string spoken_name(const Model& model, const Hand& hand);

// Of a hand of this model; without joints: it has none.  Model::grippers has those of a left and a right hand, that of a further arm is
// read from Model::yaml_text, which the loader has checked.
Gripper gripper_of(const Model& model, const Hand& hand);

}  // namespace twinbus::robot
