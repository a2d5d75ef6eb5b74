#include "sim/contact/contact_solve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/time/part_clock.h"

namespace twinbus::inline sim {

namespace {

constexpr int kMostNewton = 20;
constexpr int kMostFolds = 2;          // beyond the first: what needs more is Newton's
constexpr int kHolds = -1;             // less folds_: refold() has looked at all contacts, and stage 1 agrees with the law
constexpr double kStageOne = 1e-9;  // of 1 N + all forces: stage 1 agrees with the law
// Not folded in: what moves on both sides, and a light body that is about to land, whose mass a wrong one would drown in rounding.
bool left_out(const Contact& c) noexcept { return c.other_system >= 0 || (c.system > 0 && !(c.depth > 0.0)); }

// Blocks that elimination may fill, for each touched link.
constexpr std::size_t kMostFill = 64;
// Bodies across a pile of which all couplings find room in the matrix, three times.
constexpr std::size_t kMostReach = 192;

}  // namespace

void find_force(Contact& c, double h, bool with_tangent, double smooth) noexcept {
  if (c.tie != TieKind::kNone) {
    tie_force(c.params, c.tie == TieKind::kLength ? &c.normal : nullptr, c.stretch, c.v, h,
              with_tangent, c.now);
  } else {
    contact_force(c.params, c.depth + c.lead, c.normal, c.stretch, c.v, h, with_tangent, smooth, c.now);
  }
}

TurningMoment turning_of(const Contact& c, double h) noexcept {
  return turning_moment(c.params, c.normal, c.turned, c.w, c.normal.dot(c.now.force), c.normal.dot(c.now.tangent * c.normal), h);
}

ContactSolve::ContactSolve(std::vector<ArticulatedBody*> systems, int most_contacts)
    : systems_(std::move(systems)), band_(0, 0), pile_(0, 0, 0) {
  int links = 0, blocks = 0;
  for (const ArticulatedBody* body : systems_) {
    first_link_.push_back(links);
    links += body->link_count();
    blocks += body->link_count() * body->link_count();
    most_rows_ = std::max(most_rows_, body->most_rows());
  }
  parent_.resize(systems_.size());
  island_of_.resize(systems_.size());
  moved_.resize(systems_.size());
  starts_.reserve(systems_.size() + 2);
  order_.resize(at(most_contacts));
  slot_of_link_.assign(at(links), -1);
  const auto slots = at(std::min(links, 2 * most_contacts));
  const auto size = static_cast<Eigen::Index>(6 * slots);
  slots_.reserve(slots);
  couplings_.reserve(at(most_contacts));
  h_.resize(slots);
  rows_.resize(at(most_rows_));
  other_rows_.resize(at(most_rows_));
  blocks_.resize(at(blocks));
  neighbours_.resize(2 * at(most_contacts));
  first_.resize(slots + 1);
  sequence_.reserve(slots);
  seen_.resize(slots);
  for (Eigen::VectorXd* v : {&a1_, &a_, &da_, &z_, &best_z_, &rho_, &dz_, &trial_, &b_rho_}) {
    v->setZero(size);
  }
  band_ = BandSolve(6 * slots, 36 * slots * std::min(3 * slots, kMostReach));
  pile_ = BlockSolve(slots, 4 * at(most_contacts), slots * std::min(slots, kMostFill));
  right_.resize(6 * slots);
  kinks_.reserve(2 * at(most_contacts));
}

void ContactSolve::fold(Contacts& contacts, double h) noexcept {
  const PartScope part("contacts, solved");
  PointForces forces;  // of contacts in a row that are of one link
  int system = -1, link = -1;
  const auto fold_in = [&] {
    if (link >= 0) systems_[at(system)]->add_forces(link, forces);
    forces = PointForces{};
  };
  bends_ = false;
  folds_ = 0;
  // All first: what has just been written in ones and is read in twos waits for the memory.
  for (Contact& c : contacts) {
    if (left_out(c)) continue;
    c.v = c.v0;
    if (c.foreseen) c.v += h * c.gain;
    find_force(c, h, true, 0.0);
    bends_ = bends_ || c.params.ramp >= kEndlessRamp;
  }
  for (Contact& c : contacts) {
    if (left_out(c)) {
      c.f0.setZero();
      c.g0.setZero();
      continue;
    }
    c.f0 = c.now.force;
    c.g0 = c.now.tangent;
    if (c.now.mode == ContactMode::kOpen) continue;
    if (c.now.mode == ContactMode::kSlip) {  // inertia is symmetric: normal-to-tangent is left out
      const Eigen::Vector3d column = c.g0 * c.normal;
      c.g0 -= (column - c.normal * c.normal.dot(column)) * c.normal.transpose();
    }
    if (c.foreseen) c.f0 += c.g0 * (c.v - c.v0);
    if (c.system != system || c.link != link) {
      fold_in();
      system = c.system;
      link = c.link;
    }
    forces.add(c.r, c.f0, h * c.g0);
  }
  fold_in();
}

bool ContactSolve::refold(Contacts& contacts, double h) noexcept {
  if (folds_ < 0) folds_ = kHolds - folds_;
  if (!bends_ || folds_ == kMostFolds) return false;
  const PartScope part("contacts, solved");
  double total = 1.0, mismatch = 0.0;  // that squared
  for (Contact& c : contacts) {
    if (left_out(c) || turns(c) || c.now.mode == ContactMode::kSlip) return false;
    const ContactMode folded = c.now.mode;
    c.v = c.v0 + h * at_point(systems_[at(c.system)]->acceleration(c.link), c.r);
    find_force(c, h, true, 0.0);
    if (c.now.mode != folded) return false;
    total += c.now.force.norm();
    mismatch = std::max(mismatch, (c.now.force - (c.f0 - c.g0 * (c.v - c.v0))).squaredNorm());
  }
  if (std::sqrt(mismatch) <= kStageOne * total) {
    folds_ = kHolds - folds_;
    return false;
  }
  ++folds_;
  for (Contact& c : contacts) {
    if (c.now.mode == ContactMode::kOpen) continue;
    const Eigen::Vector3d f0 = c.now.force + c.now.tangent * (c.v - c.v0);
    PointForces more;  // than what is folded in
    more.add(c.r, f0 - c.f0, h * (c.now.tangent - c.g0));
    systems_[at(c.system)]->add_forces(c.link, more);
    c.f0 = f0;
    c.g0 = c.now.tangent;
  }
  return true;
}

void ContactSolve::solve(Contacts& contacts, double h) noexcept {
  gave_up_ = false;
  if (contacts.empty()) return;
  if (folds_ < 0 && systems_.size() == 1) {  // one island, and nothing has moved since
    ++counters_.steps;
    ++counters_.one_pass;
    return;
  }
  const PartScope part("contacts, solved");
  make_islands(contacts);
  for (std::size_t i = 0; i + 1 < starts_.size(); ++i) {
    members_ = order_.data() + starts_[i];
    member_count_ = starts_[i + 1] - starts_[i];
    solve_island(contacts, h);
    if (gave_up_) return;
  }
}

int ContactSolve::root_of(int system) noexcept {
  while (parent_[at(system)] != system) {
    parent_[at(system)] = parent_[at(parent_[at(system)])];
    system = parent_[at(system)];
  }
  return system;
}

// Contacts sorted by the islands of bodies that touch one another; order is kept within each.
void ContactSolve::make_islands(const Contacts& contacts) noexcept {
  starts_.clear();
  starts_.push_back(0);
  const int count = static_cast<int>(contacts.size());
  if (systems_.size() == 1) {
    std::iota(order_.begin(), order_.begin() + count, 0);
    starts_.push_back(count);
    return;
  }
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const Contact& c : contacts) {
    if (c.other_system >= 0) parent_[at(root_of(c.other_system))] = root_of(c.system);
  }
  std::fill(island_of_.begin(), island_of_.end(), -1);
  for (const Contact& c : contacts) {
    int& island = island_of_[at(root_of(c.system))];
    if (island < 0) {
      island = static_cast<int>(starts_.size()) - 1;
      starts_.push_back(0);
    }
    ++starts_[at(island + 1)];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  for (int i = 0; i < count; ++i) {
    order_[at(starts_[at(island_of_[at(root_of(contacts[at(i)].system))])]++)] = i;
  }
  for (std::size_t i = starts_.size() - 1; i > 0; --i) starts_[i] = starts_[i - 1];
  starts_[0] = 0;
}

bool ContactSolve::stage_one_holds(Contacts& contacts, double h) const noexcept {
  double total = 1.0, mismatch = 0.0;  // that squared
  int system = -1, link = -1;  // of the contact before
  Screw a;
  bool turn = false;
  for (int i = 0; i < member_count_; ++i) {
    Contact& c = contacts[at(members_[i])];
    // Nothing of it is folded in: what pressed a step ago presses still.
    if (c.other_system >= 0 && !c.guess.isZero(0.0)) return false;
    if (c.system != system || c.link != link) {
      system = c.system;
      link = c.link;
      a = systems_[at(system)]->acceleration(link);
    }
    c.v = c.v0 + h * at_point(a, c.r);
    if (c.other_system >= 0) {
      const ArticulatedBody& other = *systems_[at(c.other_system)];
      c.v -= h * at_point(other.acceleration(c.other), c.other_r);
    }
    find_force(c, h, false, 0.0);
    turn = turn || turns(c);  // nothing of that is folded in
  }
  if (turn) return false;
  for (int i = 0; i < member_count_; ++i) {
    const Contact& c = contacts[at(members_[i])];
    total += c.now.force.norm();
    mismatch = std::max(mismatch, (c.now.force - (c.f0 - c.g0 * (c.v - c.v0))).squaredNorm());
  }
  return std::sqrt(mismatch) <= kStageOne * total;
}

// As stage one has it, which must have looked at all of them.
bool ContactSolve::come_to_touch(const Contacts& contacts) const noexcept {
  bool touch = false;
  for (int i = 0; i < member_count_; ++i) {
    const Contact& c = contacts[at(members_[i])];
    if (c.other_system >= 0) return false;
    touch = touch || (c.tie == TieKind::kNone && !(c.depth > 0.0) && c.now.mode != ContactMode::kOpen);
  }
  return touch;
}

void ContactSolve::solve_island(Contacts& contacts, double h) noexcept {
  ++counters_.steps;
  if (stage_one_holds(contacts, h)) {
    ++counters_.one_pass;
    return;
  }
  if (hurries_ && come_to_touch(contacts)) {
    gave_up_ = true;
    return;
  }
  find_slots(contacts);
  build_response();
  guess(contacts);
  double merit = evaluate(contacts, h, z_, true);
  const auto almost = [this] { return rho_.head(n_).norm() <= kAlmost * scale_; };
  by_slope_ = true;
  bool settled = newton(contacts, h, kMostNewton, 0.0, merit);
  by_slope_ = false;
  if (!settled && in_pile_) settled = newton(contacts, h, kMostNewton, 0.0, merit);
  settled = settled || almost();
  gave_up_ = hurries_ && !settled;
  if (gave_up_) {
    apply();
    return;
  }
  if (!settled) ++counters_.rounded;
  // The rounded law made sharp by tens; if that fails, in smaller stages.
  for (int attempt = 0; attempt < 2 && !settled; ++attempt) {
    const double force = scale_;
    z_.head(n_).setZero();
    for (double e = 1.0; e > 0.5e-9; e *= attempt == 0 ? 0.1 : 0.4) {
      smooth_ = e * force;
      merit = evaluate(contacts, h, z_, true);
      (void)newton(contacts, h, attempt == 0 ? 6 : 15, 1e-3 * e, merit);
    }
    smooth_ = 0.0;
    merit = evaluate(contacts, h, z_, true);
    settled = newton(contacts, h, kMostNewton, 0.0, merit) || almost();
  }
  if (!settled) ++counters_.unconverged;
  apply();
}

// z - rho are the values of the law, in the cone even if z is not the solution.
void ContactSolve::apply() noexcept {
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    const auto row = static_cast<Eigen::Index>(6 * s);
    const Vector6 w = z_.segment<6>(row) - rho_.segment<6>(row);
    const Slot& slot = slots_[s];
    systems_[at(slot.system)]->add_wrench(
        slot.link, Screw{Vec4{w[0], w[1], w[2], 0.0}, Vec4{w[3], w[4], w[5], 0.0}});
    slot_of_link_[at(first_link_[at(slot.system)] + slot.link)] = -1;
  }
  for (const Slot& slot : slots_) {
    long& moved = moved_[at(slot.system)];
    if (moved == counters_.steps) continue;
    moved = counters_.steps;
    systems_[at(slot.system)]->outward();
  }
}

