// <compiler>: how angles, orientations, limits and masses of an MJCF model are meant.

#pragma once

#include <Eigen/Geometry>
#include <string>

#include "robot/mjcf/mjcf_element.h"

namespace twinbus::inline robot {

enum class InertiaFromGeom { kNever, kAlways, kIfMissing };

struct MjcfCompiler {
  bool degrees = true;
  bool autolimits = true;
  std::string eulerseq = "xyz";
  std::string mesh_folder;  // relative to the model's, or empty
  bool strip_path = false;
  InertiaFromGeom inertia = InertiaFromGeom::kIfMissing;
  int first_group = 0, last_group = 5;  // of geoms that give inertia
  double total_mass = -1.0;             // [kg]; not above 0: as it is
  double least_mass = 0.0, least_inertia = 0.0;
  bool balance_inertia = false;

  double angle(double value) const noexcept;  // to [rad]
};

// Later sections win, as in MuJoCo.  Throws for what is not known, and for coordinate="global", which MuJoCo gave up.
MjcfCompiler read_compiler(const MjcfElement& mujoco);

// Of quat, axisangle, euler, xyaxes or zaxis; identity without them.  Throws for a vector of no length.
Eigen::Matrix3d read_orientation(const MjcfElement& element, const MjcfCompiler& compiler);

// The orientation and pos.
Eigen::Isometry3d read_place(const MjcfElement& element, const MjcfCompiler& compiler);

// With z along a direction, by the shortest rotation.
Eigen::Matrix3d rotation_of_z(const Eigen::Vector3d& direction);

}  // namespace twinbus::robot
