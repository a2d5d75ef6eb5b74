// Simple shapes as contacts see them: how far a point is from one, and the points that stand for one
// where it meets another.

#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace twinbus::inline sim {

enum class SolidShape { kBox, kSphere, kCylinder, kCapsule };

struct Solid {
  SolidShape shape = SolidShape::kBox;
  // Box: full edges; sphere: radius; cylinder and capsule: radius, length along z (of a capsule
  // without its caps) [m].
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

struct Distance {
  double value;            // [m], negative inside
  Eigen::Vector3d normal;  // out of the solid, unit
};

// point and normal in the solid's own axes.
Distance distance_to(const Solid& solid, const Eigen::Vector3d& point) noexcept;

double bounding_radius(const Solid& solid) noexcept;  // [m]

// Of a homogeneous body of that mass, about its centre.
Eigen::Matrix3d inertia_of(const Solid& solid, double mass);  // [kg m^2]

// A small sphere or a bare point of a solid.
struct Probe {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;  // [m]
};
// Corners of a box, points of a cylinder's rims and spheres along a spine.
std::vector<Probe> probes_of(const Solid& solid);

}  // namespace twinbus::sim