int ContactSolve::slot_of(int system, int link) noexcept {
  int& slot = slot_of_link_[at(first_link_[at(system)] + link)];
  if (slot >= 0) return slot;
  slot = static_cast<int>(slots_.size());
  Slot added{system, link, slot, false, -1, 0, 0, -1};
  const ArticulatedBody& body = *systems_[at(system)];
  const bool alone = body.link_count() == 1;
  for (int s = 0; s < slot && !alone; ++s) {
    const Slot& other = slots_[at(s)];
    if (other.system != system || body.branch(other.link) != body.branch(link)) continue;
    added.peer = slots_[at(s)].peer;
    slots_[at(s)].peer = slot;
    break;
  }
  const Screw a = systems_[at(system)]->acceleration(link);
  for (int r = 0; r < 6; ++r) a1_[6 * slot + r] = a[r];
  slots_.push_back(added);
  return slot;
}

int ContactSolve::coupling_of(int a, int b) noexcept {
  for (std::size_t i = couplings_.size(); i-- > 0;) {
    if (couplings_[i].a == a && couplings_[i].b == b) return static_cast<int>(i);
  }
  Coupling& added = couplings_.emplace_back();
  added.a = a;
  added.b = b;
  added.apart =
      systems_[at(slots_[at(a)].system)]->origin() - systems_[at(slots_[at(b)].system)]->origin();
  return static_cast<int>(couplings_.size()) - 1;
}

