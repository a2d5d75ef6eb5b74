// Stage 2 of ContactSolve: Newton on the wrenches of the touched links of one island.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/contact_solve.h"

namespace twinbus {

namespace {

constexpr double kSettled = 1e-10;  // of 10 N + all forces
constexpr double kForceFloor = 10.0;

// Solves a x = b in place by elimination with partial pivots; a is row-major n x n.  ends: room for
// where each row ends in zeros, which piles have many of.
void eliminate(double* a, double* b, int* ends, int n) noexcept {
  for (int r = 0; r < n; ++r) {
    int end = n;
    while (end > 0 && a[r * n + end - 1] == 0.0) --end;
    ends[r] = end;
  }
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    for (int r = c + 1; r < n; ++r) {
      if (std::abs(a[r * n + c]) > std::abs(a[pivot * n + c])) pivot = r;
    }
    if (pivot != c) {
      const int end = std::max(ends[c], ends[pivot]);
      for (int k = c; k < end; ++k) std::swap(a[c * n + k], a[pivot * n + k]);
      std::swap(b[c], b[pivot]);
      std::swap(ends[c], ends[pivot]);
    }
    const double inverse = 1.0 / a[c * n + c];
    for (int r = c + 1; r < n; ++r) {
      const double factor = a[r * n + c] * inverse;
      if (factor == 0.0) continue;
      for (int k = c + 1; k < ends[c]; ++k) a[r * n + k] -= factor * a[c * n + k];
      ends[r] = std::max(ends[r], ends[c]);
      b[r] -= factor * b[c];
    }
  }
  for (int r = n - 1; r >= 0; --r) {
    for (int k = r + 1; k < ends[r]; ++k) b[r] -= a[r * n + k] * b[k];
    b[r] /= a[r * n + r];
  }
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& r) {
  Eigen::Matrix3d hat;
  hat << 0.0, -r[2], r[1], r[2], 0.0, -r[0], -r[1], r[0], 0.0;
  return hat;
}

// to += J(r)' g J(q), J(r) = [-r^ 1].
void add_sandwich(const Eigen::Vector3d& r, const Eigen::Vector3d& q, const Eigen::Matrix3d& g,
                  Eigen::Matrix<double, 6, 6>& to) {
  const Eigen::Matrix3d hat_g = cross_matrix(r) * g;
  const Eigen::Matrix3d hat_q = cross_matrix(q);
  to.topLeftCorner<3, 3>() -= hat_g * hat_q;
  to.topRightCorner<3, 3>() += hat_g;
  to.bottomLeftCorner<3, 3>() -= g * hat_q;
  to.bottomRightCorner<3, 3>() += g;
}

// J(r) s, s the six numbers at a.
Eigen::Vector3d at_point(const double* a, const Eigen::Vector3d& r) {
  return {a[3] + a[1] * r[2] - a[2] * r[1], a[4] + a[2] * r[0] - a[0] * r[2],
          a[5] + a[0] * r[1] - a[1] * r[0]};
}

}  // namespace

