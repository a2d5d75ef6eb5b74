#include "sim/articulated_body.h"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "robot/dynamics.h"

namespace twinbus {

ArticulatedBody::ArticulatedBody(const Model& model, bool fixed_base, double mass_scale)
    : floating_(!fixed_base),
      fixed_(model.links.size()),
      links_(model.links.size()),
      qd_(model.joints.size()) {
  std::vector<int> depth(model.links.size(), 0);
  for (std::size_t i = 0; i < fixed_.size(); ++i) {
    const Link& link = model.links[i];
    Fixed& to = fixed_[i];
    to.mass = link.mass * mass_scale;
    to.com = link.com;
    to.inertia = link.inertia * mass_scale;
    mass_ += to.mass;
    const bool moves = i > 0 || floating_;
    if (moves && (!(link.mass > 0.0) || !(to.inertia.llt().info() == Eigen::Success))) {
      throw std::runtime_error(
          "link '" + link.name +
          "' cannot be simulated: its mass and inertia must be positive; give it an <inertial>");
    }
    if (i == 0) continue;
    const Joint& joint = model.joints[i - 1];
    to.parent = joint.parent;
    depth[i] = depth[static_cast<std::size_t>(joint.parent)] + 1;
    deepest_ = std::max(deepest_, depth[i]);
    to.prismatic = joint.kind == JointKind::kPrismatic;
    to.offset = joint.placement.translation();
    to.axis = joint.axis;
    to.rotor = joint.rotor_inertia;
    const Eigen::Vector3d& a = joint.axis;
    Eigen::Matrix3d hat;
    hat << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    const Eigen::Matrix3d along = a * a.transpose();
    const Eigen::Matrix3d placed = joint.placement.linear();
    to.still = to.prismatic ? placed : Eigen::Matrix3d(placed * along);
    to.swing = placed * (Eigen::Matrix3d::Identity() - along);
    to.turn = placed * hat;
  }
}

void ArticulatedBody::place(const Configuration& configuration) noexcept {
  origin_ = configuration.base.translation();
  LinkWork& root = links_[0];
  root.rotation = configuration.base.linear();
  root.origin.setZero();
  root.velocity = floating_
                      ? spatial(configuration.base_angular_velocity, configuration.base_velocity)
                      : Vec8{};
  root.axis = Vec8{};
  root.coriolis = Vec8{};
  place_inertia(0);
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i) - 1;
    qd_[i - 1] = configuration.qd[joint];
    place_link(i, configuration.q[joint], configuration.qd[joint]);
    place_inertia(i);
  }
}

void ArticulatedBody::place_link(std::size_t i, double q, double qd) noexcept {
  const Fixed& f = fixed_[i];
  LinkWork& link = links_[i];
  const LinkWork& parent = links_[static_cast<std::size_t>(f.parent)];
  link.origin = parent.origin + parent.rotation * f.offset;
  if (f.prismatic) {
    link.rotation = parent.rotation * f.still;
    const Eigen::Vector3d axis = link.rotation * f.axis;
    link.origin += q * axis;
    link.axis = spatial(Eigen::Vector3d::Zero(), axis);
  } else {
    const Eigen::Matrix3d local = f.still + std::cos(q) * f.swing + std::sin(q) * f.turn;
    link.rotation = parent.rotation * local;
    const Eigen::Vector3d axis = link.rotation * f.axis;
    link.axis = spatial(axis, link.origin.cross(axis));
  }
  link.velocity = parent.velocity + link.axis * qd;
  link.coriolis = cross_motion(parent.velocity, link.axis * qd);
}

