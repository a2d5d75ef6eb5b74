#include "bridge/source/source.h"

#include <cmath>

#include "bridge/source/source_core.h"

namespace twinbus {

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

struct Source::Impl {
  Impl(const Model& model, RobotAdaptor& adaptor, const SourceConfig& config)
      : limits(model),
        core(model, limits, adaptor, config, handover_config(model, adaptor, config)) {}
  GateLimits limits;
  SourceCore core;
};

Source::Source(const Model& model, RobotAdaptor& adaptor, const SourceConfig& config)
    : impl_(std::make_unique<Impl>(model, adaptor, config)) {}
Source::~Source() = default;

void Source::on_state(const RobotState& state, std::int64_t now_ns) noexcept {
  impl_->core.on_state(state, now_ns);
}
void Source::on_standby_state(const RobotState& state, std::int64_t now_ns) noexcept {
  impl_->core.on_standby_state(state, now_ns);
}
void Source::on_command(const JointCommand& command, std::int64_t now_ns) noexcept {
  impl_->core.on_command(command, now_ns);
}
void Source::on_stop_plan(const StopPlanPiece& piece, std::int64_t now_ns) noexcept {
  impl_->core.on_stop_plan(piece, now_ns);
}
void Source::on_source_request(const SourceRequest& request, std::int64_t now_ns) noexcept {
  impl_->core.on_source_request(request, now_ns);
}
void Source::on_controller_request(const ControllerRequest& request, std::int64_t now_ns) noexcept {
  impl_->core.on_controller_request(request, now_ns);
}
void Source::on_stop(const StopRequest& stop, std::int64_t now_ns) noexcept {
  impl_->core.on_stop(stop, now_ns);
}
void Source::on_guard(const GuardReport& report, std::int64_t now_ns) noexcept {
  impl_->core.on_guard(report, now_ns);
}
void Source::on_controller_status(const ControllerStatus& status, std::int64_t now_ns) noexcept {
  impl_->core.on_controller_status(status, now_ns);
}
void Source::begin_tick(std::int64_t now_ns) noexcept { impl_->core.begin_tick(now_ns); }
void Source::end_tick(std::int64_t now_ns) noexcept { impl_->core.end_tick(now_ns); }
const RobotState& Source::state() const noexcept { return impl_->core.state(); }
bool Source::publishes_on_state() const noexcept { return impl_->core.handover().holds_state(); }
bool Source::command_ready() const noexcept { return impl_->core.command_ready(); }
std::int64_t Source::next_tick_due_ns(std::int64_t last_due_ns) const noexcept {
  return impl_->core.next_tick_due_ns(last_due_ns);
}
StopRequest Source::take_stop_to_publish(std::int64_t now_ns) noexcept {
  return impl_->core.take_stop_to_publish(now_ns);
}
bool Source::take_fall(std::array<char, 200>& cause) noexcept { return impl_->core.take_fall(cause); }
const SourceStatus& Source::status() const noexcept { return impl_->core.status(); }
const FirstCut& Source::first_cut() const noexcept { return impl_->core.gate().first_cut(); }
const FirstCut& Source::first_catch_up() const noexcept { return impl_->core.gate().first_catch_up(); }
const JointCommand& Source::effective_command() const noexcept {
  return impl_->core.gate().effective();
}

}  // namespace twinbus
