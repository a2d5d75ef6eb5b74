#include "sim/world/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twinbus::inline sim {

namespace {

constexpr int kRimPoints = 6;
constexpr int kSpinePoints = 3;

Distance from_center(const Eigen::Vector3d& p, double radius) noexcept {
  const double norm = p.norm();
  if (!(norm > 0.0)) return {-radius, Eigen::Vector3d::UnitZ()};
  return {norm - radius, p / norm};
}

Distance to_box(const Eigen::Vector3d& size, const Eigen::Vector3d& p) noexcept {
  const Eigen::Vector3d q = p.cwiseAbs() - 0.5 * size;  // beyond each pair of faces
  Eigen::Vector3d out;
  for (int i = 0; i < 3; ++i) out[i] = p[i] < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d positive = q.cwiseMax(0.0);
  const double outside = positive.norm();
  if (outside > 0.0) return {outside, positive.cwiseProduct(out) / outside};
  Eigen::Index nearest = 0;
  const double value = q.maxCoeff(&nearest);
  return {value, Eigen::Vector3d::Unit(nearest) * out[nearest]};
}

Distance to_cylinder(const Eigen::Vector3d& size, const Eigen::Vector3d& p) noexcept {
  const double radius = std::hypot(p.x(), p.y());
  const Eigen::Vector2d radial =
      radius > 0.0 ? Eigen::Vector2d(p.head<2>() / radius) : Eigen::Vector2d(1.0, 0.0);
  const double beyond = radius - size.x();
  const double cap = std::abs(p.z()) - 0.5 * size.y();
  const double up = p.z() < 0.0 ? -1.0 : 1.0;
  Eigen::Vector3d n;
  if (beyond > 0.0 && cap > 0.0) {
    const double value = std::hypot(beyond, cap);
    n << beyond / value * radial, up * cap / value;
    return {value, n};
  }
  if (beyond > cap) {
    n << radial, 0.0;
    return {beyond, n};
  }
  return {cap, {0.0, 0.0, up}};
}

}  // namespace

Distance distance_to(const Solid& solid, const Eigen::Vector3d& point) noexcept {
  const double half = 0.5 * solid.size.y();
  switch (solid.shape) {
    case SolidShape::kBox:
      return to_box(solid.size, point);
    case SolidShape::kCylinder:
      return to_cylinder(solid.size, point);
    case SolidShape::kCapsule:
      return from_center({point.x(), point.y(), point.z() - std::clamp(point.z(), -half, half)},
                         solid.size.x());
    case SolidShape::kSphere:
      break;
  }
  return from_center(point, solid.size.x());
}

double bounding_radius(const Solid& solid) noexcept {
  const Eigen::Vector3d& size = solid.size;
  switch (solid.shape) {
    case SolidShape::kBox:
      return 0.5 * size.norm();
    case SolidShape::kCylinder:
      return std::hypot(size.x(), 0.5 * size.y());
    case SolidShape::kCapsule:
      return size.x() + 0.5 * size.y();
    case SolidShape::kSphere:
      break;
  }
  return size.x();
}

Eigen::Matrix3d inertia_of(const Solid& solid, double mass) {
  const Eigen::Vector3d s = solid.size.cwiseAbs2();
  const double r2 = s.x(), l = solid.size.y();
  switch (solid.shape) {
    case SolidShape::kBox:
      return Eigen::Vector3d(mass / 12.0 *
                             Eigen::Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()))
          .asDiagonal();
    case SolidShape::kSphere:
      return Eigen::Vector3d::Constant(0.4 * mass * r2).asDiagonal();
    case SolidShape::kCylinder: {
      const double across = mass * (0.25 * r2 + s.y() / 12.0);
      return Eigen::Vector3d(across, across, 0.5 * mass * r2).asDiagonal();
    }
    case SolidShape::kCapsule:
      break;
  }
  // A cylinder and two half spheres.
  const double tube = l / (l + 4.0 / 3.0 * solid.size.x()) * mass, caps = mass - tube;
  const double across = tube * (0.25 * r2 + s.y() / 12.0) +
                        caps * (0.4 * r2 + 0.25 * s.y() + 0.375 * solid.size.x() * l);
  return Eigen::Vector3d(across, across, 0.5 * tube * r2 + 0.4 * caps * r2).asDiagonal();
}

std::vector<Probe> probes_of(const Solid& solid) {
  std::vector<Probe> probes;
  const Eigen::Vector3d& size = solid.size;
  const double half = 0.5 * size.y();
  const auto spine = [&](double reach) {
    for (int i = 0; i < kSpinePoints; ++i) {
      probes.push_back({{0.0, 0.0, reach * (2.0 * i / (kSpinePoints - 1) - 1.0)}, size.x()});
    }
  };
  switch (solid.shape) {
    case SolidShape::kBox:
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d sign(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
        probes.push_back({sign.cwiseProduct(size), 0.0});
      }
      break;
    case SolidShape::kSphere:
      probes.push_back({Eigen::Vector3d::Zero(), size.x()});
      break;
    case SolidShape::kCapsule:
      spine(half);
      break;
    case SolidShape::kCylinder:
      for (int i = 0; i < 2 * kRimPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i / 2) / kRimPoints;
        probes.push_back(
            {{size.x() * std::cos(angle), size.x() * std::sin(angle), i % 2 == 0 ? half : -half},
             0.0});
      }
      if (half > size.x()) spine(half - size.x());
      break;
  }
  return probes;
}

}  // namespace twinbus::sim
