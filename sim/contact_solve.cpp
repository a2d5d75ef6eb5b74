#include "sim/contact_solve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace twinbus {

namespace {

constexpr double kStageOne = 1e-9;  // of 1 N + all forces: stage 1 agrees with the law
constexpr double kSettled = 1e-10;  // of 10 N + all forces
constexpr double kForceFloor = 10.0;
constexpr int kMostNewton = 20;

// Solves a x = b in place by elimination with partial pivots; a is row-major n x n.
void eliminate(double* a, double* b, int n) noexcept {
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    for (int r = c + 1; r < n; ++r) {
      if (std::abs(a[r * n + c]) > std::abs(a[pivot * n + c])) pivot = r;
    }
    if (pivot != c) {
      for (int k = c; k < n; ++k) std::swap(a[c * n + k], a[pivot * n + k]);
      std::swap(b[c], b[pivot]);
    }
    const double inverse = 1.0 / a[c * n + c];
    for (int r = c + 1; r < n; ++r) {
      const double factor = a[r * n + c] * inverse;
      if (factor == 0.0) continue;
      for (int k = c + 1; k < n; ++k) a[r * n + k] -= factor * a[c * n + k];
      b[r] -= factor * b[c];
    }
  }
  for (int r = n - 1; r >= 0; --r) {
    for (int k = r + 1; k < n; ++k) b[r] -= a[r * n + k] * b[k];
    b[r] /= a[r * n + r];
  }
}

}  // namespace

ContactSolve::ContactSolve(const ArticulatedBody& body, int most_contacts) {
  const auto links = at(std::min(body.link_count(), most_contacts));
  const auto size = static_cast<Eigen::Index>(6 * links);
  slot_of_link_.assign(at(body.link_count()), -1);
  link_of_slot_.resize(links);
  h_.resize(links);
  curved_.resize(links);
  curved_slots_.reserve(links);
  rows_.resize(links * at(body.most_rows()));
  row_count_.resize(links);
  b_.resize(size, size);
  for (Eigen::VectorXd* v : {&a1_, &a_, &da_, &z_, &best_z_, &rho_, &dz_, &trial_, &b_rho_}) {
    v->setZero(size);
  }
  matrix_.resize(36 * links * links);
  right_.resize(6 * links);
  kinks_.reserve(2 * at(most_contacts));
}

void ContactSolve::fold(ArticulatedBody& body, Contacts& contacts, double h) noexcept {
  for (Contact& c : contacts) {
    contact_force(c.params, c.depth, c.normal, c.stretch, c.v0, h, true, 0.0, c.now);
    c.f0 = c.now.force;
    c.g0 = c.now.tangent;
    if (c.now.mode == ContactMode::kOpen) continue;
    if (c.now.mode == ContactMode::kSlip) {  // inertia is symmetric: normal-to-tangent is left out
      const Eigen::Vector3d column = c.g0 * c.normal;
      c.g0 -= (column - c.normal * c.normal.dot(column)) * c.normal.transpose();
    }
    body.add_compliance(c.link, c.r, h * c.g0);
    body.add_force(c.link, c.r, c.f0);
  }
}

bool ContactSolve::stage_one_holds(const ArticulatedBody& body, Contacts& contacts,
                                   double h) const noexcept {
  double total = 1.0, mismatch = 0.0;
  for (Contact& c : contacts) {
    c.v = c.v0 + h * at_point(body.link(c.link).acceleration, c.r);
    contact_force(c.params, c.depth, c.normal, c.stretch, c.v, h, false, 0.0, c.now);
    total += c.now.force.norm();
    mismatch = std::max(mismatch, (c.now.force - (c.f0 - c.g0 * (c.v - c.v0))).norm());
  }
  return mismatch <= kStageOne * total;
}

void ContactSolve::solve(ArticulatedBody& body, Contacts& contacts, double h) noexcept {
  if (contacts.empty()) return;
  ++counters_.steps;
  if (stage_one_holds(body, contacts, h)) {
    ++counters_.one_pass;
    return;
  }
  find_slots(body, contacts);
  build_response(body);
  z_.head(n_).setZero();
  double merit = evaluate(contacts, h, z_, true);
  bool settled = newton(contacts, h, kMostNewton, 0.0, merit);
  if (!settled) {
    ++counters_.rounded;
    const double force = scale_;
    z_.head(n_).setZero();
    for (double e = 1.0; e > 0.5e-9; e *= 0.1) {
      smooth_ = e * force;
      merit = evaluate(contacts, h, z_, true);
      (void)newton(contacts, h, 6, 1e-3 * e, merit);
    }
    smooth_ = 0.0;
    merit = evaluate(contacts, h, z_, true);
    settled = newton(contacts, h, kMostNewton, 0.0, merit);
  }
  if (!settled && !(rho_.head(n_).norm() <= 1e3 * kSettled * scale_)) ++counters_.unconverged;
  // z - rho are the values of the law, in the cone even if z is not the solution.
  for (int s = 0; s < slots_; ++s) {
    const Vector6 w = z_.segment<6>(6 * s) - rho_.segment<6>(6 * s);
    body.add_wrench(link_of_slot_[at(s)],
                    Screw{Vec4{w[0], w[1], w[2], 0.0}, Vec4{w[3], w[4], w[5], 0.0}});
  }
  body.outward();
}

