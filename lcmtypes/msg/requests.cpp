#include "lcmtypes/msg/requests.h"

namespace twinbus {

const char* refusal_text(Refusal refusal) noexcept {
  switch (refusal) {
    case Refusal::kNone:
      return "not refused";
    case Refusal::kNotAddressed:
      return "the request names another run than the active source; look at status and ask again";
    case Refusal::kUnknownTarget:
      return "the target is not heard on its own channel; start it first";
    case Refusal::kModelHash:
      return "the sources have different robot models; give both the same robot folder";
    case Refusal::kPeriod:
      return "the sources have different periods; give both the same period in robot.yaml";
    case Refusal::kStale:
      return "one of the sources is silent for longer than the state timeout; check that both run "
             "in time";
    case Refusal::kStopped:
      return "one of the sources is stopped; clear the stop first";
    case Refusal::kPosture:
      return "a joint of the target differs by more than 0.05 rad; move it there or switch with "
             "--align";
    case Refusal::kVelocity:
      return "a joint of the target differs by more than 0.5 rad/s; wait until both move alike";
    case Refusal::kAttitude:
      return "roll or pitch of the target differs by more than 0.05 rad; set the robot upright "
             "alike";
    case Refusal::kGyro:
      return "the angular velocity of the target differs by more than 0.3 rad/s; wait until both "
             "are steady";
    case Refusal::kFeet:
      return "not the same feet carry load in both sources; put the target on the same feet";
    case Refusal::kLoad:
      return "the total foot force differs by more than 20 %; lower the target to the ground fully";
    case Refusal::kUnstable:
      return "the robot would be left while not statically stable; stop walking first, or use "
             "policy when_safe";
    case Refusal::kBusy:
      return "another switch is under way or has just ended; ask again in a moment";
    case Refusal::kAlreadyActive:
      return "the target is the active source already";
    case Refusal::kAnotherActive:
      return "another source is active; switch to the target instead of activating it";
    case Refusal::kPace:
      return "the run is not in real time; set the pace to real time before switching to hardware";
    case Refusal::kCannotBeSet:
      return "the target cannot take over a state; use standby shadow instead of track";
    case Refusal::kNotStandby:
      return "the target is neither in standby nor can a state be imposed on it; put it in standby "
             "first";
    case Refusal::kDevice:
      return "the device of the target reports an error; look at its status";
  }
  return "refused for a reason that this version does not know";
}

}  // namespace twinbus
