// Stage 2 of ContactSolve: Newton on the wrenches of the touched links of one island.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "common/simd/vec4.h"
#include "sim/contact/contact_solve.h"

namespace twinbus::inline sim {

namespace {

constexpr double kSettled = 1e-10;  // of 10 N + all forces
constexpr double kForceFloor = 10.0;
constexpr int kPile = 6 * 12;      // rows from which on the order of elimination is worth looking for
constexpr std::size_t kManyKinks = 12;
constexpr double kLeastHalf = 1e-2;
constexpr int kMostSections = 8;
constexpr double kFlat = 0.1;  // of the slope at the beginning
constexpr double kSolved = 1e-9;   // of the right side

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& r) {
  Eigen::Matrix3d hat;
  hat << 0.0, -r[2], r[1], r[2], 0.0, -r[0], -r[1], r[0], 0.0;
  return hat;
}

// to += J(r)' g J(r), J(r) = [-r^ 1].
void add_sandwich(const Eigen::Vector3d& r, const Eigen::Matrix3d& g,
                  Eigen::Matrix<double, 6, 6>& to) {
  const Eigen::Matrix3d hat = cross_matrix(r);
  const Eigen::Matrix3d hat_g = hat * g;
  to.topLeftCorner<3, 3>() -= hat_g * hat;
  to.topRightCorner<3, 3>() += hat_g;
  to.bottomLeftCorner<3, 3>() -= g * hat;
  to.bottomRightCorner<3, 3>() += g;
}

// J(r) s, s the six numbers at a.
Eigen::Vector3d at_point(const double* a, const Eigen::Vector3d& r) {
  return {a[3] + a[1] * r[2] - a[2] * r[1], a[4] + a[2] * r[0] - a[0] * r[2],
          a[5] + a[0] * r[1] - a[1] * r[0]};
}

// columns += a b'.
TWINBUS_AVX2_CLONES
void add_outer(const Screw& a, const Screw& b, Screw (&columns)[6]) noexcept {
  const double* factor = reinterpret_cast<const double*>(&b);
  for (int k = 0; k < 6; ++k) {
    columns[k].w += a.w * factor[k < 3 ? k : k + 1];
    columns[k].v += a.v * factor[k < 3 ? k : k + 1];
  }
}

}  // namespace

