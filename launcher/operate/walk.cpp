// `./twinbus walk`: a velocity for a while, or footsteps of a file; says how it ended.

#include "launcher/commands/commands.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "control/point_feet/step_gait.h"
#include "control/walk/listed_steps.h"
#include "control/walk/walk_gains.h"
#include "launcher/bus/bus_link.h"
#include "launcher/operate/operate.h"
#include "launcher/stack/asked_robot.h"
#include "lcmtypes/msg/labels.h"
#include "robot/description/load.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kSaidLimit = 0.005;  // of a velocity that is less than it was asked [m/s, rad/s]
constexpr double kRefusalTime = 0.3;  // in which a controller says that it does not walk so [s]
constexpr double kRest = 0.02;        // slower the centre of mass rests [m/s]
constexpr double kRestTime = 0.5;     // [s]
constexpr double kMotionEnds = 10.0;  // a motion that is played has been ended by then [s]
constexpr int kListRepeats = 3;           // of a list, in case one is lost

// A robot that cannot do them is not asked.
StepList read_feasible_steps(const std::string& file, const Model& model, const Gait& gait) {
  const ConfigNode top = ConfigNode::load(file);
  const StepList list = read_steps(top);
  top.finish();
  const StepRefusal refusal = check_steps(gait, list);
  if (refusal.why != nullptr)
    throw std::runtime_error(file + ": step " + std::to_string(refusal.step + 1) + " (" +
                             model.name + "): " + refusal.why);
  return list;
}

bool enter_walk(BusLink& bus, ModeRequest& request) {
  request.mode = Mode::kWalk;
  ask_controller(bus, request);
  bus.listen(0.1);
  if (bus.seen().controller_statuses().received() == 0)
    throw std::runtime_error("no controller is running");
  // A motion is ended first, and the robot goes back to where it stood.
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && bus.seen().controller().motion == Motion::kPlayed && seconds_since(begin) < kMotionEnds)
    bus.listen(0.05);
  bus.listen(0.05);
  if (bus.seen().controller().mode == Mode::kWalk) return true;
  print_typed(stderr, "walk: %s\n", why_it_stays(bus, request).c_str());
  return false;
}

// Listens until the robot stands again; false when it does not.
bool wait_for_rest(BusLink& bus, double least, double most) {
  const std::int64_t begin = monotonic_ns();
  std::int64_t moved = begin;
  while (!quit_requested() && seconds_since(begin) < most) {
    bus.listen(0.05);
    const ControllerStatus& status = bus.seen().controller();
    if (status.mode != Mode::kWalk) return false;
    const auto& v = status.com_velocity;
    if (std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1])) > kRest)
      moved = monotonic_ns();
    if (seconds_since(begin) > least && seconds_since(moved) > kRestTime) return true;
  }
  return false;
}

// Why the robot does not walk any more; empty while it does.
std::string why_it_ended(BusLink& bus, const ModeRequest& request) {
  const SeenSource* active = bus.seen().active(monotonic_ns());
  if (bus.seen().figures().fell) return "the robot fell; ./twinbus sim reset begins anew";
  if (active != nullptr && active->status.stop_kind != StopKind::kNone) return why_it_stays(bus, request);
  if (is_paused(bus.seen(), monotonic_ns())) return "";
  const ControllerStatus& status = bus.seen().controller();
  if (status.mode == Mode::kWalk || bus.seen().controller_statuses().age(monotonic_ns()) > 0.5) return "";
  if (status.mode == Mode::kStop) return why_it_stays(bus, request);  // it said why
  return std::string("something else was asked: the controller is in mode ") + label(status.mode);
}

Eigen::Vector3d possible_of(const Model& model, const Eigen::Vector3d& asked) {
  if (why_no_point_feet(model) == nullptr) return step_gait_of(model).possible(asked);
  return gait_of(model, model.walking, WalkGains{}.stabilizer.margin).possible(asked);
}

// All the speeds at their most are more than the legs can do at once.
void say_if_limited(const Model& model, std::int64_t running_hash, const WalkCommand& command) {
  if (running_hash != model.hash) return;  // another robot: its limits are not known here
  const Eigen::Vector3d asked = Eigen::Vector3f(command.vx, command.vy, command.wz).cast<double>();
  const Eigen::Vector3d possible = possible_of(model, asked);
  if ((possible - asked).cwiseAbs().maxCoeff() < kSaidLimit) return;
  print_typed(stdout, "walk: limited to %.2f %.2f %.2f, more at once %s does not walk\n", possible.x(), possible.y(),
              possible.z(), model.name.c_str());
  std::fflush(stdout);
}

