// Tries every continuation of a small world to a given depth, without visiting the same state at
// the same depth twice.
//
// In each period any one message may be lost, doubled or late, or one link may be cut, or nothing
// gets through at all; the sources tick in either order; and one thing may happen (a request, a
// stop, a clear, a crash, a forged message ...).  How many faults and happenings one path may have
// is bounded; at its end every message gets through again and World judges.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "test/protocol/world.h"

namespace twinbus::protocol {

enum class Start {
  kFresh,         // just started
  kCold,          // nobody is active
  kTrack,         // A is active, the others track it
  kSwitch,        // and has just been asked to hand over to B
  kSwitchBack,    // and back
  kShadow,        // B is hardware and shadows A
  kShadowSwitch,  // and A has just been asked to hand over to it
  kFarShadow,     // B is hardware in another posture
  kStopped,       // A was stopped, cleared and stopped again
  kTwoActive,     // activated in two halves of a split network
  kCancel,        // B died with a grant in its hand; A is about to cancel
  kGrantLost,     // B was stopped and cut off with a grant in its hand, which has run out since
  kPlans,         // as kTrack, and the controller sends a stop plan behind every command
  kPlanRuns,      // and has been silent for a while
  kPlanLate,      // for so long that it has to wait for the end of its plan
  kOldPlan,       // it has sent no plan for a while
  kCount
};
const char* start_name(Start start);
std::vector<Start> all_starts();
// The setting a start needs, and the world brought there without faults.
Setting setting_for(Start start, int sources, RuleSet off = 0);
World world_at(Start start, const Setting& setting);

struct Bounds {
  int depth = 12;        // periods
  int faults = 2;        // of the network, per path
  int happenings = 1;    // per path
  double seconds = 1e9;  // then it gives up, complete = false
};

struct Outcome {
  bool complete = true;
  std::int64_t states = 0;  // distinct
  std::int64_t steps = 0;
  std::int64_t ends = 0;  // judged
  std::string violation;  // empty: none
  std::vector<std::string> trace;
};

Outcome explore(Start start, int sources, const Bounds& bounds, RuleSet off = 0);

}  // namespace twinbus::protocol