void ContactSolve::find_slots(const ArticulatedBody& body, const Contacts& contacts) noexcept {
  std::fill(slot_of_link_.begin(), slot_of_link_.end(), -1);
  slots_ = 0;
  for (const Contact& c : contacts) {
    int& slot = slot_of_link_[at(c.link)];
    if (slot >= 0) continue;
    slot = slots_;
    link_of_slot_[at(slots_)] = c.link;
    const Screw& a = body.link(c.link).acceleration;
    for (int r = 0; r < 6; ++r) a1_[6 * slots_ + r] = a[r];
    ++slots_;
  }
  n_ = 6 * slots_;
}

void ContactSolve::build_response(const ArticulatedBody& body) noexcept {
  const int most = body.most_rows();
  for (int s = 0; s < slots_; ++s) {
    row_count_[at(s)] = body.response(link_of_slot_[at(s)], &rows_[at(s * most)]);
  }
  for (int s = 0; s < slots_; ++s) {
    for (int t = s; t < slots_; ++t) {
      // Both lists end with what the links have in common, in falling order.
      Screw columns[6] = {};
      const ResponseRow *a = &rows_[at(s * most)], *b = &rows_[at(t * most)];
      for (int p = 0, q = 0; p < row_count_[at(s)] && q < row_count_[at(t)];) {
        if (a[p].joint == b[q].joint) {
          for (int k = 0; k < 6; ++k) {
            const double factor = b[q].row[k];
            columns[k].w += a[p].row.w * factor;
            columns[k].v += a[p].row.v * factor;
          }
          ++p, ++q;
        } else if (a[p].joint > b[q].joint) {
          ++p;
        } else {
          ++q;
        }
      }
      for (int k = 0; k < 6; ++k) {
        for (int r = 0; r < 6; ++r) {
          b_(6 * s + r, 6 * t + k) = b_(6 * t + k, 6 * s + r) = columns[k][r];
        }
      }
    }
  }
}

Eigen::Vector3d ContactSolve::velocity_of(const Contact& c, const Eigen::VectorXd& acceleration,
                                          double h) const noexcept {
  const double* a = acceleration.data() + 6 * slot_of_link_[at(c.link)];
  const Eigen::Vector3d& r = c.r;
  return h * Eigen::Vector3d(a[3] + a[1] * r[2] - a[2] * r[1], a[4] + a[2] * r[0] - a[0] * r[2],
                             a[5] + a[0] * r[1] - a[1] * r[0]);
}

double ContactSolve::evaluate(Contacts& contacts, double h, const Eigen::VectorXd& z,
                              bool with_tangent) noexcept {
  const auto b = b_.topLeftCorner(n_, n_);
  a_.head(n_).noalias() = b * z.head(n_);
  a_.head(n_) += a1_.head(n_);
  rho_.head(n_) = z.head(n_);
  scale_ = kForceFloor;
  if (with_tangent) {
    std::fill(curved_.begin(), curved_.end(), 0);
    for (int s = 0; s < slots_; ++s) h_[at(s)].setZero();
  }
  for (Contact& c : contacts) {
    const int slot = slot_of_link_[at(c.link)];
    c.v = c.v0 + velocity_of(c, a_, h);
    contact_force(c.params, c.depth, c.normal, c.stretch, c.v, h, with_tangent, smooth_, c.now);
    const Eigen::Vector3d extra = c.now.force - (c.f0 - c.g0 * (c.v - c.v0));
    scale_ += c.now.force.norm();
    rho_.segment<3>(6 * slot) -= c.r.cross(extra);
    rho_.segment<3>(6 * slot + 3) -= extra;
    if (!with_tangent) continue;
    const Eigen::Matrix3d g = h * (c.now.tangent - c.g0);
    if (!(g.cwiseAbs().maxCoeff() > 0.0)) continue;
    curved_[at(slot)] = 1;
    Matrix6& to = h_[at(slot)];
    Eigen::Matrix3d hat;
    hat << 0.0, -c.r[2], c.r[1], c.r[2], 0.0, -c.r[0], -c.r[1], c.r[0], 0.0;
    const Eigen::Matrix3d hat_g = hat * g;
    to.topLeftCorner<3, 3>() -= hat_g * hat;
    to.topRightCorner<3, 3>() += hat_g;
    to.bottomLeftCorner<3, 3>() -= g * hat;
    to.bottomRightCorner<3, 3>() += g;
  }
  b_rho_.head(n_).noalias() = b * rho_.head(n_);
  return rho_.head(n_).dot(b_rho_.head(n_));
}

