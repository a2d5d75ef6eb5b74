// With which set-point a source that was set to another's state goes on.

#include <cmath>

#include "bridge/gate/command_in_force.h"
#include "bridge/source/source.h"
#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {
constexpr std::int64_t kOldCommands = 2;  // command timeouts; what is older is no set-point to take over
}  // namespace

// The client's, with the torque that makes the sum what was measured; else the measured posture.
void Source::adopt_imposed() noexcept {
  const std::int64_t most_ticks = kOldCommands * limits_->command_timeout_ns / limits_->period_ns;
  if (!have_holder_command_ || holder_command_.run_id != holder_state_.run_id || holder_command_.term != holder_state_.term ||
      holder_state_.tick - holder_command_.tick > most_ticks) {
    gate_.hold_measured(holder_state_);
    return;
  }
  JointCommand in_force;
  const bool jump = !find_command_in_force(holder_state_, holder_before_, holder_command_, *limits_, in_force);
  // A torque that no servo gives is of a command that was not in force.
  for (int j = 0; j < limits_->joint_count && jump; ++j) {
    if (!(std::abs(static_cast<double>(in_force.tau[at(j)])) > limits_->effort[at(j)])) continue;
    gate_.hold_measured(holder_state_);
    return;
  }
  gate_.adopt(in_force, jump ? in_force : holder_command_);
  gate_.blend_again(jump ? limits_->blend_s : 0.0);
}

}  // namespace twinbus::bridge