int walk_steps(const Arguments& arguments) {
  const Model model = load_robot(asked_robot(arguments));
  const Gait gait = gait_of(model, model.walking, WalkGains{}.stabilizer.margin);
  StepList list = read_feasible_steps(arguments.text("--steps", ""), model, gait);
  BusLink bus = open_bus(arguments);
  ModeRequest request;
  if (!enter_walk(bus, request)) return 1;
  if (bus.seen().newest_state().model_hash != model.hash)
    throw std::runtime_error("the robot that runs is not " + model.name + ": say --robot");
  (void)bus.seen().take_events();
  list.run_id = request.run_id;
  for (int i = 0; i < kListRepeats; ++i) {
    bus.send(list);  // stamped once
    bus.listen(kRefusalTime / kListRepeats);
  }
  for (const std::string& event : bus.seen().take_events()) {
    if (event.find("footstep") == std::string::npos) continue;
    print_typed(stderr, "walk: %s\n", event.c_str());
    return 1;
  }
  const double time = gait.first_double + list.count * gait.period();
  if (!wait_for_rest(bus, time, 2.0 * time + 10.0)) {
    print_typed(stderr, "walk: the robot was kept from walking its %d steps to the end\n",
                 static_cast<int>(list.count));
    return 1;
  }
  print_typed(stdout, "walk: done, %d steps\n", static_cast<int>(list.count));
  return 0;
}

}  // namespace

int walk_command(const std::vector<std::string>& words) {
  const Arguments arguments({"walk", 0, 3, R"(VX VY WZ | --steps FILE
Walks at VX m/s forward, VY m/s to the left, turning WZ rad/s to the left, for some seconds;
or the footsteps of a YAML file, at most 32 that take turns, each in the frame of the foot that
stands then (x forward, y left [m], yaw [rad]):
    steps:
      - {foot: left, x: 0.2, y: 0.2, yaw: 0.1}
      - {foot: right, x: 0.2, y: -0.2}
What the legs do not reach, and a sole on the other, is refused before anything moves.
  --for S  seconds; default 2
  --steps FILE  footsteps instead of a velocity
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --prefix --url --allow)"}, words);
  if (arguments.has("--steps")) {
    if (!arguments.words().empty() || arguments.has("--for"))
      throw UsageError("walk: --steps FILE stands alone, without a velocity or a time");
    return walk_steps(arguments);
  }
  if (arguments.words().size() != 3) throw UsageError("walk: it takes VX VY WZ, or --steps FILE");
  WalkCommand command;
  command.vx = static_cast<float>(arguments.word_number(0, "VX", -2.0, 2.0));
  command.vy = static_cast<float>(arguments.word_number(1, "VY", -1.0, 1.0));
  command.wz = static_cast<float>(arguments.word_number(2, "WZ", -2.0, 2.0));
  command.timeout = 0.3F;
  const Model model = load_robot(asked_robot(arguments));
  const double duration = arguments.number("--for", 2.0, 0.1, 3600.0);
  BusLink bus = open_bus(arguments);
  ModeRequest request;
  if (!enter_walk(bus, request)) return 1;
  say_if_limited(model, bus.seen().newest_state().model_hash, command);
  command.run_id = request.run_id;
  (void)bus.seen().take_events();
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && seconds_since(begin) < duration) {
    if (const std::string why = why_it_ended(bus, request); !why.empty()) {
      print_typed(stderr, "walk: ended after %.1f s: %s\n", seconds_since(begin), why.c_str());
      return 1;
    }
    command.sequence = 0;                               // each its own
    command.run_id = bus.seen().newest_state().run_id;  // whichever source it is by now
    bus.send(command);
    bus.listen(0.05);
  }
  command.sequence = 0;
  command.vx = command.vy = command.wz = 0.0F;
  bus.send(command);
  bus.listen(0.05);
  if (const std::string why = why_it_ended(bus, request); !why.empty()) {
    print_typed(stderr, "walk: %s\n", why.c_str());
    return 1;
  }
  print_typed(stdout,
              "walk: done; the robot stands in mode walk and steps when it is pushed (./twinbus mode balance ends that)\n");
  return 0;
}

}  // namespace twinbus::launcher
