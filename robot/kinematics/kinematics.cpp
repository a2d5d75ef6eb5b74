#include "robot/kinematics/kinematics.h"

#include <algorithm>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

Configuration::Configuration(const Model& model)
    : q(Eigen::VectorXd::Zero(model.joint_count())),
      qd(Eigen::VectorXd::Zero(model.joint_count())) {}

Configuration::Configuration(const Model& model, const std::string& pose) : Configuration(model) {
  const int found = model.find_pose(pose);
  for (int j = 0; found >= 0 && j < model.joint_count(); ++j) q[j] = model.poses[at(found)].q[at(j)];
}

void set_joints(const Model& model, const RobotState& state,
                Configuration& configuration) noexcept {
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    configuration.q[model.bus_joints[k]] = state.q[k];
    configuration.qd[model.bus_joints[k]] = static_cast<double>(state.qd[k]);
  }
  set_mimics(model, configuration);
}

void set_mimics(const Model& model, Configuration& configuration) noexcept {
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    if (joint.mimic < 0) continue;
    configuration.q[j] = joint.mimic_multiplier * configuration.q[joint.mimic] + joint.mimic_offset;
    configuration.qd[j] = joint.mimic_multiplier * configuration.qd[joint.mimic];
  }
}

Kinematics::Kinematics(const Model& model)
    : model_(&model),
      links_(model.links.size()),
      masses_(model.links.size()),
      hinges_(model.joints.size()),
      angle_((model.joints.size() + 3) / 4 * 4, 0.0),
      sine_(angle_.size(), 0.0),
      cosine_(angle_.size(), 1.0),
      subtree_mass_(model.links.size(), 0.0),
      subtree_moment_(model.links.size()),
      mass_(model.total_mass()) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    subtree_mass_[i] = masses_[i].mass = link.mass;
    masses_[i].com.value = link.com;
    for (int c = 0; c < 3; ++c) masses_[i].inertia[c].value = link.inertia.col(c);
  }
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    subtree_mass_[at(model.links[i].parent)] += subtree_mass_[i];
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    Hinge& hinge = hinges_[j];
    hinge.parent = joint.parent;
    hinge.offset.value = joint.placement.translation();
    hinge.axis.value = joint.axis;
    hinge.turned = joint.placement.linear() != Eigen::Matrix3d::Identity();
    for (int c = 0; c < 3; ++c) hinge.placement[c].value = joint.placement.linear().col(c);
    hinge.turn = joint.kind == JointKind::kPrismatic ? Turn::kSlides : Turn::kAny;
    for (int c = 0; c < 3 && hinge.turn == Turn::kAny; ++c) {
      if (std::abs(joint.axis[c]) != 1.0) continue;
      hinge.turn = c == 0 ? Turn::kX : c == 1 ? Turn::kY : Turn::kZ;
      hinge.sign = joint.axis[c];
    }
  }
  update(Configuration(model));
}

// Angles that are what they were keep their sines.
TWINBUS_AVX2_CLONES
void Kinematics::sines(const Configuration& configuration) noexcept {
  const std::size_t n = model_->joints.size();
  const double* q = configuration.q.data();
  for (std::size_t k = 0; k < n; k += 4) {
    const std::size_t end = std::min(n, k + 4);
    bool same = true, large = false;
    for (std::size_t j = k; j < end; ++j) {
      same = same && q[j] == angle_[j];
      large = large || !(std::abs(q[j]) <= kMostAngle);
      angle_[j] = q[j];
    }
    if (same) continue;
    if (large) {
      for (std::size_t j = k; j < end; ++j) {
        sine_[j] = std::sin(q[j]);
        cosine_[j] = std::cos(q[j]);
      }
      continue;
    }
    Vec4 s, c;
    sine_cosine(load4(&angle_[k]), s, c);
    store4(&sine_[k], s);
    store4(&cosine_[k], c);
  }
}

