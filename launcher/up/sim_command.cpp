// `./twinbus sim` and `push`: pause, single steps, slow motion, reset of the simulated world; a push.

#include "launcher/commands/commands.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "launcher/bus/bus_link.h"
#include "launcher/stack/asked_robot.h"
#include "launcher/stack/run_folder.h"
#include "launcher/up/restart.h"
#include "robot/description/load.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kAnswer = 1.0;  // a simulator answers within [s]
constexpr int kRepeats = 5;      // sent; the same sequence counts once
constexpr double kReset = 30.0;  // a stack begins anew within [s]

// Sends it to the active simulator and prints what that says.
int ask_simulator(const Arguments& arguments, SimRequest& request) {
  BusLink bus = open_bus(arguments);
  const SeenSource& active = active_source(bus);
  if (active.status.source != SourceKind::kSimulator)
    throw std::runtime_error("the active source is a " +
                             std::string(source_name(active.status.source)) +
                             ", not a simulator; ./twinbus switch sim makes one active");
  if (request.action == SimAction::kPush) refuse_while_paused(bus.seen(), monotonic_ns());
  request.run_id = active.status.run_id;
  if (request.action == SimAction::kPush && active.status.model_hash != request.model_hash)
    throw std::runtime_error("the robot that runs is not the one that was asked for: say which with --robot");
  (void)bus.seen().take_events();
  const std::int64_t begin = monotonic_ns();
  for (int sent = 0; seconds_since(begin) < kAnswer && !quit_requested();) {
    if (sent < kRepeats) {
      bus.send(request);
      ++sent;
    }
    bus.listen(0.04);
    for (const std::string& event : bus.seen().take_events()) {
      if (!event.starts_with("simulator: ")) continue;
      const bool refused = event.find("refused") != std::string::npos;
      print_typed(refused ? stderr : stdout, "%s\n", event.c_str());
      return refused ? 1 : 0;
    }
  }
  throw std::runtime_error("the simulator does not answer");
}

int reset_world() {
  const std::string folder = running_folder() + "/setup", answer = folder + "/answer";
  ::unlink(answer.c_str());
  write_whole(folder + "/wish.json", "{\"again\": true}");
  const std::int64_t begin = monotonic_ns();
  while (seconds_since(begin) < kReset && !quit_requested()) {
    ::usleep(50'000);
    std::ifstream stream(answer);
    std::string line;
    if (!std::getline(stream, line)) continue;
    if (!line.starts_with("ok ")) throw std::runtime_error(line.substr(3));
    print_typed(stdout, "sim: %s\n", line.substr(3).c_str());
    return 0;
  }
  throw std::runtime_error("the stack does not answer");
}

}  // namespace

int push_command(const std::vector<std::string>& words) {
  const Arguments arguments({"push", 4, 4, R"(LINK FX FY FZ
Pushes a link of the simulated robot with a force [N] along the axes of the world (x forward at the start,
y left, z up), as in: ./twinbus push CHEST 60 0 0 --for 0.2
  --for S  seconds; default 0.1
  --at X,Y,Z  where on the link, in its frame [m]; default its centre of mass
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --prefix --url --allow)"}, words);
  const Model model = load_robot(asked_robot(arguments));
  const int link = model.find_link(arguments.word(0));
  if (link < 0) {
    BusLink bus = open_bus(arguments);
    const SeenSource* active = wait_for_active(bus, kAnswer);
    if (active != nullptr && active->status.model_hash != model.hash)
      throw std::runtime_error("push: the robot that runs is not " + model.name + ": say which with --robot");
    throw UsageError("push: " + model.name + " has no link '" + arguments.word(0) + "'" + suggestion(arguments.word(0), model.links));
  }
  SimRequest request;
  request.action = SimAction::kPush;
  request.model_hash = model.hash;
  request.link = static_cast<std::int16_t>(link);
  const std::array<const char*, 3> names = {"FX", "FY", "FZ"};
  const Eigen::Vector3d& com = model.links[static_cast<std::size_t>(link)].com;
  std::array<double, 3> at = {com.x(), com.y(), com.z()};
  if (arguments.has("--at") &&
      std::sscanf(arguments.text("--at", "").c_str(), "%lf,%lf,%lf", &at[0], &at[1], &at[2]) != 3)
    throw UsageError("push: --at is three numbers, as in 0,0.1,0.2");
  for (std::size_t i = 0; i < 3; ++i) {
    request.force[i] = static_cast<float>(arguments.word_number(i + 1, names[i], -1e5, 1e5));
    request.point[i] = static_cast<float>(at[i]);
  }
  request.duration = static_cast<float>(arguments.number("--for", 0.1, 0.001, 60.0));
  return ask_simulator(arguments, request);
}

int sim_command(const std::vector<std::string>& words) {
  const std::vector<std::string> known = {"pause", "go", "step", "pace", "reset"};
  const Arguments arguments({"sim", 1, 2, R"(pause | go | step [TICKS] | pace X | reset
The simulated world of the running stack: stands still, goes on, does some ticks (default 1) and stands
still, runs X times as fast as real time (0.01 to 10), or begins anew with its controller.  A robot behind
the bridge does none of it, but a stand-in robot begins anew too (reset), whether it is active or not.
  --prefix --url --allow)"}, words);
  const std::string what = arguments.word(0);
  const bool takes_number = what == "step" || what == "pace";
  if (arguments.words().size() > 1 && !takes_number)
    throw UsageError("sim: " + what + " takes nothing more");
  SimRequest request;
  if (what == "pause") {
    request.action = SimAction::kPause;
  } else if (what == "go") {
    request.action = SimAction::kGo;
  } else if (what == "step") {
    request.action = SimAction::kStep;
    request.ticks = arguments.words().size() > 1
                        ? static_cast<std::int32_t>(arguments.word_number(1, "TICKS", 1, 100'000))
                        : 1;
    if (arguments.words().size() > 1 && arguments.word(1).find_first_not_of("0123456789") != std::string::npos)
      throw UsageError("sim: TICKS is a whole number, not " + arguments.word(1));
  } else if (what == "pace") {
    if (arguments.words().size() != 2) throw UsageError("sim: pace X, as in pace 0.1");
    request.action = SimAction::kPace;
    request.pace = static_cast<float>(arguments.word_number(1, "X", 0.01, 10.0));
  } else if (what == "reset") {
    return reset_world();
  } else {
    throw UsageError("sim: no '" + what + "'" + suggestion(what, known));
  }
  return ask_simulator(arguments, request);
}

}  // namespace twinbus::launcher
