// `./twinbus switch`: which source is active, and why another does not take over.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "launcher/bus/bus_link.h"
#include "launcher/operate/bus_joint_name.h"
#include "lcmtypes/msg/refusal_text.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kActivation = 5.0;      // a source listens for others first [s]
constexpr double kAskSwitchAgain = 0.2;  // a lost request is sent again, with its own sequence [s]
constexpr double kAfterRefusal = 0.6;    // a refused one is asked anew: every refusal is an event [s]
constexpr double kStandbyTimeout = 6.0;  // a shadow needs a fresh anchor [s]
constexpr double kFollowTimeout = 4.0;   // for a shadow to get there [s]
constexpr double kFadedIn = 1.0;  // it has faded in and swings with the active source by then [s]
constexpr double kNearPosture = 0.045;   // the source itself refuses 0.05 [rad]
constexpr double kSwitchTimeout = 15.0;  // with when-safe: a stop and 2 s of rest come first [s]
constexpr double kBusyTimeout =
    3.0;  // for the switch before this one to end and its pause to pass [s]
constexpr double kAlignTimeout = 90.0;  // slow on purpose [s]

SourceKind kind_of(const std::string& word) {
  if (word == "sim" || word == "simulator") return SourceKind::kSimulator;
  if (word == "bridge" || word == "robot") return SourceKind::kBridge;
  if (word == "replay") return SourceKind::kReplay;
  throw UsageError("switch: '" + word + "' is no kind of source; it is sim, bridge or replay");
}

// The source of that kind that is not active itself.  Throws std::runtime_error if there is none or more than one.
SeenSource find_target(const StackMonitor& seen, SourceKind kind, std::int64_t wanted_run,
                       std::int64_t active_run) {
  std::optional<SeenSource> found;
  bool active_is_of_kind = false;
  for (const SeenSource* source : seen.sources(monotonic_ns())) {
    if (wanted_run != 0 ? source->status.run_id != wanted_run : source->status.source != kind)
      continue;
    if (source->status.run_id == active_run) {
      active_is_of_kind = true;
      continue;
    }
    if (found) {
      throw std::runtime_error("two sources can be meant, " + describe(*found) + " and " +
                               describe(*source) + "; choose with --run");
    }
    found = *source;
  }
  if (!found) {
    throw std::runtime_error(std::string("no other ") + source_name(kind) + " is running" +
                             (active_is_of_kind ? ": it is active already"
                              : kind == SourceKind::kReplay
                                  ? ": start one with ./twinbus up --stack replay --log FILE"
                                  : ": start one, as in ./twinbus up --stack both"));
  }
  return *found;
}

class Switch {
 public:
  // robot: name or folder, empty: unknown; joints have their names from it.
  Switch(BusLink& bus, std::int64_t active_run, std::int64_t target_run, std::string robot)
      : bus_(bus), active_run_(active_run), target_run_(target_run), robot_(std::move(robot)) {}

  void put_into_standby(bool track) {
    if (in_standby(track)) return;
    SourceRequest request;
    request.action = track ? SourceAction::kStandbyTrack : SourceAction::kStandbyShadow;
    request.run_id = request.target_run_id = target_run_;
    const bool done =
        ask_until(request, target_run_, kStandbyTimeout, [&] { return in_standby(track); });
    if (!done)
      throw std::runtime_error("the target does not go into standby: " +
                               reason(request, target_run_));
  }

  // A shadow that has just begun to follow is still on its way to the posture of the active source, and then still in
  // other motion: it must have been near for a while.
  void wait_for_posture(double lasting) {
    const std::int64_t begin = monotonic_ns();
    std::int64_t near_since = begin;
    while (!quit_requested() && seconds_since(begin) < kFollowTimeout) {
      if (posture_gap() > kNearPosture) {
        if (bus_.seen().controller().mode == Mode::kWalk) return;  // it stands aside until then
        near_since = monotonic_ns();
      } else if (seconds_since(near_since) >= lasting) {
        return;
      }
      bus_.receive(0.02);
    }
  }

