// Readers of single elements of an MJCF model, defaults resolved: see mjcf_model.h for what they fill.

#pragma once

#include <string>
#include <vector>

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

// frame: that of <frame> elements around it, in the body.
MjcfJoint read_mjcf_joint(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame,
                          std::vector<std::string>& notes);
MjcfGeom read_mjcf_geom(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame,
                        const std::vector<MjcfMesh>& meshes);
MjcfSite read_mjcf_site(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame);
MjcfInertia read_mjcf_inertial(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame);
// folder: of the model.
MjcfMesh read_mjcf_mesh(const MjcfElement& element, const MjcfCompiler& compiler, const std::string& folder);

// The range of a limit and whether it limits: *limited says so, or the range itself with autolimits.
bool read_mjcf_limit(const MjcfElement& element, const std::string& limited, const std::string& range,
                     const MjcfCompiler& compiler, double& lower, double& upper);

// False, with a note, when it drives no joint or is none that has a force law by q, qd and a target.
bool read_mjcf_actuator(const MjcfElement& element, const MjcfCompiler& compiler, MjcfActuator& actuator,
                        std::vector<std::string>& notes);

}  // namespace twinbus::robot
