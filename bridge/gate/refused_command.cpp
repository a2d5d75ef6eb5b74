#include "bridge/gate/refused_command.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline bridge {

namespace {

struct Pair {
  std::int64_t given, wanted;
};

Pair pair_of(GateVerdict why, const JointCommand& command, const WantedCommand& want) noexcept {
  switch (why) {
    case GateVerdict::kOtherRun:
      return {command.run_id, want.run_id};
    case GateVerdict::kOtherTerm:
      return {command.term, want.term};
    case GateVerdict::kOldTick:
      return {command.tick, want.last_tick};
    case GateVerdict::kTooOld:
      return {command.tick, want.tick};
    case GateVerdict::kWrongSize:
      return {command.joint_count, want.joint_count};
    case GateVerdict::kWrongModel:
      return {command.model_hash, want.model_hash};
    default:
      return {command.controller_id, want.controller};
  }
}

}  // namespace

void RefusedCommand::add(GateVerdict why, const JointCommand& command, const WantedCommand& want) noexcept {
  in_a_row = why == verdict && command.controller_id == controller ? in_a_row + 1 : 1;
  verdict = why;
  controller = command.controller_id;
  const Pair pair = pair_of(why, command, want);
  given = pair.given;
  wanted = pair.wanted;
  joint = -1;
  if (why != GateVerdict::kNotFinite) return;
  const int count = std::min<int>(command.joint_count, kMaxJoints);
  for (int j = 0; j < count && joint < 0; ++j) {
    const auto i = static_cast<std::size_t>(j);
    if (!std::isfinite(command.q[i]) || !std::isfinite(command.qd[i]) || !std::isfinite(command.tau[i]) ||
        !std::isfinite(command.kp[i]) || !std::isfinite(command.kd[i]))
      joint = static_cast<std::int16_t>(j);
  }
}

}  // namespace twinbus::bridge
