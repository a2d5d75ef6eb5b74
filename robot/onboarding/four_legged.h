// A proposal for a robot on four point feet: which legs it has, and a posture in which it stands.

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "robot/estimation/point_legs.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus {

// If the robot is four-legged: takes soles out of the anatomy, for its feet are points, and puts the joints of all four legs into
// it; doubts about a humanoid that it is not are replaced.  Empty: it stays as it is.
std::optional<FourLegs> find_four_legs(const Model& model, Anatomy& anatomy);

// Trunk level, feet on one plane below the joints that swing the legs, the centre of mass above their middle, knees bent and behind
// where limits allow both [joint_count]; other joints as they are in q.  False when the legs cannot do it.
bool find_four_legged_posture(const Model& model, const FourLegs& legs, Eigen::VectorXd& q);

}  // namespace twinbus
