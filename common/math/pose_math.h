// Small mathematics of rotations and poses that every room needs, so that nobody writes it again.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace twinbus::inline common {

// Matrix of the cross product: skew(a) b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) noexcept {
  Eigen::Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

// Rotation about a unit axis by an angle [rad].
inline Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle) noexcept {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const Eigen::Vector3d t = (1.0 - c) * axis;
  const Eigen::Vector3d u = s * axis;
  Eigen::Matrix3d m;
  m << t.x() * axis.x() + c, t.x() * axis.y() - u.z(), t.x() * axis.z() + u.y(),  //
      t.x() * axis.y() + u.z(), t.y() * axis.y() + c, t.y() * axis.z() - u.x(),   //
      t.x() * axis.z() - u.y(), t.y() * axis.z() + u.x(), t.z() * axis.z() + c;
  return m;
}

inline Eigen::Matrix3d rotation_z(double yaw) noexcept {
  return rotation_about(Eigen::Vector3d::UnitZ(), yaw);
}

// Rotation vector of a rotation: axis times angle, angle in [0, pi] [rad].
inline Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& r) noexcept {
  Eigen::Quaterniond q(r);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  const double scale = sine > 1e-9 ? 2.0 * std::atan2(sine, q.w()) / sine : 2.0;
  return scale * q.vec();
}

// The inverse: the rotation of a rotation vector.
inline Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector) noexcept {
  const double angle = vector.norm();
  if (!(angle > 1e-12)) return Eigen::Matrix3d::Identity() + skew(vector);
  return rotation_about(vector / angle, angle);
}

// Roll, pitch, yaw of URDF: R = Rz(yaw) Ry(pitch) Rx(roll) [rad].
inline Eigen::Matrix3d rotation_from_rpy(double roll, double pitch, double yaw) noexcept {
  return rotation_z(yaw) * rotation_about(Eigen::Vector3d::UnitY(), pitch) *
         rotation_about(Eigen::Vector3d::UnitX(), roll);
}

// Its inverse.  With the pitch at a right angle only the sum or difference of roll and yaw is in R: the roll is what the yaw leaves.
inline Eigen::Vector3d rpy_from_rotation(const Eigen::Matrix3d& r) noexcept {
  const double level = std::hypot(r(2, 1), r(2, 2)), yaw = std::atan2(r(1, 0), r(0, 0));
  const double s = std::sin(yaw), c = std::cos(yaw);
  const double roll =
      level > 1e-6 ? std::atan2(r(2, 1), r(2, 2)) : std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
  return {roll, std::atan2(-r(2, 0), level), yaw};
}

// Heading of a rotation: where its x axis points, seen from above [rad].
inline double yaw_of(const Eigen::Matrix3d& r) noexcept { return std::atan2(r(1, 0), r(0, 0)); }
// The same of a quaternion as messages have it.
inline double yaw_of(const std::array<double, 4>& q) noexcept {
  return std::atan2(2.0 * (q[0] * q[3] + q[1] * q[2]), 1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]));
}

// The same angle in (-pi, pi] [rad].
inline double wrap_angle(double angle) noexcept {
  return std::remainder(angle, 2.0 * 3.14159265358979323846);
}

// Quaternions of messages are w, x, y, z.
template <class Number>
Eigen::Quaterniond quaternion_from_array(const std::array<Number, 4>& wxyz) noexcept {
  return Eigen::Quaterniond(static_cast<double>(wxyz[0]), static_cast<double>(wxyz[1]),
                            static_cast<double>(wxyz[2]), static_cast<double>(wxyz[3]))
      .normalized();
}

// Unit quaternion with w >= 0.
template <class Number>
std::array<Number, 4> array_from_rotation(const Eigen::Matrix3d& r) noexcept {
  Eigen::Quaterniond q(r);
  q.normalize();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return {static_cast<Number>(sign * q.w()), static_cast<Number>(sign * q.x()),
          static_cast<Number>(sign * q.y()), static_cast<Number>(sign * q.z())};
}

template <class Number>
Eigen::Vector3d vector_from_array(const std::array<Number, 3>& xyz) noexcept {
  return {static_cast<double>(xyz[0]), static_cast<double>(xyz[1]), static_cast<double>(xyz[2])};
}

template <class Number>
std::array<Number, 3> array_from_vector(const Eigen::Vector3d& v) noexcept {
  return {static_cast<Number>(v.x()), static_cast<Number>(v.y()), static_cast<Number>(v.z())};
}

// Upright frame: the position of `pose` with its heading and z up.
inline Eigen::Isometry3d upright(const Eigen::Isometry3d& pose) noexcept {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = rotation_z(yaw_of(pose.linear()));
  frame.translation() = pose.translation();
  return frame;
}

}  // namespace twinbus::common
