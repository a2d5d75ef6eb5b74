#include "lcmtypes/msg/refusal_text.h"

#include "common/text/name_of.h"

namespace twinbus::inline lcmtypes {

namespace {

// Why, and what to do.
constexpr const char* kRefusal[] = {
    "not refused",
    "the request names another run than the active source; look at status and ask again",
    "the target is not heard on its own channel; start it first",
    "the sources have different robot models; give both the same robot folder",
    "the sources have different periods; give both the same period in robot.yaml",
    "one of the sources is silent for longer than the state timeout; check that both run in time",
    "one of the sources is stopped; clear the stop first",
    "a joint of the target differs by more than 0.05 rad; move it there or switch with --align",
    "a joint of the target differs by more than 0.5 rad/s; wait until both move alike",
    "roll or pitch of the target differs by more than 0.05 rad; set the robot upright alike",
    "the angular velocity of the target differs by more than 0.3 rad/s; wait until both are steady",
    "not the same feet carry load in both sources; put the target on the same feet",
    "the total foot force differs by more than 20 %; lower the target to the ground fully",
    "the robot would be left while not statically stable; stop walking first, or use policy when-safe",
    "another switch is under way or has just ended; ask again in a moment",
    "the target is the active source already",
    "another source is active; switch to the target instead of activating it",
    "the run is not in real time; set the pace to real time before switching to hardware",
    "the target cannot take over a state; use standby shadow instead of track",
    "the target is neither in standby nor can a state be imposed on it; put it in standby first",
    "the device of the target reports an error; look at its status"};

}  // namespace

const char* refusal_text(Refusal refusal) noexcept {
  return name_of(refusal, kRefusal, "refused for a reason that this version does not know");
}

}  // namespace twinbus::lcmtypes
