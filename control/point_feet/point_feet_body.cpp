#include "control/point_feet/point_feet_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "robot/description/link_points.h"

namespace twinbus::inline control {

namespace {
constexpr double kLevel = 0.15;  // of the plane of the feet [rad]
constexpr double kTurns = 13.0;  // more than twice round [rad]
constexpr double kRound = 0.2;   // the middle of a wheel from its axis, in radii at most
constexpr double kInside = 0.15; // the centre of mass, from the middle, in shares of the half length at most 1 - this

Eigen::Matrix3d inertia_about_com(const Model& model, const Kinematics& k) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[at(i)];
    const Eigen::Matrix3d r = k.link_in_world(i).linear();
    const Eigen::Vector3d d = k.com_of_link(i) - k.com();
    sum += r * link.inertia * r.transpose() + link.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  return sum;
}

// What the joint moves turns on and on about its own middle.
bool is_wheel(const Model& model, int j) {
  const Joint& joint = model.joints[at(j)];
  if (joint.kind == JointKind::kPrismatic || !(joint.upper - joint.lower > kTurns)) return false;
  Eigen::AlignedBox3d box;
  double radius = 0.0;
  for (const Eigen::Vector3d& point : link_points(model.links[at(joint.child)])) {
    const Eigen::Vector3d from_axis = point - point.dot(joint.axis) * joint.axis;
    box.extend(from_axis);
    radius = std::max(radius, from_axis.norm());
  }
  return radius > 0.0 && box.center().norm() < kRound * radius;
}
}  // namespace

PointFeetBody::PointFeetBody(const Model& model) {
  if (!stands_on_points(model)) throw std::runtime_error("its base is fixed, or it has soles");
  StandingFeet feet(model);
  const char* why = nullptr;
  std::optional<PointLegs> found = point_legs(model, feet, &why);
  if (!found) throw std::runtime_error(why);
  legs = std::move(*found);
  for (const PointLeg& leg : legs) {
    const Joint& last = model.joints[at(leg.joints.back())];
    if (two() && is_wheel(model, leg.joints.back()))
      throw std::runtime_error("its feet are wheels (joint " + last.name + " turns on and on), and it balances by driving them, which we do not");
  }
  const double each = 1.0 / static_cast<double>(legs.size());
  Configuration c(model, "half_sitting");
  for (int j = 0; model.find_pose("half_sitting") < 0 && j < model.joint_count(); ++j)
    c.q[j] = std::clamp(0.0, model.joints[at(j)].lower, model.joints[at(j)].upper);
  Kinematics k(model);
  k.update(c);
  feet.place(k, Eigen::Matrix3d::Identity());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Eigen::Vector3d point = feet.point(legs[i].foot);
    radius[i] = feet.radius(legs[i].foot);
    centre[i] = k.link_in_world(legs[i].link).inverse() * (point + radius[i] * Eigen::Vector3d::UnitZ());
    stance[i] = (point - k.com()).head<2>();
    middle += each * point;
    reach = std::max(reach, leg_length(model, legs[i], feet));
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    length += (i < 2 ? each : -each) * stance[i].x();
    width += (i % 2 == 0 ? each : -each) * stance[i].y();
  }
  if (two()) length = width;
  posture = c.q;
  com_in_base = k.com();
  height = k.com().z() - middle.z();
  mass = model.total_mass();
  inertia = inertia_about_com(model, k);
  if (!(length > 0.0 && width > 0.0 && height > 0.0))
    throw std::runtime_error("in half_sitting its feet are not below it, left and right of each other, and of four two before and two behind");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (std::abs(feet.point(legs[i].foot).z() - middle.z()) > std::tan(kLevel) * length)
      throw std::runtime_error("in half_sitting its feet are not on one plane below a level trunk");
  }
  if (std::abs((middle - k.com()).x()) > (1.0 - kInside) * length || std::abs((middle - k.com()).y()) > (1.0 - kInside) * width)
    throw std::runtime_error("in half_sitting its centre of mass is not above its feet");
}

const char* why_no_point_feet(const Model& model) noexcept {
  try {
    const PointFeetBody body(model);
    return nullptr;
  } catch (const std::exception& error) {
    static thread_local std::string said;
    said = error.what();
    return said.c_str();
  }
}

}  // namespace twinbus::control
