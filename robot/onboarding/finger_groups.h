// Fingers of an arm that can stay joints: which they are, and where they are open and closed.
//
// They stay as one group a hand, of a robot that stands too; what is no such group is fixed to its hand.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "robot/description/model.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

struct FingerGroup {
  std::vector<int> joints;           // of the model; none: the hand has no such fingers
  std::vector<int> links;            // the hand's and all that hang on it
  std::vector<double> open, closed;  // [rad or m], for each joint
};

using FingerGroups = std::array<FingerGroup, 2>;  // of the left and the right hand

// Joints behind a hand that have limits, effort and speed; all of a hand, or none when one has not, or they are heavier than the
// arm, or the bus would carry too many (planar: with the joints of a base that moves on the plane).
// Closed is where the fingers are nearest to one another, or a single one to its hand.
FingerGroups finger_groups(const Model& model, const Anatomy& anatomy, bool planar = false);

// Links of the group that the model does not exempt from touching each other yet, the smaller index first.
std::vector<std::array<int, 2>> pairs_within(const FingerGroup& group, const Model& model);

// The map `grippers` of robot.yaml (robot/description/robot_yaml.h); empty when there is none.
std::string gripper_yaml(const FingerGroups& groups, const Model& model);

// How stiff a finger is that grips with all its effort within a share of its range [N m/rad or N/m], and what it moves with those
// that follow it [kg m^2 or kg]; empty of joints of no group.
struct FingerServo {
  double kp = 0.0, inertia = 0.0;
};
std::optional<FingerServo> finger_servo(const FingerGroups& groups, const Model& model, int joint);

}  // namespace twinbus::robot