// Links whose tangent is that of stage 1 have dz = -rho; only the others are coupled.
void ContactSolve::direction() noexcept {
  curved_slots_.clear();
  for (int s = 0; s < slots_; ++s) {
    if (curved_[at(s)] != 0) curved_slots_.push_back(s);
  }
  dz_.head(n_) = -rho_.head(n_);
  const int m = 6 * static_cast<int>(curved_slots_.size());
  for (int i = 0; i < m / 6; ++i) {
    const int s = curved_slots_[at(i)];
    Vector6 right = dz_.segment<6>(6 * s);
    for (int t = 0; t < slots_; ++t) {
      if (curved_[at(t)] != 0) continue;
      const Vector6 a = b_.block<6, 6>(6 * s, 6 * t) * dz_.segment<6>(6 * t);
      right -= h_[at(s)] * a;
    }
    for (int r = 0; r < 6; ++r) right_[at(6 * i + r)] = right[r];
    for (int j = 0; j < m / 6; ++j) {
      const Matrix6 block = h_[at(s)] * b_.block<6, 6>(6 * s, 6 * curved_slots_[at(j)]);
      for (int r = 0; r < 6; ++r) {
        for (int k = 0; k < 6; ++k) {
          matrix_[at((6 * i + r) * m + 6 * j + k)] = block(r, k) + (i == j && r == k ? 1.0 : 0.0);
        }
      }
    }
  }
  eliminate(matrix_.data(), right_.data(), m);
  for (int i = 0; i < m / 6; ++i) {
    for (int r = 0; r < 6; ++r) dz_[6 * curved_slots_[at(i)] + r] = right_[at(6 * i + r)];
  }
}

bool ContactSolve::newton(Contacts& contacts, double h, int limit, double loose,
                          double& merit) noexcept {
  // Steps tried regardless of the merit when nothing lowers it: the iterate sits on a kink.
  static constexpr double kBold[] = {1.0, 0.5, 1.0, 0.25, 1.0, 0.1, 1.0, 0.03};
  const double tolerance = std::max(kSettled, loose);
  double best = std::numeric_limits<double>::infinity();
  std::size_t bold = 0;
  for (int i = 0; i < limit; ++i) {
    if (rho_.head(n_).norm() <= tolerance * scale_) return true;
    ++counters_.newton;
    direction();
    double t = line_search(contacts, h, merit);
    if (!(t > 0.0)) {
      if (best > merit) {
        best = merit;
        best_z_.head(n_) = z_.head(n_);
      }
      t = kBold[bold++ % std::size(kBold)];
    }
    z_.head(n_) += t * dz_.head(n_);
    merit = evaluate(contacts, h, z_, true);
  }
  if (rho_.head(n_).norm() <= tolerance * scale_) return true;
  if (!(merit <= best)) {
    if (std::isfinite(best)) {
      z_.head(n_) = best_z_.head(n_);
    } else {
      z_.head(n_).setZero();
    }
    merit = evaluate(contacts, h, z_, true);
  }
  return false;
}

// The share of dz to go, 0 if none lowers the merit.
double ContactSolve::line_search(Contacts& contacts, double h, double merit) noexcept {
  double best_t = 1.0;
  double best = merit_at(contacts, h, 1.0);
  if (best < 0.25 * merit) return best_t;
  const auto consider = [&](double t) {
    const double m = merit_at(contacts, h, t);
    if (m < best || !std::isfinite(best)) {
      best = m;
      best_t = t;
    }
  };
  find_kinks(contacts, h);
  for (const double t : kinks_) consider(t);
  for (double t = 0.5; !(best < merit * (1.0 - 1e-4 * best_t)) && t > 1e-5; t *= 0.5) consider(t);
  return best < merit ? best_t : 0.0;
}

double ContactSolve::merit_at(Contacts& contacts, double h, double t) noexcept {
  trial_.head(n_) = z_.head(n_) + t * dz_.head(n_);
  return evaluate(contacts, h, trial_, false);
}

// Where on the ray a contact opens or closes, or passes nearest to not slipping.
void ContactSolve::find_kinks(const Contacts& contacts, double h) noexcept {
  kinks_.clear();
  const auto b = b_.topLeftCorner(n_, n_);
  a_.head(n_).noalias() = b * z_.head(n_);
  a_.head(n_) += a1_.head(n_);
  da_.head(n_).noalias() = b * dz_.head(n_);
  const auto add = [this](double t) {
    if (t > 1e-9 && t < 1.0 && kinks_.size() < kinks_.capacity()) kinks_.push_back(t);
  };
  for (const Contact& c : contacts) {
    const Eigen::Vector3d v = c.v0 + velocity_of(c, a_, h);
    const Eigen::Vector3d dv = velocity_of(c, da_, h);
    const double beta = c.params.tangent_damping + h * c.params.tangent_stiffness;
    const double vn = c.normal.dot(v), dvn = c.normal.dot(dv);
    const Eigen::Vector3d trial =
        -c.params.tangent_stiffness * c.stretch - beta * (v - vn * c.normal);
    const Eigen::Vector3d change = -beta * (dv - dvn * c.normal);
    const double square = change.squaredNorm();
    if (square > 0.0) add(-trial.dot(change) / square);
    if (dvn != 0.0) add((c.depth / h - vn) / dvn * (1.0 + 1e-6));
  }
}

}  // namespace twinbus
