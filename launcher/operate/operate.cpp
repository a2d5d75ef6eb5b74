#include "launcher/operate/operate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "launcher/bus/bus_link.h"
#include "launcher/commands/commands.h"
#include "launcher/operate/bus_joint_name.h"
#include "launcher/stack/asked_robot.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/motion_defaults.h"
#include "robot/description/load.h"
#include "robot/kinematics/pose_request.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kAskAgain = 0.1;       // [s]
constexpr double kAnswerTimeout = 2.0;  // [s]
constexpr double kPausedAnswer = 0.5;   // a world that stands still has heard it by then [s]
constexpr double kWalkEnds = 6.0;       // a walk is brought to rest by then [s]
constexpr double kLongestPose = 125.0;  // what a controller takes for one at most, and a little [s]
constexpr int kStopRepeats = 5;         // sent at once, before anything is heard

// While a balanced stop was asked: the stop that came of it.
const char* kind_text(StopKind asked, StopKind now) {
  return asked == StopKind::kBalanced && now == StopKind::kHold ? "balanced, and then held" : label(now);
}

}  // namespace

bool ask_controller(BusLink& bus, ModeRequest& request) {
  request.run_id = active_source(bus).status.run_id;
  refuse_while_paused(bus.seen(), monotonic_ns());
  refuse_in_replay(bus.seen(), monotonic_ns());
  return bus.ask(request, kAskAgain, kAnswerTimeout,
                 [&] { return bus.seen().controller().mode_sequence == request.sequence; });
}

namespace {

// What the controller has answered since this was last asked; "" when nothing.  A policy's notes of its own begin with its name.
std::string said_by_controller(BusLink& bus) {
  for (const std::string& event : bus.seen().take_events()) {
    if (event.starts_with("controller: ") && !event.starts_with("controller: policy: ")) return event.substr(event.find(' ') + 1);
  }
  return "";
}

}  // namespace

std::string why_it_stays(BusLink& bus, const ModeRequest& request) {
  const SeenSource* active = bus.seen().active(monotonic_ns());
  if (bus.seen().figures().fell) return "the robot has fallen: ./twinbus sim reset puts it on its feet";
  if (active != nullptr && active->status.stop_kind != StopKind::kNone) {
    return std::string("the robot is stopped (") + label(active->status.stop_kind) +
           "): ./twinbus clear ends that";
  }
  if (bus.seen().controller().mode_sequence != request.sequence)
    return "the controller does not answer (./twinbus status)";
  if (std::string said = said_by_controller(bus); !said.empty()) return said;
  return std::string("the controller stays in mode ") + label(bus.seen().controller().mode);
}

namespace {

// "the robot sways (./twinbus mode balance ends that)"
std::string what_it_does(const ControllerStatus& status, const ModeRequest& request) {
  const std::string motion = motion_text(status);
  if (motion.empty()) return std::string("the controller is in mode ") + label(status.mode);
  if (request.motion != Motion::kNone) return "the robot " + motion + " (./twinbus mode balance ends that)";
  return std::string("the controller is in mode ") + label(status.mode) + ", what was left of the motion dies away";
}

bool does(const ControllerStatus& status, const ModeRequest& request) {
  // A motion that was ended dies away for a while.
  const bool wanted = request.motion == Motion::kPlayed;
  return status.mode == request.mode && (status.motion == Motion::kPlayed) == wanted &&
         (request.motion == Motion::kNone || status.motion == request.motion);
}

}  // namespace

std::string what_rests(const RobotState& state, const ModeRequest& request) {
  std::size_t worst = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(state.joint_count); ++k) {
    const double gap = (request.joint_mask >> k & 1) != 0 ? std::abs(state.q[k] - request.q[k]) : -1.0;
    if (gap > most) worst = k, most = gap;
  }
  return bus_joint_name("", state.model_hash, worst) +
         formatted(" rests %.3f rad or m short of it: the guard holds it (./twinbus status), something blocks it, or its servo gives way under the load",
                   std::max(most, 0.0));
}

