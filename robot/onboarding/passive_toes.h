// Toes without a motor, which a proposal keeps as passive joints (`passive_joints` of robot/description/robot_yaml.h).

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Joints on the links of the soles, or on what hangs on them, whose limit of effort is 0.
std::vector<int> passive_toes(const Model& model);

// The list `passive_joints` of robot.yaml; empty when there are none.  Springs are guessed: a tenth of the weight on its tip bends a toe
// by 0.2 rad; damping is the file's, or 0.05 s times the stiffness.
std::string passive_yaml(const Model& model, const std::vector<int>& toes);

// Said behind their names.
inline constexpr const char* kPassiveToes =
    ": the simulator turns them by the springs under passive_joints of robot.yaml, which are guessed from the weight: measure them";

}  // namespace twinbus::robot
