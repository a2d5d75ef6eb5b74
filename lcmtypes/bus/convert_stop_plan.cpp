// The pieces of stop plans; as convert.cpp.

#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/field_copier.h"

namespace twinbus {

namespace {
template <class C, class M, Is<StopPlanPiece> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.run_id, s.head.run_id);
  c.id(m.model_hash, s.head.model_hash);
  c.id(m.controller_id, s.head.controller_id);
  c.id(m.tick, s.head.tick);
  c(m.joints, s.head.joints);
  c.counter(m.term, s.head.term);
  c.counter(m.number, s.head.number);
  c.within(m.pieces, s.head.pieces, 1, kMostPlanPieces);
  c.within(m.piece, s.piece, 0, s.head.pieces - 1);
  c.within(m.knot_count, s.head.knot_count, 1, kMostPlanKnots);
  c.within(m.spacing, s.head.spacing, 1, 10000);
  c.joint_count(m.joint_count, s.head.joint_count);
  c(m.walks, s.head.walks);
  c(m.omega, s.head.omega);
  c(m.mass, s.head.mass);
  c(m.sole_low, s.head.sole_low);
  c(m.sole_high, s.head.sole_high);
  c(m.sole_zmp, s.head.sole_zmp);
  c(m.phase, s.phase);
  c(m.q, s.q);
  c(m.tau, s.tau);
  c(m.balance, s.balance);
}
}  // namespace

template <>
Status to_message<StopPlanPiece>(const StopPlanPiece& value, stop_plan_t& message) noexcept {
  Copier<true> copier;
  fields(copier, message, value);
  return copier.status();
}

template <>
Status from_message<StopPlanPiece>(const stop_plan_t& message, StopPlanPiece& value) noexcept {
  Copier<false> copier;
  fields(copier, message, value);
  return copier.status();
}

}  // namespace twinbus