// With l = m (v + w x C) and n = Ic w + C x l, C the centre of mass about O:
//     bias = ( w x n + v x l - C x m g ,  w x l - m g )
void ArticulatedBody::place_inertia(std::size_t i) noexcept {
  const Fixed& f = fixed_[i];
  LinkWork& link = links_[i];
  const double m = f.mass;
  link.com = link.origin + link.rotation * f.com;
  const Eigen::Vector3d& C = link.com;
  const Eigen::Matrix3d half = link.rotation * f.inertia;
  Eigen::Matrix3d inertia = half * link.rotation.transpose();

  const Eigen::Vector3d w = angular(link.velocity);
  const Eigen::Vector3d v = linear(link.velocity);
  const Eigen::Vector3d l = m * (v + w.cross(C));
  const Eigen::Vector3d n = inertia * w + C.cross(l);
  const Eigen::Vector3d weight(0.0, 0.0, -m * kGravity);
  link.rigid_bias = spatial(w.cross(n) + v.cross(l) - C.cross(weight), w.cross(l) - weight);

  const double x = m * C[0], y = m * C[1], z = m * C[2];
  const double xx = inertia(0, 0) + y * C[1] + z * C[2];
  const double yy = inertia(1, 1) + x * C[0] + z * C[2];
  const double zz = inertia(2, 2) + x * C[0] + y * C[1];
  const double xy = inertia(1, 0) - x * C[1];
  const double xz = inertia(2, 0) - x * C[2];
  const double yz = inertia(2, 1) - y * C[2];
  link.rigid[0] = Vec8{xx, xy, xz, 0, -z, y, 0, 0};
  link.rigid[1] = Vec8{xy, yy, yz, z, 0, -x, 0, 0};
  link.rigid[2] = Vec8{xz, yz, zz, -y, x, 0, 0, 0};
  link.rigid[3] = Vec8{0, z, -y, m, 0, 0, 0, 0};
  link.rigid[4] = Vec8{-z, 0, x, 0, m, 0, 0, 0};
  link.rigid[5] = Vec8{y, -x, 0, 0, 0, m, 0, 0};
}

void ArticulatedBody::add_force(int link, const Eigen::Vector3d& r,
                                const Eigen::Vector3d& force) noexcept {
  links_[static_cast<std::size_t>(link)].rigid_bias -= force_at(r, force);
}

// rigid += J(r)' weight J(r); column k is J' weight (J e_k).
void ArticulatedBody::add_compliance(int link, const Eigen::Vector3d& r,
                                     const Eigen::Matrix3d& weight) noexcept {
  Vec8(&rigid)[6] = links_[static_cast<std::size_t>(link)].rigid;
  const Eigen::Vector3d x = weight.col(0), y = weight.col(1), z = weight.col(2);
  rigid[0] += force_at(r, z * r[1] - y * r[2]);
  rigid[1] += force_at(r, x * r[2] - z * r[0]);
  rigid[2] += force_at(r, y * r[0] - x * r[1]);
  rigid[3] += force_at(r, x);
  rigid[4] += force_at(r, y);
  rigid[5] += force_at(r, z);
}

TWINBUS_VECTOR_CLONES
bool ArticulatedBody::inward(const std::vector<JointRow>& rows, double h) noexcept {
  for (LinkWork& link : links_) {
    for (int k = 0; k < 6; ++k) link.inertia[k] = link.rigid[k];
    link.bias = link.rigid_bias;
  }
  bool sound = true;
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    LinkWork& link = links_[i];
    const JointRow& row = rows[i - 1];
    const Vec8 S = link.axis;
    const Vec8 U = times(link.inertia, S);
    const double D = dot(S, U) + fixed_[i].rotor + h * row.gain;
    sound = sound && D > 0.0;
    link.inverse_d = 1.0 / D;
    link.inertia_axis = U;
    link.u = row.force - row.gain * qd_[i - 1] - dot(S, link.bias);

    LinkWork& parent = links_[static_cast<std::size_t>(fixed_[i].parent)];
    const Vec8 Ud = U * link.inverse_d;
    const Vec8 c = link.coriolis;
    Vec8 bias = link.bias + Ud * link.u;
    for (int k = 0; k < 6; ++k) {
      const Vec8 column = link.inertia[k] - Ud * U[k];
      parent.inertia[k] += column;
      bias += column * c[k];
    }
    parent.bias += bias;
  }
  return (!floating_ || factor_root()) && sound;
}

bool ArticulatedBody::factor_root() noexcept {
  bool sound = true;
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r) {
      double sum = links_[0].inertia[c][r];
      for (int k = 0; k < c; ++k) sum -= root_[r][k] * root_[c][k];
      if (r == c) {
        sound = sound && sum > 0.0;
        root_[c][c] = std::sqrt(sum);
        root_inverse_[c] = 1.0 / root_[c][c];
      } else {
        root_[r][c] = sum * root_inverse_[c];
      }
    }
  }
  return sound;
}

void ArticulatedBody::solve_root(double (&x)[6]) const noexcept {
  for (int r = 0; r < 6; ++r) {
    for (int k = 0; k < r; ++k) x[r] -= root_[r][k] * x[k];
    x[r] *= root_inverse_[r];
  }
  for (int r = 5; r >= 0; --r) {
    for (int k = r + 1; k < 6; ++k) x[r] -= root_[k][r] * x[k];
    x[r] *= root_inverse_[r];
  }
}

