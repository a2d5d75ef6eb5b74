// Legs of a robot that stands on points: two or four of them, whose feet are no soles.
//
// A robot without soles and with a free base stands on what StandingFeet finds.  It can be walked when that is four feet, two
// before and two behind, left and right, each on a limb of its own of at least three joints; or two, left and right, on limbs of
// three or four joints, which can put a foot anywhere but not turn it.

#pragma once

#include <optional>
#include <vector>

#include "robot/description/model.h"
#include "robot/estimation/standing_feet.h"

namespace twinbus::inline robot {

struct PointLeg {
  int foot = -1;            // of StandingFeet
  int link = -1;            // that touches the ground
  std::vector<int> joints;  // from the base, those that are on the bus
};

// Front left, front right, hind left, hind right; or left, right.
using PointLegs = std::vector<PointLeg>;

// Whether the base is free and no sole carries it: then the feet are points.
bool stands_on_points(const Model& model) noexcept;

// Empty when it has no such legs; why, if asked for, then says why not, in a sentence that lives for ever.
std::optional<PointLegs> point_legs(const Model& model, const StandingFeet& feet, const char** why = nullptr);

// How far a leg reaches from the first of its joints that bend it: the sum of what lies between its joints and its point [m].
double leg_length(const Model& model, const PointLeg& leg, const StandingFeet& feet);

}  // namespace twinbus::robot