void ContactSolve::find_slots(Contacts& contacts) noexcept {
  slots_.clear();
  couplings_.clear();
  tied_ = false;
  for (int i = 0; i < member_count_; ++i) {
    Contact& c = contacts[at(members_[i])];
    c.slot = slot_of(c.system, c.link);
    tied_ = tied_ || c.tie != TieKind::kNone;
    if (c.other_system < 0) continue;
    c.other_slot = slot_of(c.other_system, c.other);
    c.coupling = coupling_of(c.slot, c.other_slot);
  }
  n_ = 6 * static_cast<int>(slots_.size());
  int blocks = 0;
  for (int s = 0; s < static_cast<int>(slots_.size()); ++s) {
    if (slots_[at(s)].blocks >= 0) continue;
    int count = 0;
    int t = s;
    do {
      slots_[at(t)].place = count++;
      t = slots_[at(t)].peer;
    } while (t != s);
    do {
      slots_[at(t)].blocks = blocks;
      blocks += count;
      t = slots_[at(t)].peer;
    } while (t != s);
  }
  find_sequence();
}

// The slots from one end of the pile to the other, so that those that touch have numbers that are
// near (Cuthill and McKee 1969, from the end that a first walk finds).
void ContactSolve::find_sequence() noexcept {
  const auto count = slots_.size();
  std::fill_n(first_.begin(), count + 1, 0);
  for (const Coupling& c : couplings_) {
    ++first_[at(c.a)];
    ++first_[at(c.b)];
  }
  std::partial_sum(first_.begin(), first_.begin() + static_cast<std::ptrdiff_t>(count),
                   first_.begin());
  first_[count] = static_cast<int>(2 * couplings_.size());
  for (const Coupling& c : couplings_) {
    neighbours_[at(--first_[at(c.a)])] = c.b;
    neighbours_[at(--first_[at(c.b)])] = c.a;
  }
  if (count > 0) (void)walk(walk(0));
  // What half of all others touch comes last: eliminated first it would couple each of them with each.
  constexpr int kMany = 8;
  auto next = sequence_.begin();
  for (std::size_t left = count; left > 0; --left) {
    const int touched = first_[at(*next) + 1] - first_[at(*next)];
    if (touched < kMany || 2 * touched < static_cast<int>(count)) ++next;
    else std::rotate(next, next + 1, sequence_.end());
  }
}