TWINBUS_VECTOR_CLONES
void ArticulatedBody::outward() noexcept {
  links_[0].acceleration = Vec8{};
  if (floating_) {
    double x[6];
    for (int r = 0; r < 6; ++r) x[r] = -links_[0].bias[r];
    solve_root(x);
    links_[0].acceleration = Vec8{x[0], x[1], x[2], x[3], x[4], x[5], 0.0, 0.0};
  }
  for (std::size_t i = 1; i < links_.size(); ++i) {
    LinkWork& link = links_[i];
    const Vec8 base =
        links_[static_cast<std::size_t>(fixed_[i].parent)].acceleration + link.coriolis;
    link.qdd = link.inverse_d * (link.u - dot(link.inertia_axis, base));
    link.acceleration = base + link.axis * link.qdd;
  }
}

TWINBUS_VECTOR_CLONES
void ArticulatedBody::add_wrench(int index, const Vec8& wrench) noexcept {
  Vec8 e = wrench;
  for (auto i = static_cast<std::size_t>(index); i > 0;
       i = static_cast<std::size_t>(fixed_[i].parent)) {
    LinkWork& link = links_[i];
    const double s = dot(link.axis, e);
    link.u += s;
    e -= link.inertia_axis * (s * link.inverse_d);
  }
  links_[0].bias -= e;
}

TWINBUS_VECTOR_CLONES
int ArticulatedBody::response(int index, ResponseRow* rows) const noexcept {
  Vec8 E[6];
  for (int r = 0; r < 6; ++r) {
    E[r] = Vec8{};
    E[r][r] = 1.0;
  }
  int count = 0;
  for (auto i = static_cast<std::size_t>(index); i > 0;
       i = static_cast<std::size_t>(fixed_[i].parent)) {
    const LinkWork& link = links_[i];
    const Vec8 s = times(E, link.axis);
    rows[count++] = {s * std::sqrt(link.inverse_d), static_cast<int>(i)};
    for (int r = 0; r < 6; ++r) E[r] -= s * (link.inertia_axis[r] * link.inverse_d);
  }
  if (!floating_) return count;
  for (int r = 0; r < 6; ++r) {
    for (int k = 0; k < r; ++k) E[r] -= E[k] * root_[r][k];
    E[r] *= root_inverse_[r];
    rows[count++] = {E[r], -r};
  }
  return count;
}

// In root axes the derivative of the root's velocity is the acceleration itself: no extra w x v.
void ArticulatedBody::advance(double h, Configuration& to) const noexcept {
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i) - 1;
    to.qd[joint] += h * links_[i].qdd;
    to.q[joint] += h * to.qd[joint];
  }
  if (!floating_) return;
  const Vec8& a = links_[0].acceleration;
  const Eigen::Vector3d w = to.base_angular_velocity + h * angular(a);
  const Eigen::Vector3d v = to.base_velocity + h * linear(a);
  to.base.translation() += h * v;
  const double angle = h * w.norm();
  if (!(angle > 0.0)) {
    to.base_velocity = v;
    to.base_angular_velocity = w;
    return;
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, w.normalized()).toRotationMatrix();
  const Eigen::Quaterniond attitude(Eigen::Matrix3d(turn * to.base.linear()));
  to.base.linear() = attitude.normalized().toRotationMatrix();
  to.base_velocity = turn * v;
  to.base_angular_velocity = w;
}

Momentum ArticulatedBody::momentum() const noexcept {
  Vec8 sum = {};
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    sum += times(links_[i].rigid, links_[i].velocity);
    moment += fixed_[i].mass * links_[i].com;
  }
  const Eigen::Vector3d com = moment / mass_;
  return {origin_ + com, linear(sum), angular(sum) - com.cross(linear(sum))};
}

void ArticulatedBody::keep_momentum(const Momentum& wanted, Configuration& to) noexcept {
  const Momentum now = momentum();
  Vec8 columns[6] = {};
  for (const LinkWork& link : links_) {
    for (int k = 0; k < 6; ++k) columns[k] += link.rigid[k];
  }
  Eigen::Matrix<double, 6, 6> inertia;  // of all links as if welded, about O
  for (int k = 0; k < 6; ++k) {
    for (int r = 0; r < 6; ++r) inertia(r, k) = columns[k][r];
  }
  const Eigen::Vector3d com = now.com - origin_;
  const Eigen::Vector3d missing = wanted.linear - now.linear;
  Eigen::Matrix<double, 6, 1> change;
  change << wanted.angular - now.angular + com.cross(missing), missing;
  const Eigen::Matrix<double, 6, 1> motion = inertia.llt().solve(change);
  to.base_angular_velocity += motion.head<3>();
  to.base_velocity += motion.tail<3>();
  to.base.translation() += wanted.com - now.com;
  place(to);
}

}  // namespace twinbus