bool wait_for_joints(BusLink& bus, const ModeRequest& request, const JointsRest& rest) {
  const std::int64_t begin = monotonic_ns();
  std::int64_t moved_ns = begin;
  std::array<double, kMaxJoints> last = bus.seen().newest_state().q;
  while (!quit_requested() && seconds_since(begin) < kLongestPose) {
    bus.listen(0.05);
    if (bus.seen().controller().mode != Mode::kPose) return false;
    const RobotState& state = bus.seen().newest_state();
    bool there = true, moved = false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(state.joint_count); ++k) {
      if ((request.joint_mask >> k & 1) == 0) continue;
      there = there && std::abs(state.q[k] - request.q[k]) <= rest.there;
      moved = moved || std::abs(state.q[k] - last[k]) > rest.moved;
    }
    const bool begun = seconds_since(begin) >= static_cast<double>(request.duration);
    if (there && begun) return true;
    if (moved) {
      last = state.q;
      moved_ns = monotonic_ns();
    }
    if (begun && seconds_since(moved_ns) > rest.still) return false;
  }
  return false;
}

namespace {

int report_mode(BusLink& bus, const ModeRequest& request, const char* asked) {
  if (bus.seen().controller_statuses().received() == 0)
    throw std::runtime_error("no controller is running");
  // A walk is brought to rest first, a motion ended; sway dies away before squat begins.
  const std::int64_t begin = monotonic_ns();
  const auto busy = [&] {
    const ControllerStatus& now = bus.seen().controller();
    const bool another = request.motion != Motion::kNone && now.mode == request.mode && now.motion != Motion::kNone;
    return now.mode == Mode::kWalk || now.motion == Motion::kPlayed || request.motion == Motion::kPlayed || another;
  };
  std::string refusal;
  while (!quit_requested() && busy() && refusal.empty() &&
         !does(bus.seen().controller(), request) && seconds_since(begin) < kWalkEnds) {
    bus.listen(0.05);
    // Who has no motion says so at once; who has one says nothing until it has played.
    if (request.motion != Motion::kNone) refusal = said_by_controller(bus);
  }
  bus.listen(0.05);
  if (!does(bus.seen().controller(), request)) {
    print_typed(stderr, "%s: %s\n", asked, (refusal.empty() ? why_it_stays(bus, request) : refusal).c_str());
    return 1;
  }
  if (request.mode != Mode::kPose) {
    print_typed(stdout, "%s: %s\n", asked, what_it_does(bus.seen().controller(), request).c_str());
    return 0;
  }
  if (wait_for_joints(bus, request, {})) {
    print_typed(stdout, "%s: the robot is in the pose\n", asked);
    return 0;
  }
  print_typed(stderr, "%s: the robot did not get there: %s\n", asked,
               bus.seen().controller().mode == Mode::kPose
                   ? what_rests(bus.seen().newest_state(), request).c_str()
                   : why_it_stays(bus, request).c_str());
  return 1;
}

int ask_and_report(const Arguments& arguments, ModeRequest& request, const char* asked) {
  BusLink bus = open_bus(arguments);
  (void)bus.seen().take_events();  // of before
  ask_controller(bus, request);
  bus.listen(0.1);
  return report_mode(bus, request, asked);
}

int motion_command(const std::vector<std::string>& words, Motion motion, const char* name,
                   const char* about) {
  const auto [amplitude, frequency] = defaults_of(motion);
  const std::string options = formatted(R"(
  --amplitude M  metres; default %.2f
  --frequency HZ  per second; default %.1f
  --prefix --url --allow)",
                                        static_cast<double>(amplitude), static_cast<double>(frequency));
  const Arguments arguments({name, 0, 0, std::string("\n") + about + options}, words);
  ModeRequest request;
  request.mode = Mode::kBalance;
  request.motion = motion;
  request.amplitude =
      static_cast<float>(arguments.number("--amplitude", static_cast<double>(amplitude), 0.0, 0.2));
  request.frequency =
      static_cast<float>(arguments.number("--frequency", static_cast<double>(frequency), 0.0, 5.0));
  return ask_and_report(arguments, request, name);
}

}  // namespace

