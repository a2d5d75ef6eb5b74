// What standing and stepping need of a robot on two or four point feet: legs, nominal stance, inertia.
//
// The stance is that of the pose half_sitting, the trunk level.  All lengths of the gait follow from it.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "robot/description/model.h"
#include "robot/estimation/point_legs.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline control {

struct PointFeetBody {
  // Throws std::runtime_error with one sentence when the robot has no such legs or does not stand in half_sitting.
  explicit PointFeetBody(const Model& model);

  // Two feet are a line: the robot stands only while it steps.
  bool two() const noexcept { return legs.size() == 2; }

  PointLegs legs;
  std::array<Eigen::Vector3d, 4> centre;      // of the ball that rolls on the ground, in the foot's link [m]
  std::array<double, 4> radius{};             // of that ball [m]
  std::array<Eigen::Vector2d, 4> stance;      // of a foot from the centre of mass, seen from above, trunk level [m]
  Eigen::VectorXd posture;                    // of the stance [joint_count]
  Eigen::Vector3d com_in_base;                // in the stance [m]
  double height = 0.0;                        // of the centre of mass above the ground [m]
  double reach = 0.0;                         // of a stretched leg [m]
  double length = 0.0, width = 0.0;           // half of the way between feet; of two as long as wide [m]
  double mass = 0.0;                          // [kg]
  Eigen::Matrix3d inertia;                    // about the centre of mass, axes of the base [kg m^2]
};

// Why a robot cannot stand on points; null when it can.
const char* why_no_point_feet(const Model& model) noexcept;

}  // namespace twinbus::control
