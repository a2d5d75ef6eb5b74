// What a source is made of, and what it says of itself: STATE less what is measured, and SOURCE_STATUS.

#include "bridge/source/source.h"

#include <cmath>

namespace twinbus::inline bridge {

namespace {

HandoverConfig handover_config(const Model& model, const RobotAdaptor& adaptor,
                               const SourceConfig& config) {
  HandoverConfig handover;
  handover.run_id = config.run_id;
  handover.model_hash = model.hash;
  handover.period_ns = model.period_ns;
  handover.can_be_set = adaptor.can_be_set();
  handover.hardware = adaptor.is_hardware();
  handover.real_time = config.pace == Pace::kRealTime;
  handover.state_timeout_ns = std::llround(1e9 * model.state_timeout);
  if (config.pace == Pace::kFreeRun) handover.listen_ns = 0;  // there is nobody to listen to
  return handover;
}

}  // namespace

Source::Source(const Model& model, RobotAdaptor& adaptor, const SourceConfig& config)
    : Source(model, std::make_shared<const GateLimits>(model), adaptor, config, handover_config(model, adaptor, config)) {}

void Source::fill_state() noexcept {
  state_.tick = handover_.tick;
  state_.time_ns = handover_.time_ns;
  state_.run_id = config_.run_id;
  state_.model_hash = model_->hash;
  state_.grant_run_id = handover_.successor;
  state_.grant_tick = handover_.successor != 0 ? handover_.grant_tick : 0;
  state_.term = handover_.term;
  state_.period_ns = model_->period_ns;
  state_.plan_number = gate_.plan().number();
  state_.plan_tick = gate_.plan().since();
  state_.stop_nonce = gate_.latch().nonce;
  state_.joint_count = static_cast<std::int16_t>(limits_->joint_count);
  state_.source = config_.kind;
  state_.role = handover_.role;
  state_.stop_kind = gate_.latch().kind;
  if (!device_ok_) state_.sensor_flags &= ~kEncodersValid;
}

void Source::fill_status() noexcept {
  const GateCounters& counters = gate_.counters();
  status_.run_id = config_.run_id;
  status_.model_hash = model_->hash;
  status_.tick = state_.tick;
  status_.controller_id = gate_.controller_id();
  status_.successor_run_id = handover_.successor;
  status_.commands_accepted = counters.accepted;
  status_.commands_rejected = counters.rejected;
  status_.commands_late = counters.late;
  status_.clamped = counters.clamped;
  status_.plans_accepted = counters.plans_accepted;
  status_.plans_refused = counters.plans_refused;
  status_.plans_followed = counters.plans_followed;
  status_.plan_refusal = static_cast<std::int8_t>(gate_.plan_refusal());
  status_.terms_ignored = handover_.terms_ignored;
  status_.term = handover_.term;
  status_.period_ns = model_->period_ns;
  status_.stop_nonce = gate_.latch().nonce;
  status_.refusal_sequence = handover_.refusal_sequence;
  status_.faded_in = gate_.faded_in();
  status_.refusal = handover_.refusal;
  status_.source = config_.kind;
  status_.role = handover_.role;
  status_.stop_kind = gate_.latch().kind;
  status_.stop_reason = gate_.latch().reason;
  status_.pace = static_cast<std::int8_t>(config_.pace);
  status_.can_be_set = handover_.config.can_be_set;
  status_.hardware = handover_.config.hardware;
}

}  // namespace twinbus::bridge
