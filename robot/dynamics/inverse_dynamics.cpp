#include "robot/dynamics/inverse_dynamics.h"

#include "common/math/index.h"
#include "robot/dynamics/spatial_force.h"

namespace twinbus::inline robot {

InverseDynamics::InverseDynamics(const Model& model) : parts_(model.links.size()) {
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const Joint& joint = model.joints[i - 1];
    parts_[i].parent = joint.parent;
    parts_[i].rotor = joint.rotor_inertia;
    parts_[i].slides = joint.kind == JointKind::kPrismatic;
  }
}

TWINBUS_INLINE static Vec4 origin_of(const LinkState& link) noexcept {
  return load4(link.pose.matrix().data() + 12);
}

TWINBUS_AVX2_CLONES
void InverseDynamics::outward(const Kinematics& kinematics, const double* qd,
                              const double* qdd) noexcept {
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const Part& above = parts_[at(part.parent)];
    const LinkState& link = kinematics.state(static_cast<int>(i));
    const LinkState& parent = kinematics.state(part.parent);
    const Vec4 omega = load(parent.omega), spin = load(above.spin), axis = load(link.axis);
    const Vec4 arm = origin_of(link) - origin_of(parent);
    const Vec4 turn = cross4(omega, axis * qd[i - 1]);
    const Vec4 along = axis * qdd[i - 1];
    const Vec4 acceleration =
        load(above.acceleration) + cross4(spin, arm) + cross4(omega, cross4(omega, arm));
    store(part.acceleration, part.slides ? acceleration + turn * 2.0 + along : acceleration);
    store(part.spin, part.slides ? spin : spin + turn + along);
  }
  // F = m a of the centre of mass, N = I alpha + omega x I omega.
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const LinkState& link = kinematics.state(static_cast<int>(i));
    const Columns inertia = turned_inertia(kinematics, static_cast<int>(i));
    const Vec4 omega = load(link.omega), spin = load(part.spin);
    const Vec4 c = load(link.com) - origin_of(link);
    const Vec4 force =
        (load(part.acceleration) + cross4(spin, c) + cross4(omega, cross4(omega, c))) *
        kinematics.mass_of(static_cast<int>(i)).mass;
    store(part.force, force);
    store(part.torque,
          inertia.times(spin) + cross4(omega, inertia.times(omega)) + cross4(c, force));
  }
}

TWINBUS_AVX2_CLONES
void InverseDynamics::inward(const Kinematics& kinematics, const double* qdd,
                             double* tau) noexcept {
  for (std::size_t i = parts_.size() - 1; i > 0; --i) {
    const Part& part = parts_[i];
    Part& parent = parts_[at(part.parent)];
    const LinkState& link = kinematics.state(static_cast<int>(i));
    const Vec4 force = load(part.force), torque = load(part.torque);
    tau[i - 1] = dot3(load(link.axis), part.slides ? force : torque) + part.rotor * qdd[i - 1];
    const Vec4 arm = origin_of(link) - origin_of(kinematics.state(part.parent));
    store(parent.force, load(parent.force) + force);
    store(parent.torque, load(parent.torque) + torque + cross4(arm, force));
  }
}

// Everything in world axes; moments of a link about its origin.  Gravity enters as an acceleration
// of the base upwards.
Eigen::Matrix<double, 6, 1> InverseDynamics::solve(
    const Kinematics& kinematics, const Configuration& configuration, const Eigen::VectorXd& qdd,
    const Eigen::Vector3d& base_acceleration, const Eigen::Vector3d& base_angular_acceleration,
    const std::vector<ExternalWrench>& external, Eigen::VectorXd& tau) noexcept {
  parts_[0].acceleration.value = base_acceleration + kGravity * Eigen::Vector3d::UnitZ();
  parts_[0].spin.value = base_angular_acceleration;
  outward(kinematics, configuration.qd.data(), qdd.data());
  for (const ExternalWrench& wrench : external) {
    if (wrench.link < 0 || wrench.link >= static_cast<int>(parts_.size())) continue;
    Part& part = parts_[at(wrench.link)];
    const Eigen::Vector3d arm = wrench.point - kinematics.link_in_world(wrench.link).translation();
    part.force.value -= wrench.force;
    part.torque.value -= wrench.torque + arm.cross(wrench.force);
  }
  inward(kinematics, qdd.data(), tau.data());
  Eigen::Matrix<double, 6, 1> base;
  base << parts_[0].force.value, parts_[0].torque.value;
  return base;
}

}  // namespace twinbus::robot
