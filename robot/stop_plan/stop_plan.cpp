#include "robot/stop_plan/stop_plan.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

// The knot before a tick and how far the tick is on to the next one, 0..1.
struct Place {
  int knot = 0;
  double part = 0.0;
};

Place place_of(const StopPlan& plan, std::int64_t tick) noexcept {
  const int last = plan.head.knot_count - 1;
  const std::int64_t since = std::max<std::int64_t>(tick - plan.head.tick, 0);
  if (last < 1 || plan.head.spacing < 1 || since >= std::int64_t{plan.head.spacing} * last) return {std::max(last, 0), 0.0};
  const std::int64_t knot = since / plan.head.spacing;
  return {static_cast<int>(knot),
          static_cast<double>(since - knot * plan.head.spacing) / static_cast<double>(plan.head.spacing)};
}

// Cubic from a to b with the rates ra, rb per knot.
struct Cubic {
  explicit Cubic(double s) noexcept
      : h00((2.0 * s - 3.0) * s * s + 1.0),
        h10(((s - 2.0) * s + 1.0) * s),
        h01((3.0 - 2.0 * s) * s * s),
        h11((s - 1.0) * s * s),
        d00(6.0 * (s - 1.0) * s),
        d10((3.0 * s - 4.0) * s + 1.0),
        d11((3.0 * s - 2.0) * s) {}
  double value(double a, double b, double ra, double rb) const noexcept {
    return h00 * a + h10 * ra + h01 * b + h11 * rb;
  }
  double rate(double a, double b, double ra, double rb) const noexcept {
    return d00 * (a - b) + d10 * ra + d11 * rb;
  }
  double h00, h10, h01, h11, d00, d10, d11;
};

Eigen::Vector2d pair_of(const PlanBalanceRow& row, int column) noexcept {
  return kPlanBalance * Eigen::Vector2d(row[at(column)], row[at(column + 1)]);
}

}  // namespace

bool to_plan(double value, double unit, std::int16_t& out) noexcept {
  const double rounded = std::round(value / unit);
  if (!(std::abs(rounded) <= 32767.0)) return false;
  out = static_cast<std::int16_t>(rounded);
  return true;
}

void StopPlan::copy_to(int piece, StopPlanPiece& out) const noexcept {
  out.head = head;
  out.piece = static_cast<std::int16_t>(piece);
  for (int k = 0; k < kPlanKnotsPerPiece; ++k) {
    const auto from = at(piece * kPlanKnotsPerPiece + k), to = at(k);
    out.phase[to] = phase[from];
    out.q[to] = q[from];
    out.tau[to] = tau[from];
    out.balance[to] = balance[from];
  }
}

void StopPlan::copy_from(const StopPlanPiece& piece) noexcept {
  head = piece.head;
  for (int k = 0; k < kPlanKnotsPerPiece; ++k) {
    const auto to = at(piece.piece * kPlanKnotsPerPiece + k), from = at(k);
    phase[to] = piece.phase[from];
    q[to] = piece.q[from];
    tau[to] = piece.tau[from];
    balance[to] = piece.balance[from];
  }
}

void joints_at(const StopPlan& plan, std::int64_t tick, double period, PlanJoints& out) noexcept {
  const Place place = place_of(plan, tick);
  const int last = plan.head.knot_count - 1;
  const int a = place.knot, b = std::min(a + 1, last);
  const int before = std::max(a - 1, 0), after = std::min(b + 1, last);
  const Cubic cubic(place.part);
  const double per_second = a < last ? 1.0 / (plan.head.spacing * period) : 0.0;
  // Rates per knot at a and b.
  const double over_a = b > before ? 1.0 / (b - before) : 0.0, over_b = after > a ? 1.0 / (after - a) : 0.0;
  const auto &qa = plan.q[at(a)], &qb = plan.q[at(b)], &qs = plan.q[at(before)], &qe = plan.q[at(after)];
  const auto &ta = plan.tau[at(a)], &tb = plan.tau[at(b)], &ts = plan.tau[at(before)], &te = plan.tau[at(after)];
  for (std::size_t j = 0; j < at(plan.head.joint_count); ++j) {
    const double from = qa[j], to = qb[j], ra = over_a * (qb[j] - qs[j]), rb = over_b * (qe[j] - qa[j]);
    out.q[j] = kPlanPosition * cubic.value(from, to, ra, rb);
    out.qd[j] = kPlanPosition * per_second * cubic.rate(from, to, ra, rb);
    out.tau[j] = kPlanTorque * cubic.value(ta[j], tb[j], over_a * (tb[j] - ts[j]), over_b * (te[j] - ta[j]));
  }
}

PlanBalance balance_at(const StopPlan& plan, std::int64_t tick) noexcept {
  const Place place = place_of(plan, tick);
  const int last = plan.head.knot_count - 1;
  const PlanBalanceRow& a = plan.balance[at(place.knot)];
  const PlanBalanceRow& b = plan.balance[at(std::min(place.knot + 1, last))];
  const auto mix = [&](int column) -> Eigen::Vector2d {
    const Eigen::Vector2d from = pair_of(a, column);
    return from + place.part * (pair_of(b, column) - from);
  };
  const auto one = [&](int column) {
    const double from = a[at(column)];
    return kPlanBalance * (from + place.part * (b[at(column)] - from));
  };
  PlanBalance out;
  out.dcm = mix(kPlanDcm);
  out.com = mix(kPlanCom);
  out.zmp = mix(kPlanZmp);
  out.attitude << one(kPlanAttitude), one(kPlanAttitude + 1), one(kPlanAttitude + 2);
  out.left = one(kPlanLeft);
  for (int f = 0; f < 2; ++f) {
    const int column = kPlanSoles + 3 * f;
    out.sole[at(f)].position = mix(column);
    const double from = kPlanBalance * a[at(column + 2)];
    out.sole[at(f)].yaw = from + place.part * wrap_angle(kPlanBalance * b[at(column + 2)] - from);
  }
  const std::int8_t phase = plan.phase[at(place.knot)];
  out.single = (phase & kPlanSingle) != 0;
  out.support = (phase & kPlanOnRight) != 0 ? 1 : 0;
  return out;
}

}  // namespace twinbus::robot
