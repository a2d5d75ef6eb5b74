// Ranges of joints on left and right that are not each other's image in a mirror, though the joints are.
//
// A turn by an angle about an axis (x, y, z) is seen in the mirror between left and right as a turn by it about (-x, y, -z): where
// the two axes of a file are so, both ranges are equal; where one points the other way, one range is the other one with its
// ends exchanged and their signs changed.  A file that was mirrored by hand often has the one in place of the other.

#pragma once

#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

struct UnmirroredRange {
  int kept = 0;    // joint whose range allows more of what legs need: hips forward and outward, knees back, shanks forward
  int other = 0;   // its image, whose range is another
  double lower = 0.0, upper = 0.0;  // what other's range is if it is the image of kept's [rad]
  bool of_leg = false;              // elsewhere nothing says which of the two is right
};

// Revolute joints whose links are mirror images in the posture nearest to zero, and whose ranges would be mirror images if the axis
// of one of them pointed the other way.  legs: joints of both legs, empty if unknown.
std::vector<UnmirroredRange> unmirrored_ranges(const Model& model, const std::vector<int>& legs);

}  // namespace twinbus::robot
