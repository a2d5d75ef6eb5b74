#include "sim/contact/contact_law.h"

#include <cmath>

namespace twinbus::inline sim {

namespace {

struct Normal {
  double force = 0.0;
  double slope = 0.0;  // -d force / d vn
};

Normal normal_force(const ContactParams& p, double depth, double vn, double h, double smooth) {
  Normal result;
  double end = depth - h * vn;
  double hs = h;  // -d end / d vn
  if (smooth > 0.0) {
    const double e = smooth / p.stiffness;
    const double root = std::sqrt(end * end + e * e);
    hs *= 0.5 * (1.0 + end / root);
    end = 0.5 * (end + root);
  }
  if (!(end > 0.0)) return result;
  if (end < p.ramp) {
    const double by_depth = p.damping / p.ramp;
    const double factor = p.stiffness - by_depth * vn;
    if (!(factor > 0.0)) return result;
    result.force = end * factor;
    result.slope = hs * factor + end * by_depth;
  } else {
    result.force = p.stiffness * end - p.damping * vn;
    result.slope = hs * p.stiffness + p.damping;
    if (!(result.force > 0.0)) result = {};
  }
  return result;
}

// limit / max(size, limit), the maximum rounded off.
void rounded_slip(double beta, double mu, const Normal& fn, double smooth, const Eigen::Vector3d& n,
                  const Eigen::Vector3d& trial, ContactForce& out) {
  const double size = trial.norm();
  const double limit = mu * fn.force;
  const double gap = size - limit;
  const double root = std::sqrt(gap * gap + smooth * smooth);
  const double most = 0.5 * (size + limit + root);
  const double by_size = 0.5 * (1.0 + gap / root), by_limit = 0.5 * (1.0 - gap / root);
  const double ratio = limit / most;
  out.force = fn.force * n + ratio * trial;
  out.mode = ContactMode::kSlip;
  const double d_size = -limit * by_size / (most * most);
  const double d_limit = 1.0 / most - limit * by_limit / (most * most);
  out.tangent = (fn.slope - beta * ratio) * n * n.transpose() +
                mu * fn.slope * d_limit * trial * n.transpose();
  if (size > 0.0) out.tangent += beta * d_size / size * trial * trial.transpose();
  out.tangent.diagonal().array() += beta * ratio;
}

}  // namespace

void contact_force(const ContactParams& p, double depth, const Eigen::Vector3d& n,
                   const Eigen::Vector3d& stretch, const Eigen::Vector3d& v, double h,
                   bool with_tangent, double smooth, ContactForce& out) noexcept {
  const double vn = n.dot(v);
  const Normal fn = normal_force(p, depth, vn, h, smooth);
  if (!(fn.force > 0.0)) {
    out.force.setZero();
    out.mode = ContactMode::kOpen;
    if (with_tangent) out.tangent.setZero();
    return;
  }
  const double beta = p.tangent_damping + h * p.tangent_stiffness;
  const Eigen::Vector3d trial = -p.tangent_stiffness * stretch - beta * (v - vn * n);
  if (smooth > 0.0) {
    rounded_slip(beta, p.friction, fn, smooth, n, trial, out);
    return;
  }
  const double square = trial.squaredNorm();
  const double limit = p.friction * fn.force;
  if (square <= limit * limit) {
    out.force = fn.force * n + trial;
    out.mode = ContactMode::kStick;
    if (!with_tangent) return;
    const Eigen::Vector3d along = (fn.slope - beta) * n;
    for (int k = 0; k < 3; ++k) out.tangent.col(k) = along * n[k];
    out.tangent.diagonal().array() += beta;
    return;
  }
  const double size = std::sqrt(square);
  const Eigen::Vector3d t = trial / size;
  out.force = fn.force * n + limit * t;
  out.mode = ContactMode::kSlip;
  if (!with_tangent) return;
  const double alpha = beta * limit / size;
  const Eigen::Vector3d along = (fn.slope - alpha) * n, held = alpha * t;
  const Eigen::Vector3d dragged = p.friction * fn.slope * t;
  for (int k = 0; k < 3; ++k) out.tangent.col(k) = along * n[k] - held * t[k] + dragged * n[k];
  out.tangent.diagonal().array() += alpha;
}

TurningMoment turning_moment(const ContactParams& p, const Eigen::Vector3d& n, const Eigen::Vector3d& turned,
                             const Eigen::Vector3d& w, double press, double steep, double h) noexcept {
  TurningMoment out;
  const double beta = turning_damping(p) + h * turning_stiffness(p);
  const Eigen::Vector3d trial = -turning_stiffness(p) * turned - beta * w;
  const Eigen::Matrix3d spins = n * n.transpose(), rolls = Eigen::Matrix3d::Identity() - spins;
  const auto add = [&](const Eigen::Matrix3d& part, double share) {
    const Eigen::Vector3d held = part * trial;
    const double size = held.norm(), limit = share * press;
    if (!(share > 0.0)) return;
    if (size <= limit) {
      out.moment += held;
      out.by_turning += beta * part;
      return;
    }
    const Eigen::Vector3d t = held / size;
    out.moment += limit * t;
    out.by_turning += beta * limit / size * (part - t * t.transpose());
    out.by_moving += share * steep * t * n.transpose();
  };
  add(rolls, p.rolling);
  add(spins, p.torsional);
  return out;
}

Eigen::Vector3d turned_after(const ContactParams& p, const Eigen::Vector3d& turned, const Eigen::Vector3d& moment,
                             double h) noexcept {
  const double stiffness = turning_stiffness(p);
  const double beta = turning_damping(p) + h * stiffness;
  return turned - h / beta * (moment + stiffness * turned);
}

void tie_force(const ContactParams& p, const Eigen::Vector3d* along, const Eigen::Vector3d& stretch,
               const Eigen::Vector3d& v, double h, bool with_tangent, ContactForce& out) noexcept {
  const double beta = p.damping + h * p.stiffness;
  out.mode = ContactMode::kStick;
  out.force = -p.stiffness * stretch - beta * v;
  if (along != nullptr) out.force = *along * along->dot(out.force);
  if (!with_tangent) return;
  out.tangent = along != nullptr ? Eigen::Matrix3d(beta * *along * along->transpose())
                                 : Eigen::Matrix3d(beta * Eigen::Matrix3d::Identity());
}

}  // namespace twinbus::sim