// A coordinate axis turns two columns into each other: b' = c b + s e, e' = c e - s b.
TWINBUS_INLINE static void mix(Vec4& b, Vec4& e, double s, double c) noexcept {
  const Vec4 turned = b * c + e * s;
  e = e * c - b * s;
  b = turned;
}

// The link that joint j moves, from its parent's state.
TWINBUS_INLINE void Kinematics::move_link(std::size_t j, double q, double qd) noexcept {
  const Hinge& hinge = hinges_[j];
  const LinkState& parent = links_[at(hinge.parent)];
  LinkState& child = links_[j + 1];
  const double* from = parent.pose.matrix().data();
  Columns r = columns(from, 4);
  Vec4 arm = r.times(hinge.offset.value.data());
  if (hinge.turned) {
    r = {r.times(hinge.placement[0].value.data()), r.times(hinge.placement[1].value.data()),
         r.times(hinge.placement[2].value.data())};
  }
  const double s = sine_[j], c = cosine_[j];
  Vec4 axis{};
  switch (hinge.turn) {
    case Turn::kX:
      axis = r.x * hinge.sign;
      mix(r.y, r.z, hinge.sign * s, c);
      break;
    case Turn::kY:
      axis = r.y * hinge.sign;
      mix(r.z, r.x, hinge.sign * s, c);
      break;
    case Turn::kZ:
      axis = r.z * hinge.sign;
      mix(r.x, r.y, hinge.sign * s, c);
      break;
    case Turn::kAny: {
      // Rodrigues: column k becomes c r_k + s (axis x r_k) + (1 - c) a_k axis.
      axis = r.times(hinge.axis.value.data());
      const double* a = hinge.axis.value.data();
      const Vec4 t = axis * (1.0 - c), u = axis * s;
      r = {r.x * c + cross4(u, r.x) + t * a[0], r.y * c + cross4(u, r.y) + t * a[1],
           r.z * c + cross4(u, r.z) + t * a[2]};
      break;
    }
    case Turn::kSlides:
      axis = r.times(hinge.axis.value.data());
      arm += axis * q;
      break;
  }
  const Vec4 omega = load(parent.omega);
  const Vec4 velocity = load(parent.velocity) + cross4(omega, arm);
  const Vec4 speed = axis * qd;
  const bool slides = hinge.turn == Turn::kSlides;
  store(child.axis, axis);
  store(child.omega, slides ? omega : omega + speed);
  store(child.velocity, slides ? velocity + speed : velocity);
  double* to = child.pose.matrix().data();
  store4(to, r.x);
  store4(to + 4, r.y);
  store4(to + 8, r.z);
  store4(to + 12, load4(from + 12) + arm);
}

TWINBUS_AVX2_CLONES
void Kinematics::move_links(const std::vector<int>& joints, const double* q,
                            const double* qd) noexcept {
  for (const int j : joints) move_link(at(j), q[j], qd[j]);
}

TWINBUS_AVX2_CLONES
void Kinematics::move_links(const double* q, const double* qd) noexcept {
  for (std::size_t j = 0; j < hinges_.size(); ++j) move_link(j, q[j], qd[j]);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    LinkState& link = links_[i];
    const double* pose = link.pose.matrix().data();
    const LinkMass& of = masses_[i];
    const Vec4 com = load4(pose + 12) + columns(pose, 4).times(of.com.value.data());
    store(link.com, com);
    store(subtree_moment_[i], com * of.mass);
  }
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    PaddedVector& parent = subtree_moment_[at(hinges_[i - 1].parent)];
    store(parent, load(parent) + load(subtree_moment_[i]));
  }
}

void Kinematics::move_base(const Configuration& configuration) noexcept {
  LinkState& base = links_[0];
  base.pose = configuration.base;
  base.omega.value = configuration.base_angular_velocity;
  base.velocity.value = configuration.base_velocity;
}

void Kinematics::update(const Configuration& configuration) noexcept {
  move_base(configuration);
  sines(configuration);
  move_links(configuration.q.data(), configuration.qd.data());
  com_ = (mass_ > 0.0 ? 1.0 / mass_ : 0.0) * subtree_moment_[0].value;
}