  // False with a sentence in why.
  bool hand_over(SwitchPolicy policy, bool align, std::string& why) {
    SourceRequest request;
    request.action = SourceAction::kSwitch;
    request.policy = policy;
    request.align = align;
    request.run_id = active_run_;
    request.target_run_id = target_run_;
    const double timeout = align ? kAlignTimeout : kSwitchTimeout;
    const std::int64_t begin = monotonic_ns();
    while (true) {
      const bool done = ask_until(request, active_run_, timeout, [&] {
        const SeenSource* target = bus_.seen().source(target_run_);
        return target != nullptr && target->on_state && target->status.role == Role::kActive;
      });
      if (done) return true;
      // The switch before has just ended: the source takes the next one in a moment, and so does whoever asked.
      if (!refused_as(Refusal::kBusy, request, active_run_) || seconds_since(begin) > kBusyTimeout)
        break;
      bus_.listen(kAfterRefusal);
      request.sequence = 0;  // a refusal answers one sequence
    }
    why = reason(request, active_run_);
    return false;
  }

 private:
  bool in_standby(bool track) const {
    const SeenSource* target = bus_.seen().source(target_run_);
    return target != nullptr &&
           target->status.role == (track ? Role::kStandbyTrack : Role::kStandbyShadow);
  }

  // Largest difference of a joint between target and active source [rad].
  double posture_gap() const {
    const SeenSource* active = bus_.seen().source(active_run_);
    const SeenSource* target = bus_.seen().source(target_run_);
    if (active == nullptr || target == nullptr || target->states.received() == 0) return 1e9;
    double gap = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(active->state.joint_count); ++k) {
      gap = std::max(gap, std::abs(active->state.q[k] - target->state.q[k]));
    }
    return gap;
  }

  // ": RLEG_KNEE by 0.12 rad now; --align moves the target there first".
  std::string farthest_joint() const {
    const SeenSource* active = bus_.seen().source(active_run_);
    const SeenSource* target = bus_.seen().source(target_run_);
    if (active == nullptr || target == nullptr || target->states.received() == 0) return "";
    std::size_t worst = 0;
    const auto gap = [&](std::size_t k) { return std::abs(active->state.q[k] - target->state.q[k]); };
    for (std::size_t k = 1; k < static_cast<std::size_t>(active->state.joint_count); ++k) {
      if (gap(k) > gap(worst)) worst = k;
    }
    return ": " + bus_joint_name(robot_, active->status.model_hash, worst) + formatted(" by %.2f rad now; --align moves the target there first", gap(worst));
  }

  bool refused(const SourceRequest& request, std::int64_t answering_run) const {
    const SeenSource* source = bus_.seen().source(answering_run);
    return source != nullptr && source->status.refusal != Refusal::kNone &&
           source->status.refusal_sequence == request.sequence;
  }

  bool refused_as(Refusal refusal, const SourceRequest& request, std::int64_t answering_run) const {
    return refused(request, answering_run) &&
           bus_.seen().source(answering_run)->status.refusal == refusal;
  }

  template <class Done>
  bool ask_until(SourceRequest& request, std::int64_t answering_run, double timeout,
                 const Done& done) {
    return bus_.ask(request, kAskSwitchAgain, timeout, [&] { return done() || refused(request, answering_run); }) && done();
  }

  std::string reason(const SourceRequest& request, std::int64_t answering_run) const {
    if (refused(request, answering_run)) {
      const Refusal refusal = bus_.seen().source(answering_run)->status.refusal;
      return refusal_text(refusal) + (refusal == Refusal::kPosture ? farthest_joint() : std::string());
    }
    if (quit_requested()) return "interrupted";
    return "no answer in time";
  }

  BusLink& bus_;
  std::int64_t active_run_;
  std::int64_t target_run_;
  std::string robot_;
};

