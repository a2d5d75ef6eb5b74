// The feet of a simulated robot as its force sensors and TRUTH know them, in the order of ESTIMATE: soles, left and right, then what
// else stands (standing_feet.h).

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct FeltFoot {
  int link = -1;  // -1: there is no such foot
  int side = -1;  // of its sole; -1 it has none
  // In the link: the sole's; of a foot without one that of the ball that touches in the posture nearest to zero, axes of the link.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
  double radius = 0.0;  // of that ball [m]

  std::vector<int> toes{};  // links that hang on its link

  // Whether a contact is beyond its force sensor.
  bool feels(const ContactPoint& contact) const noexcept {
    if (contact.sole >= 0) return contact.sole == side;
    return contact.link == link || std::find(toes.begin(), toes.end(), contact.link) != toes.end();
  }
};

struct FeltFeet {
  std::array<FeltFoot, kMaxFeet> foot;
  int count = 0;  // rows in use
};

// Whether a link is a toe of the foot with that sole.
bool is_toe_of(const Model& model, const Sole& sole, int link) noexcept;
// Whether a ball, in the sole's frame, is where the springs of the sole carry already: a toe presses nothing there.
bool under_sole(const Sole& sole, const Eigen::Vector3d& center, double radius) noexcept;

// Allocates.
FeltFeet felt_feet(const Model& model);

}  // namespace twinbus::sim