void Kinematics::update(const Configuration& configuration,
                        const std::vector<int>& joints) noexcept {
  move_base(configuration);
  sines(configuration);
  move_links(joints, configuration.q.data(), configuration.qd.data());
}

TWINBUS_AVX2_CLONES
Kinematics::Momentum Kinematics::momentum() const noexcept {
  Vec4 linear{}, angular{};
  const Vec4 centre = vec4(com_);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const LinkState& link = links_[i];
    const LinkMass& of = masses_[i];
    const Columns turn = columns(link.pose.matrix().data(), 4);
    const Vec4 omega = load(link.omega);
    const Columns inertia{load(of.inertia[0]), load(of.inertia[1]), load(of.inertia[2])};
    const Vec4 own = inertia.times(dot3(turn.x, omega), dot3(turn.y, omega), dot3(turn.z, omega));
    const Vec4 arm = load(link.com) - load4(link.pose.matrix().data() + 12);
    const Vec4 push = (load(link.velocity) + cross4(omega, arm)) * of.mass;
    linear += push;
    angular += cross4(load(link.com) - centre, push) + turn.times(own);
  }
  return {(mass_ > 0.0 ? 1.0 / mass_ : 0.0) * vector3(linear), vector3(angular)};
}

Eigen::Vector3d Kinematics::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  const LinkState& of = state(link);
  return of.velocity.value + of.omega.value.cross(point - of.pose.translation());
}

TWINBUS_AVX2_CLONES
void Kinematics::point_jacobian(int link, const Eigen::Vector3d& point,
                                Eigen::MatrixXd& jacobian) const noexcept {
  std::memset(jacobian.data(), 0, static_cast<std::size_t>(jacobian.size()) * sizeof(double));
  double* out = jacobian.data();
  const Vec4 to = vec4(point);
  const Eigen::Vector3d arm = point - links_[0].pose.translation();
  out[0] = out[7] = out[14] = out[21] = out[28] = out[35] = 1.0;
  out[19] = -arm.z();
  out[20] = arm.y();
  out[24] = arm.z();
  out[26] = -arm.x();
  out[30] = -arm.y();
  out[31] = arm.x();
  for (int i = link; i > 0; i = hinges_[at(i) - 1].parent) {
    const LinkState& of = state(i);
    const Vec4 axis = load(of.axis);
    double column[8];
    if (hinges_[at(i) - 1].turn == Turn::kSlides) {
      store4(column, axis);
      store4(column + 3, Vec4{});
    } else {
      store4(column, cross4(axis, to - load4(of.pose.matrix().data() + 12)));
      store4(column + 3, axis);
    }
    std::memcpy(out + 6 * (5 + i), column, 6 * sizeof(double));
  }
}

TWINBUS_AVX2_CLONES
void Kinematics::com_jacobian(Eigen::MatrixXd& jacobian) const noexcept {
  const double inverse_mass = mass_ > 0.0 ? 1.0 / mass_ : 0.0;
  jacobian.block<3, 3>(0, 0).setIdentity();
  jacobian.block<3, 3>(0, 3) = -skew(com_ - links_[0].pose.translation());
  double* out = jacobian.data() + 18;
  for (std::size_t j = 0; j < hinges_.size(); ++j, out += 3) {
    const LinkState& of = links_[j + 1];
    const double share = inverse_mass * subtree_mass_[j + 1];
    const Vec4 axis = load(of.axis);
    Vec4 column = axis * share;
    if (hinges_[j].turn != Turn::kSlides) {
      column = cross4(axis, load(subtree_moment_[j + 1]) * inverse_mass -
                                load4(of.pose.matrix().data() + 12) * share);
    }
    if (j + 1 < hinges_.size()) {
      store4(out, column);  // lane 3 is written over by the next column
    } else {
      std::memcpy(out, &column, 3 * sizeof(double));
    }
  }
}

}  // namespace twinbus::robot