// Fills sequence_ with all slots, those that hang together with one first, the nearest of them
// first.  Returns the last.
int ContactSolve::walk(int from) noexcept {
  sequence_.clear();
  std::fill_n(seen_.begin(), slots_.size(), '\0');
  const auto visit = [this](int slot) {
    if (seen_[at(slot)]) return;
    seen_[at(slot)] = 1;
    sequence_.push_back(slot);
  };
  visit(from);
  int next = 0;  // what hangs together with nothing seen so far
  for (std::size_t i = 0; sequence_.size() < slots_.size() || i < sequence_.size(); ++i) {
    if (i == sequence_.size()) {
      while (seen_[at(next)]) ++next;
      visit(next);
    }
    const int s = sequence_[i];
    for (int t = slots_[at(s)].peer; t != s; t = slots_[at(t)].peer) visit(t);
    for (int k = first_[at(s)]; k < first_[at(s) + 1]; ++k) visit(neighbours_[at(k)]);
  }
  return sequence_.back();
}

void ContactSolve::guess(const Contacts& contacts) noexcept {
  z_.head(n_).setZero();
  for (int i = 0; i < member_count_; ++i) {
    const Contact& c = contacts[at(members_[i])];
    if (c.other_system < 0) continue;
    z_.segment<3>(6 * c.slot) += c.r.cross(c.guess);
    z_.segment<3>(6 * c.slot + 3) += c.guess;
    z_.segment<3>(6 * c.other_slot) -= c.other_r.cross(c.guess);
    z_.segment<3>(6 * c.other_slot + 3) -= c.guess;
  }
}

}  // namespace twinbus::sim