void ContactSolve::build_response() noexcept {
  const int count = static_cast<int>(slots_.size());
  for (int s = 0; s < count; ++s) {
    const Slot& one = slots_[at(s)];
    const int rows = systems_[at(one.system)]->response(one.link, rows_.data());
    for (int t = s;;) {
      const Slot& two = slots_[at(t)];
      const bool same = t == s;
      const int others =
          same ? rows : systems_[at(two.system)]->response(two.link, other_rows_.data());
      // Both lists end with what the links have in common, in falling order.
      Screw columns[6] = {};
      const ResponseRow *a = rows_.data(), *b = same ? a : other_rows_.data();
      for (int p = 0, q = 0; p < rows && q < others;) {
        if (a[p].joint == b[q].joint) {
          add_outer(a[p].row, b[q].row, columns);
          ++p, ++q;
        } else if (a[p].joint > b[q].joint) {
          ++p;
        } else {
          ++q;
        }
      }
      Matrix6& forth = blocks_[at(one.blocks + two.place)];
      Matrix6& back = blocks_[at(two.blocks + one.place)];
      for (int k = 0; k < 6; ++k) {
        for (int r = 0; r < 6; ++r) forth(r, k) = back(k, r) = columns[k][r];
      }
      // The block of two slots is that of the later one with the earlier.
      do {
        t = slots_[at(t)].peer;
      } while (t > s);
      if (t == s) break;
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
      sum.noalias() += block(s, t) * wrench.segment<6>(6 * t);
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
  for (int i = 0; i < member_count_; ++i) {
    Contact& c = contacts[at(members_[i])];
    c.v = c.v0 + velocity_of(c, a_, h);
    find_force(c, h, with_tangent, smooth_);
    const Eigen::Vector3d extra = c.now.force - (c.f0 - c.g0 * (c.v - c.v0));
    scale_ += c.now.force.norm();
    rho_.segment<3>(6 * c.slot) -= c.r.cross(extra);
    rho_.segment<3>(6 * c.slot + 3) -= extra;
    if (c.other_system >= 0) {
      rho_.segment<3>(6 * c.other_slot) += c.other_r.cross(extra);
      rho_.segment<3>(6 * c.other_slot + 3) += extra;
    }
    if (turns(c)) resist_turning(c, h);
  }
  respond(rho_, b_rho_);
  return rho_.head(n_).dot(b_rho_.head(n_));
}

// Of a contact whose force is known.
void ContactSolve::resist_turning(Contact& c, double h) noexcept {
  c.w = c.w0 + h * a_.segment<3>(6 * c.slot);
  if (c.other_system >= 0) c.w -= h * a_.segment<3>(6 * c.other_slot);
  c.moment = turning_of(c, h).moment;
  rho_.segment<3>(6 * c.slot) -= c.moment;
  if (c.other_system >= 0) rho_.segment<3>(6 * c.other_slot) += c.moment;
}

// H, of the tangents that evaluate() left in the contacts.
void ContactSolve::add_tangents(const Contacts& contacts, double h) noexcept {
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    slots_[s].curved = false;
    h_[s].setZero();
  }
  for (Coupling& coupling : couplings_) {
    coupling.curved = false;
    coupling.aa.setZero();
  }
  for (int i = 0; i < member_count_; ++i) {
    const Contact& c = contacts[at(members_[i])];
    const Eigen::Matrix3d g = h * (c.now.tangent - c.g0);
    const bool turn = turns(c);
    if (!(g.cwiseAbs().maxCoeff() > 0.0) && !turn) continue;
    Matrix6& to = c.other_system < 0 ? h_[at(c.slot)] : couplings_[at(c.coupling)].aa;
    (c.other_system < 0 ? slots_[at(c.slot)].curved : couplings_[at(c.coupling)].curved) = true;
    add_sandwich(c.r, g, to);
    if (!turn) continue;
    const TurningMoment turning = turning_of(c, h);
    to.topLeftCorner<3, 3>() += h * (turning.by_turning - turning.by_moving * cross_matrix(c.r));
    to.topRightCorner<3, 3>() += h * turning.by_moving;
  }
  // J(r_B) = J(r_A) X,  X = [1 0; -d^ 1],  d from B's common point to A's.
  for (Coupling& c : couplings_) {
    if (!c.curved) continue;
    slots_[at(c.a)].curved = slots_[at(c.b)].curved = true;
    const Eigen::Matrix3d hat = cross_matrix(c.apart);
    Matrix6 right = c.aa;  // aa X
    right.leftCols<3>() -= c.aa.rightCols<3>() * hat;
    h_[at(c.a)] += c.aa;
    c.ab = -right;
    c.ba = -c.aa;  // -X' aa
    c.ba.topRows<3>() -= hat * c.aa.bottomRows<3>();
    h_[at(c.b)] += right;  // X' aa X
    h_[at(c.b)].topRows<3>() += hat * right.bottomRows<3>();
  }
}

// Row s of H B, of which h is the block in column t, into the matrix of direction().
void ContactSolve::add_row(int s, int t, const Matrix6& h) noexcept {
  const int i = slots_[at(s)].row;
  int u = t;
  do {
    const Matrix6 product = h * block(t, u);
    const int j = slots_[at(u)].row;
    if (j < 0) {
      const Vector6 known = product * dz_.segment<6>(6 * u);
      for (int r = 0; r < 6; ++r) right_[at(i + r)] -= known[r];
    } else if (in_pile_) {
      pile_.add(i / 6, j / 6, product.data());
    } else {
      for (int r = 0; r < 6; ++r) {
        for (int k = 0; k < 6; ++k) band_.add(i + r, j + k, product(r, k));
      }
    }
    u = slots_[at(u)].peer;
  } while (u != t);
}

// The pairs of rows in which add_row() puts blocks.
template <class Touch>
void ContactSolve::each_touched(const Touch& touch) const noexcept {
  const auto row = [&](int s, int t) {
    int u = t;
    do {
      if (slots_[at(u)].row >= 0) touch(slots_[at(s)].row, slots_[at(u)].row);
      u = slots_[at(u)].peer;
    } while (u != t);
  };
  for (int s = 0; s < static_cast<int>(slots_.size()); ++s) {
    if (slots_[at(s)].curved && slots_[at(s)].peer != s) row(s, s);
  }
  for (const Coupling& c : couplings_) {
    if (!c.curved) continue;
    row(c.a, c.b);
    row(c.b, c.a);
  }
}

// How far from the diagonal add_row() comes.
int ContactSolve::reach_of_matrix() const noexcept {
  int most = 0;
  each_touched([&most](int i, int j) { most = std::max(most, std::abs(i - j)); });
  return most + 5;
}

bool ContactSolve::begin_pile(int rows) noexcept {
  if (rows < kPile) return false;
  pile_.clear();
  each_touched([this](int i, int j) { pile_.touch(i / 6, j / 6); });
  return pile_.begin(rows / 6);
}

// Links whose tangent is that of stage 1 have dz = -rho; only the others are coupled.
void ContactSolve::direction(const Contacts& contacts, double h) noexcept {
  add_tangents(contacts, h);
  int m = 0;
  for (const int s : sequence_) {
    slots_[at(s)].row = slots_[at(s)].curved ? m : -1;
    if (slots_[at(s)].curved) m += 6;
  }
  in_pile_ = begin_pile(m);
  if (!in_pile_ || !solve_rows(m)) {
    in_pile_ = false;
    (void)solve_rows(m);
  }
}

// Of the curved links.  False: of a pile, where elimination went without exchanges of rows, it is not the solution.
bool ContactSolve::solve_rows(int m) noexcept {
  dz_.head(n_) = -rho_.head(n_);
  if (m == 0) return true;
  for (const int s : sequence_) {
    if (slots_[at(s)].curved) std::copy_n(dz_.data() + 6 * s, 6, right_.data() + slots_[at(s)].row);
  }
  if (!in_pile_) {
    band_.reset(m, reach_of_matrix());
    for (int i = 0; i < m; ++i) band_.add(i, i, 1.0);
  }
  for (const int s : sequence_) {
    if (slots_[at(s)].curved) add_row(s, s, h_[at(s)]);
  }
  for (const Coupling& c : couplings_) {
    if (!c.curved) continue;
    add_row(c.a, c.b, c.ab);
    add_row(c.b, c.a, c.ba);
  }
  if (!in_pile_) band_.solve(right_.data());
  else if (!pile_.solve(right_.data())) return false;
  for (const int s : sequence_) {
    if (slots_[at(s)].curved) std::copy_n(right_.data() + slots_[at(s)].row, 6, dz_.data() + 6 * s);
  }
  return !in_pile_ || misfit() <= kSolved * rho_.head(n_).norm();
}

// Of (1 + H B) dz = -rho.
double ContactSolve::misfit() noexcept {
  respond(dz_, da_);
  trial_.head(n_) = rho_.head(n_) + dz_.head(n_);
  for (int s = 0; s < static_cast<int>(slots_.size()); ++s) {
    if (slots_[at(s)].curved) trial_.segment<6>(6 * s).noalias() += h_[at(s)] * da_.segment<6>(6 * s);
  }
  for (const Coupling& c : couplings_) {
    if (!c.curved) continue;
    trial_.segment<6>(6 * c.a).noalias() += c.ab * da_.segment<6>(6 * c.b);
    trial_.segment<6>(6 * c.b).noalias() += c.ba * da_.segment<6>(6 * c.a);
  }
  return trial_.head(n_).norm();
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
    direction(contacts, h);
    const double downhill = by_slope_ && in_pile_ ? dz_.head(n_).dot(b_rho_.head(n_)) : 0.0;
    const double whole = merit_at(contacts, h, 1.0, true);
    if (whole < 0.25 * merit) {
      z_.head(n_) = trial_.head(n_);
      merit = whole;
      continue;
    }
    // Stiff ties on long levers: rounding is all that is left.
    if (tied_ && rho_.head(n_).norm() <= kAlmost * scale_) {
      z_.head(n_) = trial_.head(n_);
      merit = whole;
      return true;
    }
    double t = downhill < 0.0 ? slope_search(contacts, h, downhill) : line_search(contacts, h, merit, whole);
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

// The share of dz to go, 0 if none lowers the merit; whole: the merit of all of it.
double ContactSolve::line_search(Contacts& contacts, double h, double merit,
                                 double whole) noexcept {
  double best_t = 1.0;
  double best = whole;
  const auto consider = [&](double t) {
    const double m = merit_at(contacts, h, t, false);
    if (m < best || !std::isfinite(best)) {
      best = m;
      best_t = t;
    }
  };
  find_kinks(contacts, h);
  const auto lowered = [&] { return best < merit * (1.0 - 1e-4 * best_t); };
  // A heap has so many that they are worth looking at only where halving alone does not help.
  const bool many = in_pile_ && kinks_.size() > kManyKinks;
  for (double t = 0.5; many && !lowered() && t > kLeastHalf; t *= 0.5) consider(t);
  if (many && lowered()) return best_t;
  for (const double t : kinks_) consider(t);
  for (double t = 0.5; !many && !lowered() && t > 1e-5; t *= 0.5) consider(t);
  return best < merit ? best_t : 0.0;
}

// As far along dz as the contacts' potential falls: without sliding the solution is its minimum, and rho its slope.  What is
// evaluated last is the whole of dz; downhill: the slope at its beginning.
double ContactSolve::slope_search(Contacts& contacts, double h, double downhill) noexcept {
  respond(dz_, da_);
  const auto slope = [this] { return rho_.head(n_).dot(da_.head(n_)); };
  double low = 0.0, low_slope = downhill, high = 1.0, high_slope = slope();
  for (int i = 0; i < kMostSections && high_slope > kFlat * -downhill; ++i) {
    const double t = low + (high - low) * std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9);
    (void)merit_at(contacts, h, t, false);
    const double here = slope();
    (here < 0.0 ? low : high) = t;
    (here < 0.0 ? low_slope : high_slope) = here;
    if (std::abs(here) <= kFlat * -downhill) return t;
  }
  return high;
}

double ContactSolve::merit_at(Contacts& contacts, double h, double t, bool with_tangent) noexcept {
  trial_.head(n_) = z_.head(n_) + t * dz_.head(n_);
  return evaluate(contacts, h, trial_, with_tangent);
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
    if (c.tie != TieKind::kNone) continue;
    const Eigen::Vector3d v = c.v0 + velocity_of(c, a_, h);
    const Eigen::Vector3d dv = velocity_of(c, da_, h);
    const double beta = c.params.tangent_damping + h * c.params.tangent_stiffness;
    const double vn = c.normal.dot(v), dvn = c.normal.dot(dv);
    const Eigen::Vector3d trial =
        -c.params.tangent_stiffness * c.stretch - beta * (v - vn * c.normal);
    const Eigen::Vector3d change = -beta * (dv - dvn * c.normal);
    const double square = change.squaredNorm();
    if (square > 0.0) add(-trial.dot(change) / square);
    if (dvn != 0.0) add(((c.depth + c.lead) / h - vn) / dvn * (1.0 + 1e-6));
  }
}

}  // namespace twinbus::sim
