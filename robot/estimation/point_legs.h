// Legs of a robot that stands on points: four-legged robots, whose feet are no soles.
//
// A robot without soles and with a free base stands on what StandingFeet finds.  It is a quadruped when that is four feet, each
// on a limb of its own of at least three joints, two before and two behind, left and right.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "robot/description/model.h"
#include "robot/estimation/standing_feet.h"

namespace twinbus {

struct PointLeg {
  int foot = -1;            // of StandingFeet
  int link = -1;            // that touches the ground
  std::vector<int> joints;  // from the base, those that are on the bus
};

// Front left, front right, hind left, hind right.
using FourLegs = std::array<PointLeg, 4>;

// Whether the base is free and no sole carries it: then the feet are points.
bool stands_on_points(const Model& model) noexcept;

// Empty when the robot is no quadruped; why, if asked for, then says why not, in a sentence that lives for ever.
std::optional<FourLegs> four_legs(const Model& model, const StandingFeet& feet, const char** why = nullptr);

// How far a leg reaches from the first of its joints that bend it: the sum of what lies between its joints and its point [m].
double leg_length(const Model& model, const PointLeg& leg, const StandingFeet& feet);

}  // namespace twinbus