int stop_command(const std::vector<std::string>& words) {
  const Arguments arguments({"stop", 0, 1, R"([balanced|hold|off]
Stops the robot: balanced (default) lets the controller make its shortest safe stop, hold freezes the
posture, off lets go.  Works with the controller dead.  Stays until ./twinbus clear.
  --prefix --url --allow)"}, words);
  const std::string word = arguments.word(0, "balanced");
  const std::vector<std::string> kinds = {"balanced", "hold", "off"};
  const auto found = std::find(kinds.begin(), kinds.end(), word);
  if (found == kinds.end())
    throw UsageError("stop: no kind '" + word + "'" + suggestion(word, kinds));
  BusLink bus = open_bus(arguments);
  StopRequest request;
  request.kind = static_cast<StopKind>(1 + (found - kinds.begin()));
  request.reason = StopReason::kOperator;
  // Said before anything is heard: a stop waits for nothing.
  for (int i = 0; i < kStopRepeats; ++i) bus.send(request);
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && seconds_since(begin) < kAnswerTimeout) {
    bus.listen(0.05);
    const std::vector<const SeenSource*> sources = bus.seen().sources(monotonic_ns());
    const bool all =
        !sources.empty() &&
        std::all_of(sources.begin(), sources.end(), [&](const SeenSource* source) {
          return source->status.stop_kind >= request.kind || source->status.role == Role::kParked;
        });
    const SeenSource* active = bus.seen().active(monotonic_ns());
    if (all && active != nullptr && seconds_since(begin) > 0.15) {
      print_typed(stdout, "stop: %s is stopped (%s); ./twinbus clear lets it go on\n",
                  describe(*active).c_str(), kind_text(request.kind, active->status.stop_kind));
      return 0;
    }
    if (is_paused(bus.seen(), monotonic_ns()) && seconds_since(begin) > kPausedAnswer) {
      print_typed(stdout, "stop: sent; the simulated world is paused and stops with its next tick (./twinbus sim go)\n");
      return 0;
    }
    bus.send(request);
  }
  if (bus.seen().active(monotonic_ns()) == nullptr)
    throw std::runtime_error("sent, but no active source is heard");
  throw std::runtime_error(
      "sent, but the source does not say that it stopped: use the robot's own emergency stop");
}

namespace {

// The gate stays bound to the controller it knew; when that one is gone and another is there, it is meant.
void bind_to_new_controller(BusLink& bus, std::int64_t run) {
  bus.listen(0.3);
  std::int64_t controller = 0;
  bool bound_alive = false;
  for (const SeenProcess* process : bus.seen().processes(monotonic_ns())) {
    if (process->beat.kind != ProcessKind::kController) continue;
    controller = process->beat.process_id;
    bound_alive = bound_alive || controller == bus.seen().source(run)->status.controller_id;
  }
  if (controller == 0 || bound_alive) return;
  ControllerRequest request;
  request.run_id = run;
  request.controller_id = controller;
  for (int i = 0; i < 3; ++i) bus.send(request);
  bus.listen(0.2);
}

// Every source that is stopped, each with its nonce: those that stand by, and one that was parked when it stopped, too.  How
// many there were; throws std::runtime_error naming the one that stays stopped.
std::size_t clear_all(BusLink& bus) {
  std::set<std::int64_t> cleared;
  std::string left;
  for (const std::int64_t begin = monotonic_ns(); !quit_requested() && seconds_since(begin) < kAnswerTimeout;) {
    left.clear();
    for (const SeenSource* source : bus.seen().sources(monotonic_ns())) {
      if (source->status.stop_kind == StopKind::kNone) continue;
      cleared.insert(source->status.run_id);
      left = describe(*source);
      StopRequest request;
      request.kind = StopKind::kNone;
      request.reason = StopReason::kOperator;
      request.stop_nonce = source->status.stop_nonce;
      bus.send(request);
    }
    if (left.empty()) return cleared.size();
    bus.listen(0.15);
  }
  throw std::runtime_error(left + " stays stopped: whatever stopped it still asks for it (./twinbus status)");
}

}  // namespace

