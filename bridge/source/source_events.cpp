#include "bridge/source/source_events.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "common/math/index.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/refusal_text.h"
#include "lcmtypes/msg/status.h"
#include "robot/stop_plan/plan_assembler.h"

namespace twinbus::inline bridge {

namespace {

__attribute__((format(printf, 3, 4))) void say(Event& event, int severity, const char* format,
                                               ...) noexcept {
  event.severity = static_cast<std::int8_t>(severity);
  event.text.fill('\0');
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(event.text.data(), event.text.size(), format, arguments);
  va_end(arguments);
}

constexpr std::int64_t kManyPlans = 25;  // one after the other: a second of them

constexpr const char* kReason[] = {
    "no reason given",
    "asked by the operator",
    "asked on the gamepad",
    "asked in the viewer",
    "asked by the guard",
    "the stack is being ended",
    "asked by the controller",
    "no command for the command timeout: is the controller running?",
    "the device failed",
    "rest before a switch",
    "the robot has fallen; put it on its feet, then clear the stop"};  // StopReason::kFallen

// An alarm only where somebody has to act: who asked for a stop knows of it.
int severity_of(StopReason reason) noexcept {
  switch (reason) {
    case StopReason::kOperator:
    case StopReason::kGamepad:
    case StopReason::kViewer:
      return 1;
    case StopReason::kLauncher:
    case StopReason::kSwitch:
      return 0;
    default:
      return 2;
  }
}

const char* role_sentence(Role before, Role now) noexcept {
  switch (now) {
    case Role::kActive:
      if (before == Role::kReleasing)
        return "the target did not take over in time: I stay active, in a new term";
      if (before == Role::kStopped) return "the stop is cleared: active again";
      return "I am the active source now";
    case Role::kReleasing:
      return "handing over to the target";
    case Role::kParked:
      return "parked";
    case Role::kStandbyTrack:
      return "standby: I take over the state of the active source";
    case Role::kStandbyShadow:
      return "standby: I follow the commands of the active source";
    case Role::kStopped:
      return "stopped";
    case Role::kNone:
      break;
  }
  return "no role";
}

}  // namespace

std::array<char, 200> cut_sentence(const FirstCut& cut, const Model& model) noexcept {
  std::array<char, 200> text{};
  using What = FirstCut::What;
  if (cut.what == What::kNone || cut.joint < 0 || cut.joint >= model.bus_count()) return text;
  const Joint& joint = model.joints[at(model.bus_joints[at(cut.joint)])];
  const bool slides = joint.kind == JointKind::kPrismatic;
  const char* const position = slides ? "m" : "rad";
  const char* const force = slides ? "N" : "N m";
  struct Words {
    const char *quantity, *unit;
  };
  const auto words = [&]() -> Words {
    switch (cut.what) {
      case What::kPosition:
        return {"position", position};
      case What::kVelocity:
        return {"velocity", slides ? "m/s" : "rad/s"};
      case What::kTorque:
        return {"torque", force};
      case What::kStiffness:
        return {"stiffness kp", ""};
      case What::kDamping:
        return {"damping kd", ""};
      case What::kPositionStep:
        return {"change of position in one tick", position};
      case What::kTorqueStep:
        return {"change of torque in one tick", force};
      case What::kNone:
        break;
    }
    return {"", ""};
  }();
  const char* const space = *words.unit != '\0' ? " " : "";
  // As many digits as it takes to tell the two apart.
  std::array<char, 40> asked{}, given{};
  for (int digits = 4; digits <= 17; ++digits) {
    std::snprintf(asked.data(), asked.size(), "%.*g", digits, cut.asked);
    std::snprintf(given.data(), given.size(), "%.*g", digits, cut.given);
    if (std::strcmp(asked.data(), given.data()) != 0) break;
  }
  std::snprintf(text.data(), text.size(), "%s: %s %s%s%s asked, %s given", joint.name.c_str(), words.quantity, asked.data(),
                space, words.unit, given.data());
  return text;
}

bool CutTeller::next(const FirstCut& cut, const FirstCut& catch_up, const Model& model, Event& event) noexcept {
  if (!cut_told_ && cut.what != FirstCut::What::kNone) {
    cut_told_ = true;
    say(event, 1, "a command was beyond a limit: %.140s; it is cut, and further ones are counted",
        cut_sentence(cut, model).data());
    return true;
  }
  if (!catch_up_told_ && catch_up.what != FirstCut::What::kNone) {
    catch_up_told_ = true;
    say(event, 0, "after %lld %s without a command the joints catch up within their limits (%.110s); later ones are counted",
        static_cast<long long>(catch_up.silent), catch_up.silent == 1 ? "tick" : "ticks",
        cut_sentence(catch_up, model).data());
    return true;
  }
  return false;
}

bool next_sentence(SourceStatus& told, const SourceStatus& now, Event& event) noexcept {
  if (told.role != now.role) {
    say(event, 0, "%s (term %d)", role_sentence(told.role, now.role), static_cast<int>(now.term));
    told.role = now.role;
    return true;
  }
  if (told.stop_kind != now.stop_kind) {
    if (now.stop_kind != StopKind::kNone) {
      say(event, severity_of(now.stop_reason), "stop '%s': %s", label(now.stop_kind),
          name_of(now.stop_reason, kReason, "unknown reason"));
    } else {
      say(event, 0, "stop cleared");
    }
    told.stop_kind = now.stop_kind;
    return true;
  }
  if (now.refusal != Refusal::kNone &&
      (told.refusal != now.refusal || told.refusal_sequence != now.refusal_sequence)) {
    told.refusal = now.refusal;
    told.refusal_sequence = now.refusal_sequence;
    say(event, 1, "refused: %s", refusal_text(now.refusal));
    return true;
  }
  told.refusal = now.refusal;
  told.refusal_sequence = now.refusal_sequence;
  if (told.controller_id != now.controller_id) {
    told.controller_id = now.controller_id;
    if (now.controller_id == 0) return next_sentence(told, now, event);
    say(event, 0, "obeys a controller (its controller_id: %lld)",
        static_cast<long long>(now.controller_id));
    return true;
  }
  if (told.terms_ignored == 0 && now.terms_ignored > 0) {
    told.terms_ignored = now.terms_ignored;
    say(event, 2, "somebody publishes on STATE with a term nobody granted: ignored and counted");
    return true;
  }
  if (now.plans_accepted != told.plans_accepted) {
    told.plans_accepted = now.plans_accepted;
    told.plans_refused = now.plans_refused;
    told.plan_refusal = 0;
  }
  if (now.plans_refused - told.plans_refused >= kManyPlans && told.plan_refusal != now.plan_refusal) {
    told.plan_refusal = now.plan_refusal;
    say(event, 1, "stop plans are refused: %s; the robot is held where it is if commands fail",
        to_text(static_cast<PlanRefusal>(now.plan_refusal)));
    return true;
  }
  return false;
}

}  // namespace twinbus::bridge