void ContactSolve::build_response() noexcept {
  const int count = static_cast<int>(slots_.size());
  for (int s = 0; s < count; ++s) {
    Slot& slot = slots_[at(s)];
    slot.rows = systems_[at(slot.system)]->response(slot.link, &rows_[at(s * most_rows_)]);
  }
  for (int s = 0; s < count; ++s) {
    for (int t = s; t < count; ++t) {
      if (slots_[at(s)].system != slots_[at(t)].system) continue;
      // Both lists end with what the links have in common, in falling order.
      Screw columns[6] = {};
      const ResponseRow *a = &rows_[at(s * most_rows_)], *b = &rows_[at(t * most_rows_)];
      for (int p = 0, q = 0; p < slots_[at(s)].rows && q < slots_[at(t)].rows;) {
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

// acceleration = B wrench.
void ContactSolve::respond(const Eigen::VectorXd& wrench,
                           Eigen::VectorXd& acceleration) const noexcept {
  const int count = static_cast<int>(slots_.size());
  for (int s = 0; s < count; ++s) {
    Vector6 sum = Vector6::Zero();
    int t = s;
    do {
      sum.noalias() += b_.block<6, 6>(6 * s, 6 * t) * wrench.segment<6>(6 * t);
      t = slots_[at(t)].peer;
    } while (t != s);
    acceleration.segment<6>(6 * s) = sum;
  }
}

Eigen::Vector3d ContactSolve::velocity_of(const Contact& c, const Eigen::VectorXd& acceleration,
                                          double h) const noexcept {
  const double* a = acceleration.data();
  if (c.other_system < 0) return h * at_point(a + 6 * c.slot, c.r);
  return h * (at_point(a + 6 * c.slot, c.r) - at_point(a + 6 * c.other_slot, c.other_r));
}

double ContactSolve::evaluate(Contacts& contacts, double h, const Eigen::VectorXd& z,
                              bool with_tangent) noexcept {
  respond(z, a_);
  a_.head(n_) += a1_.head(n_);
  rho_.head(n_) = z.head(n_);
  scale_ = kForceFloor;
  if (with_tangent) {
    for (std::size_t s = 0; s < slots_.size(); ++s) {
      slots_[s].curved = false;
      h_[s].setZero();
    }
    for (Coupling& coupling : couplings_) {
      coupling.ab.setZero();
      coupling.ba.setZero();
    }
  }
  for (int i = 0; i < member_count_; ++i) {
    Contact& c = contacts[at(members_[i])];
    c.v = c.v0 + velocity_of(c, a_, h);
    contact_force(c.params, c.depth, c.normal, c.stretch, c.v, h, with_tangent, smooth_, c.now);
    const Eigen::Vector3d extra = c.now.force - (c.f0 - c.g0 * (c.v - c.v0));
    scale_ += c.now.force.norm();
    rho_.segment<3>(6 * c.slot) -= c.r.cross(extra);
    rho_.segment<3>(6 * c.slot + 3) -= extra;
    if (c.other_system >= 0) {
      rho_.segment<3>(6 * c.other_slot) += c.other_r.cross(extra);
      rho_.segment<3>(6 * c.other_slot + 3) += extra;
    }
    if (!with_tangent) continue;
    const Eigen::Matrix3d g = h * (c.now.tangent - c.g0);
    if (g.cwiseAbs().maxCoeff() > 0.0) add_tangent(c, g);
  }
  respond(rho_, b_rho_);
  return rho_.head(n_).dot(b_rho_.head(n_));
}

void ContactSolve::add_tangent(const Contact& c, const Eigen::Matrix3d& g) noexcept {
  slots_[at(c.slot)].curved = true;
  add_sandwich(c.r, c.r, g, h_[at(c.slot)]);
  if (c.other_system < 0) return;
  slots_[at(c.other_slot)].curved = true;
  add_sandwich(c.other_r, c.other_r, g, h_[at(c.other_slot)]);
  Coupling& coupling = couplings_[at(c.coupling)];
  add_sandwich(c.r, c.other_r, -g, coupling.ab);
  add_sandwich(c.other_r, c.r, -g, coupling.ba);
}

// Row s of H B, of which h is the block in column t, into the matrix of direction().
void ContactSolve::add_row(int s, int t, const Matrix6& h, int m) noexcept {
  const int i = 6 * slots_[at(s)].row;
  int u = t;
  do {
    const Matrix6 block = h * b_.block<6, 6>(6 * t, 6 * u);
    const int j = 6 * slots_[at(u)].row;
    if (j >= 0) {
      for (int r = 0; r < 6; ++r) {
        for (int k = 0; k < 6; ++k) matrix_[at((i + r) * m + j + k)] += block(r, k);
      }
    } else {
      const Vector6 known = block * dz_.segment<6>(6 * u);
      for (int r = 0; r < 6; ++r) right_[at(i + r)] -= known[r];
    }
    u = slots_[at(u)].peer;
  } while (u != t);
}

// Links whose tangent is that of stage 1 have dz = -rho; only the others are coupled.
void ContactSolve::direction() noexcept {
  dz_.head(n_) = -rho_.head(n_);
  int m = 0;
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    slots_[s].row = slots_[s].curved ? m / 6 : -1;
    if (!slots_[s].curved) continue;
    for (int r = 0; r < 6; ++r) right_[at(m + r)] = dz_[static_cast<Eigen::Index>(6 * s) + r];
    m += 6;
  }
  std::fill(matrix_.begin(), matrix_.begin() + m * m, 0.0);
  for (int i = 0; i < m; ++i) matrix_[at(i * m + i)] = 1.0;
  for (int s = 0; s < static_cast<int>(slots_.size()); ++s) {
    if (slots_[at(s)].curved) add_row(s, s, h_[at(s)], m);
  }
  for (const Coupling& c : couplings_) {
    if (!slots_[at(c.a)].curved || !slots_[at(c.b)].curved) continue;
    add_row(c.a, c.b, c.ab, m);
    add_row(c.b, c.a, c.ba, m);
  }
  eliminate(matrix_.data(), right_.data(), ends_.data(), m);
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    if (!slots_[s].curved) continue;
    for (int r = 0; r < 6; ++r) {
      dz_[static_cast<Eigen::Index>(6 * s) + r] = right_[at(6 * slots_[s].row + r)];
    }
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
  respond(z_, a_);
  a_.head(n_) += a1_.head(n_);
  respond(dz_, da_);
  const auto add = [this](double t) {
    if (t > 1e-9 && t < 1.0 && kinks_.size() < kinks_.capacity()) kinks_.push_back(t);
  };
  for (int i = 0; i < member_count_; ++i) {
    const Contact& c = contacts[at(members_[i])];
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