int clear_command(const std::vector<std::string>& words) {
  const Arguments arguments({"clear", 0, 0, R"(
Ends a stop: the source goes on from where it stands.  A controller that was started again since is
taken on.
  --prefix --url --allow)"}, words);
  BusLink bus = open_bus(arguments);
  // A source that nobody made active yet may be stopped, too, and cannot become active until that is over.
  if (wait_for_active(bus, 1.0) == nullptr && !bus.seen().sources(monotonic_ns()).empty()) {
    const std::size_t cleared = clear_all(bus);
    print_typed(stdout, "clear: %s; no source is active: ./twinbus switch sim, bridge or replay makes one active\n",
                cleared > 0 ? "no source is stopped any more" : "nothing is stopped");
    return 0;
  }
  const std::int64_t run = active_source(bus).status.run_id;
  refuse_while_paused(bus.seen(), monotonic_ns());
  const bool was_stopped = bus.seen().source(run)->status.stop_kind != StopKind::kNone;
  if (was_stopped) bind_to_new_controller(bus, run);
  const std::size_t cleared = clear_all(bus);
  if (was_stopped) {
    print_typed(stdout, "clear: %s goes on\n", describe(*bus.seen().source(run)).c_str());
  } else {
    print_typed(stdout, cleared > 0 ? "clear: no source is stopped any more\n" : "clear: nothing is stopped\n");
  }
  if (was_stopped && bus.seen().figures().fell)
    print_typed(stdout, "clear: the robot has fallen: ./twinbus sim reset puts it on its feet\n");
  else if (was_stopped && bus.seen().source(run)->lies)
    print_typed(stdout, "clear: the robot lies: put it on its feet, then ./twinbus mode balance; a stand-in robot: ./twinbus sim reset\n");
  return 0;
}

namespace {

// JOINT=ANGLE[,JOINT=ANGLE...]: only these joints move.
void take_angles(const std::string& text, const Model& model, ModeRequest& request) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string one = text.substr(at, end - at);
    at = end + 1;
    const std::size_t equals = one.find('=');
    double angle = 0.0;
    if (equals == std::string::npos || !parse_numbers(one.substr(equals + 1), &angle, 1)) {
      const Joint& first = model.joints[static_cast<std::size_t>(model.bus_joints.front())];
      throw UsageError("pose: '" + one + "' is not JOINT=ANGLE, as in " + first.name + "=0.2");
    }
    const std::string problem = add_joint(model, one.substr(0, equals), angle, request);
    if (!problem.empty()) throw UsageError("pose: " + problem);
  }
}

}  // namespace

int pose_command(const std::vector<std::string>& words) {
  const Arguments arguments({"pose", 1, 1, R"(NAME|JOINT=ANGLE[,JOINT=ANGLE...]
Moves to a named pose of the robot's SRDF (group_state), or these joints to these angles [rad or m].
A pose on whose way a standing robot would fall is refused.
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --duration S  seconds; default 2
  --prefix --url --allow)"}, words);
  const Model model = load_robot(asked_robot(arguments));
  ModeRequest request;
  request.mode = Mode::kPose;
  request.duration = static_cast<float>(arguments.number("--duration", 2.0, 0.1, 60.0));
  if (arguments.word(0).find('=') != std::string::npos) {
    take_angles(arguments.word(0), model, request);
    return ask_and_report(arguments, request, "pose");
  }
  const int pose = model.find_pose(arguments.word(0));
  if (pose < 0)
    throw UsageError("pose: " + model.name + " has no pose '" + arguments.word(0) + "'" + suggestion(arguments.word(0), model.poses));
  const std::vector<double>& q = model.poses[static_cast<std::size_t>(pose)].q;
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    request.q[index] = q[static_cast<std::size_t>(model.bus_joints[index])];
    request.joint_mask |= std::int64_t{1} << k;
  }
  return ask_and_report(arguments, request, "pose");
}

int mode_command(const std::vector<std::string>& words) {
  const std::vector<std::string> names = {"idle", "hold", "balance", "walk", "stop", "play"};
  const std::vector<Mode> modes = {Mode::kIdle, Mode::kHold, Mode::kBalance, Mode::kWalk,
                                   Mode::kStop, Mode::kBalance};
  const Arguments arguments({"mode", 1, 1, R"(idle|hold|balance|walk|stop|play
Asks the controller for a mode; it changes without a jump.  ./twinbus pose, sway and squat ask for what the robot
does in modes pose and balance.  play is for a policy that has a motion (./twinbus policy WALK.onnx --play TRACK.onnx).
  --let-go  with idle: also of a standing robot, which falls
  --prefix --url --allow)"}, words);
  if (arguments.has("--let-go")) {
    if (arguments.word(0) != "idle") throw UsageError("mode: --let-go is for idle");
    std::vector<std::string> off;  // the same options
    for (const std::string& word : words) {
      if (word != "--let-go") off.push_back(word == "idle" ? "off" : word);
    }
    return stop_command(off);
  }
  const auto found = std::find(names.begin(), names.end(), arguments.word(0));
  if (found == names.end())
    throw UsageError("mode: no mode '" + arguments.word(0) + "'" +
                     suggestion(arguments.word(0), names));
  ModeRequest request;
  request.mode = modes[static_cast<std::size_t>(found - names.begin())];
  if (*found == "play") request.motion = Motion::kPlayed;
  return ask_and_report(arguments, request, "mode");
}

int sway_command(const std::vector<std::string>& words) {
  return motion_command(words, Motion::kSway, "sway",
                        "Sways the body from side to side while balancing.");
}

int squat_command(const std::vector<std::string>& words) {
  return motion_command(words, Motion::kSquat, "squat",
                        "Moves the body up and down while balancing.");
}

}  // namespace twinbus::launcher
