// A proposal for a robot on two or four point feet: which legs it has, and a posture in which it stands.

#pragma once

#include <Eigen/Core>
#include <optional>

#include "robot/estimation/point_legs.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

// If the robot has four legs, or two whose soles are hardly a surface and that cannot turn them: takes soles out of the anatomy, for
// its feet are points, and puts the joints of all legs into it; doubts about a humanoid that it is not are replaced.  Empty: it
// stays as it is.
std::optional<PointLegs> find_point_legs(const Model& model, Anatomy& anatomy);

// Trunk level, feet on one plane (of two: on a line) below the joints that swing the legs, the centre of mass above their middle, knees bent and behind
// where limits allow both [joint_count]; other joints as they are in q.  False when the legs cannot do it.
bool find_point_legged_posture(const Model& model, const PointLegs& legs, Eigen::VectorXd& q);

// Of the joints that swing the legs, above the feet, at least 0.05 [m].
double point_legged_height(const Model& model, const PointLegs& legs, const Eigen::VectorXd& q);

// Whether all feet are on one level plane in it, the trunk level above them and the centre of mass above their middle.
bool stands_on_point_legs(const Model& model, const PointLegs& legs, const Eigen::VectorXd& q);

// Legs of more than three joints may bend in many ways, few of which are meant.
bool bends_in_many_ways(const PointLegs& legs) noexcept;

}  // namespace twinbus::robot
