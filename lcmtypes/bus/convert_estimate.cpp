// Estimates of the base; as convert.cpp.

#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/field_copier.h"

namespace twinbus {

namespace {
template <class C, class M, Is<Estimate> S>
void fields(C& c, M& m, S& s) noexcept {
  c.id(m.tick, s.tick);
  c.id(m.run_id, s.run_id);
  c(m.base_position, s.base_position);
  c.rotation(m.base_attitude, s.base_attitude, true);
  c(m.base_velocity, s.base_velocity);
  c(m.base_angular_velocity, s.base_angular_velocity);
  c(m.velocity_in_base, s.velocity_in_base);
  c(m.angular_velocity_in_base, s.angular_velocity_in_base);
  c(m.imu_velocity, s.imu_velocity);
  c(m.position_deviation, s.position_deviation);
  c(m.attitude_deviation, s.attitude_deviation);
  c(m.velocity_deviation, s.velocity_deviation);
  c(m.angular_velocity_deviation, s.angular_velocity_deviation);
  for (const auto* deviation :
       {&s.position_deviation, &s.attitude_deviation, &s.velocity_deviation, &s.angular_velocity_deviation}) {
    for (const float x : *deviation) c.require(x >= 0.0f);
  }
  c(m.foot_load, s.foot_load);
  c(m.foot_certainty, s.foot_certainty);
  for (const float x : s.foot_certainty) c.require(x >= 0.0f && x <= 1.0f);
  c(m.foot_position, s.foot_position);
  c(m.foot_joint, s.foot_joint);
  for (const std::int16_t joint : s.foot_joint) c.require(joint >= -1 && joint < kMaxJoints);
  c.count(m.foot_count, s.foot_count, kMaxFeet);
  c(m.foot_stands, s.foot_stands);
  c(m.load_from, s.load_from);
  c(m.velocity_from, s.velocity_from);
}
}  // namespace

template <>
Status to_message<Estimate>(const Estimate& value, estimate_t& message) noexcept {
  Copier<true> copier;
  fields(copier, message, value);
  return copier.status();
}

template <>
Status from_message<Estimate>(const estimate_t& message, Estimate& value) noexcept {
  Copier<false> copier;
  fields(copier, message, value);
  return copier.status();
}

}  // namespace twinbus
