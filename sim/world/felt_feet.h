// The feet of a simulated robot as its force sensors and TRUTH know them, in the order of ESTIMATE: soles, left and right, then what
// else stands (standing_feet.h).

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus {

struct FeltFoot {
  int link = -1;  // -1: there is no such foot
  int side = -1;  // of its sole; -1 it has none
  // In the link: the sole's; of a foot without one that of the ball that touches in the posture nearest to zero, axes of the link.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
  double radius = 0.0;  // of that ball [m]

  // Whether a contact is beyond its force sensor.
  bool feels(const ContactPoint& contact) const noexcept {
    return contact.sole >= 0 ? contact.sole == side : contact.link == link;
  }
};

struct FeltFeet {
  std::array<FeltFoot, kMaxFeet> foot;
  int count = 0;  // rows in use
};

// Allocates.
FeltFeet felt_feet(const Model& model);

}  // namespace twinbus
