// Geoms of an MJCF model as shapes of a URDF.
//
// A capsule becomes a cylinder with two balls; an ellipsoid, a mesh written in the model and a shape fitted to a mesh become
// the box around them.

#pragma once

#include <string>
#include <vector>

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

// Adds the <collision> or <visual> elements of one geom; in_link: the body's frame in the link's.  Nothing for planes and
// height fields.  A mesh of a visual that cannot be read is left out with a note, that of a collision throws.
void append_urdf_shapes(const MjcfGeom& geom, const MjcfModel& model, const Eigen::Isometry3d& in_link,
                        std::string& urdf, std::vector<std::string>& notes);

}  // namespace twinbus::robot
