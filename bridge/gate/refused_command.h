// Why commands are refused, for people: the last refusal, and how many there were of its kind without one that was obeyed.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline bridge {

enum class GateVerdict : std::int8_t {
  kAccepted = 0,
  kClosed,    // obeys nobody now
  kOtherRun,  // for another source
  kOtherTerm,
  kOtherController,  // bound to somebody else
  kOldTick,          // not newer than the last
  kTooOld,           // older than the command timeout, or from the future
  kWrongSize,
  kWrongModel,
  kNotFinite,
  kStopped,  // a stop is in force
  kPlanRuns,  // a stop plan is followed, and this command may not end it
};

// What a command that is obeyed names.
struct WantedCommand {
  std::int64_t run_id = 0, term = 0, controller = 0;
  std::int64_t last_tick = 0, tick = 0;  // of the last that was obeyed; of the source
  std::int64_t joint_count = 0, model_hash = 0;
};

struct RefusedCommand {
  GateVerdict verdict = GateVerdict::kAccepted;
  std::int64_t in_a_row = 0;
  std::int64_t controller = 0;
  std::int64_t given = 0, wanted = 0;  // run, term, controller, tick, joint count or model hash
  std::int16_t joint = -1;             // on the bus, of kNotFinite

  // Takes in one more.
  void add(GateVerdict why, const JointCommand& command, const WantedCommand& want) noexcept;
  void obeyed() noexcept { in_a_row = 0; }
};

}  // namespace twinbus::bridge
