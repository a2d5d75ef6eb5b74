// The rules of doc/protocol.md that a test can switch off one at a time, to see that the explorer
// notices.
//
// Nothing in the product ever switches one off: RuleSet is empty unless test/protocol fills it.

#pragma once

#include <cstdint>

namespace twinbus::inline bridge {

enum class Rule : std::uint8_t {
  // command gate
  kCommandRun,       // a command names the run it is for
  kCommandTerm,      // and its term
  kCommandOrder,     // ticks strictly increase
  kCommandAge,       // not older than the timeout
  kOneController,    // bound to the first controller
  kTimeoutStops,     // silence of the controller stops
  kStopLatches,      // a stop stays, whatever comes after
  kHigherKindWins,   // a lower stop never replaces a higher one
  kStopShutsGate,    // no client command passes a hold or an off
  kClearNeedsNonce,  // a clear echoes the nonce in force
  kNonceChanges,     // every stop has its own nonce
  // handover
  kListenFirst,            // a cold start listens before it activates
  kActivateAlone,          // no activation while another source is heard
  kActivateAsked,          // an activation names its target
  kTermAdvances,           // activation takes the highest term heard + 1
  kSwitchAddressed,        // a switch names the active source
  kSwitchChecked,          // posture, load, freshness ... are compared before a grant
  kGrantNamed,             // only the granted run takes over
  kGrantTick,              // and not before the grant tick
  kGrantFresh,             // and not on a grant that it has lost sight of
  kOldHolderStopsObeying,  // the old holder obeys up to the grant tick only
  kReleaseOnSuccessor,     // it leaves STATE when its successor is seen
  kCancelSilent,           // it cancels when no successor appears
  kCancelRaisesTerm,       // by two
  kStandDown,              // a successor that sees the cancel stands down
  kStopRevokesGrant,       // a stop before the successor is seen cancels the switch
  kStoppedStaysOut,        // a stopped source does not take over
  kBelieveByRule,          // a higher term is believed only by grant, cancel or activation
  kSwitchRate,             // one switch a second
  kGiveWay,                // of two sources on STATE the one nobody commands gives way
  // stop plans
  kPlanWhole,        // counts only when all its pieces are there
  kPlanUnmixed,      // pieces of two plans never make one
  kPlanOrder,        // an older one never replaces a newer one
  kPlanSource,       // it is for this run and term
  kPlanController,   // and of the controller that is obeyed
  kPlanAge,          // one that began long ago is not followed
  kPlanAtOnce,       // it is followed from the first tick without a command
  kPlanKept,         // the one that is followed stays
  kPlanOtherWaits,   // another controller waits for its end
  kPlanResumeSoon,   // its own does, too, when it was silent for long
  kPlanResumeNew,    // and goes on with a command that was made after the silence
  kPlanStopStays,    // after a stop nobody ends it
  kPlanOffEnds,      // off is off, plan or not
  kPlanEndLatches,   // its end latches a stop
  kCount
};

// Bit set: rule switched off.
using RuleSet = std::uint64_t;

constexpr RuleSet without(Rule rule) { return RuleSet{1} << static_cast<unsigned>(rule); }
constexpr bool holds(RuleSet off, Rule rule) { return (off & without(rule)) == 0; }

}  // namespace twinbus::bridge
