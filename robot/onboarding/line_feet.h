// Feet that touch the ground along a line: a blade, a cylinder that lies, two balls.
//
// A line is at least four times as long as wide, and so narrow that no zero-moment point is held beside its middle.

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Whether a sole is such a line, along or across the foot.
bool is_line(const Sole& sole) noexcept;

// What of a foot lies on the ground, seen from above, if that is a line: of round shapes where they touch; of others what is within a
// millimetre of the ground, if it is a line along the foot (a flat sole that is tipped forward touches along one across, and is none).
// pose: of the link, z up; points: its geometry in the same frame; ground: height of its lowest point [m].
std::optional<Eigen::AlignedBox2d> line_on_ground(const Link& link, const Eigen::Isometry3d& pose,
                                                  const std::vector<Eigen::Vector3d>& points, double ground);

}  // namespace twinbus::robot