// Where nobody is active, as after a restart by hand, there is nobody to switch from.
int activate(BusLink& bus, SourceKind kind, std::int64_t wanted_run) {
  if (bus.seen().sources(monotonic_ns()).empty())
    throw std::runtime_error("no source is there on " + bus.url() +
                             "; start one with ./twinbus up");
  const SeenSource target = find_target(bus.seen(), kind, wanted_run, 0);
  SourceRequest request;
  request.action = SourceAction::kActivate;
  request.policy = SwitchPolicy::kNow;
  request.run_id = request.target_run_id = target.status.run_id;
  Refusal why = Refusal::kNone;  // of one of our own requests
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && seconds_since(begin) < kActivation) {
    bus.send(request);
    bus.listen(kAskSwitchAgain);
    const SeenSource* source = bus.seen().source(target.status.run_id);
    if (source == nullptr) continue;
    if (source->status.refusal != Refusal::kNone && source->status.refusal_sequence == request.sequence) {
      why = source->status.refusal;
      request.sequence = 0;  // a new one: a refusal answers one sequence, and its reason may have gone since
      bus.listen(kAfterRefusal);
    }
    if (source->status.role != Role::kActive) continue;
    print_typed(stdout, "switch: nobody was active; %s is now\n", describe(*source).c_str());
    return 0;
  }
  print_typed(stderr, "switch: refused: %s\n",
               why != Refusal::kNone ? refusal_text(why) : "no answer in time");
  return 1;
}

}  // namespace

int switch_command(const std::vector<std::string>& words) {
  const Arguments arguments({"switch", 1, 1, R"(sim|bridge|replay
Asks the active source to hand over to the simulator, the hardware bridge or the replay.  The target is put
into standby first.  Prints why when it is refused; nothing has moved then.
  --policy P  now, or when-safe (default): after the controller's shortest safe stop
  --align  moves the target robot to the posture slowly first
  --standby S  of the target until then: shadow or track; default track where a state can be imposed
  --robot  names its joints in a refusal; default the robot of the running ./twinbus up
  --run ID  of the target, where there are several of its kind (see ./twinbus status --json)
  --prefix --url --allow)"}, words);
  const SourceKind kind = kind_of(arguments.word(0));
  const std::string policy = arguments.text("--policy", "when-safe");
  if (policy != "now" && policy != "when-safe")
    throw UsageError("switch: --policy is now or when-safe, got '" + policy + "'");
  const std::string standby = arguments.text("--standby", "");
  if (!standby.empty() && standby != "shadow" && standby != "track") {
    throw UsageError("switch: --standby is shadow or track, got '" + standby + "'");
  }
  const auto wanted_run =
      static_cast<std::int64_t>(arguments.number("--run", 0.0, 1.0, 9007199254740991.0));
  BusLink bus = open_bus(arguments);
  const SeenSource* active = wait_for_active(bus, 1.0);
  if (active == nullptr) return activate(bus, kind, wanted_run);
  const SeenSource from = *active;
  const SeenSource target = find_target(bus.seen(), kind, wanted_run, from.status.run_id);
  const bool track = standby.empty() ? target.status.can_be_set : standby == "track";

  Switch change(bus, from.status.run_id, target.status.run_id, arguments.text("--robot", ""));
  const bool already_standby = standby.empty() && (target.status.role == Role::kStandbyTrack ||
                                                   target.status.role == Role::kStandbyShadow);
  if (!already_standby) change.put_into_standby(track);
  if (!arguments.has("--align"))
    change.wait_for_posture(already_standby || track ? 0.0 : kFadedIn);
  const std::int64_t begin = monotonic_ns();
  std::string why;
  if (!change.hand_over(policy == "now" ? SwitchPolicy::kNow : SwitchPolicy::kWhenSafe,
                        arguments.has("--align"), why)) {
    print_typed(stderr, "switch: refused: %s\n", why.c_str());
    return 1;
  }
  const SeenSource* now_active = bus.seen().source(target.status.run_id);
  print_typed(stdout, "switch: %s took over from %s after %.0f ms, at tick %lld\n",
              describe(*now_active).c_str(), describe(from).c_str(), 1e3 * seconds_since(begin),
              static_cast<long long>(bus.seen().newest_state().tick));
  return 0;
}

}  // namespace twinbus::launcher
