#include "launcher/up/up_syntax.h"

#include <cstdlib>

#include <unistd.h>

#include "common/process/priority.h"

namespace twinbus::inline launcher {

Syntax up_syntax() {
  std::string stacks;
  for (const std::string& name : stack_names()) stacks += (stacks.empty() ? "" : ", ") + name;
  return {"up", 0, 1, R"([SCENE]
Starts the processes of a stack, activates its source, shows what runs and stops everything on Ctrl-C.
SCENE is a name in config/scenes or a file; default: stand.  With --for the run is judged: exit status 0 only
if STATE and COMMAND kept their rate, at most 0.1 % of the ticks were missed (1 % without FIFO) and nobody fell.
A tick that was missed only because the machine itself stood still is told, but not held against the stack.
  --robot
  --stack NAME  of config/stacks ()" + stacks + R"(), or a file; default sim
  --engine E  articulated, ode or mujoco; default the scene's
  --lockstep  each tick waits for its command: slower or faster than real time, repeatable
  --rate X  times real time; default 1
  --for S  seconds; then stops, judges and exits
  --start-pose POSE  of the robot's SRDF, in which it begins; default the scene's
  --seed N  of noise and perturbations
  --set KEY=VALUE  setting of the simulator, as in model.mass_scale=1.03; may be repeated
  --accuracy LENGTH  order and step by which no link or body is farther from the converged answer, 0.001 or 1mm, as \
      ./twinbus run finds them, if that fits real time; default the scene's
  --budget TIME  of CPU for the physics in a control period, 0.5 or 0.5ms: the best accuracy that fits
  --face KIND  answers on DDS as a Unitree robot (unitree_hg, unitree_go), so that programs written for it drive; stack default \
      client
  --interface NAME  network interface of --face; default lo
  --face-rate HZ  rt/lowstate per second of --face, 10 to 500; default 500, as the robot: too many for some programs in Python
  --face-patience S  how long --face goes on with a program's last LowCmd when the next is late; default 0.1
  --no-viewer  without the page in the browser
  --listen ADDR  an address of this machine on which a phone may watch and stop, with the token that is printed; 0.0.0.0: all
  --no-record  without a log of the run in its folder
  --split SIZE  of the parts of run.log, as in 500MB (default) or 10min; 0: one file.  Tools take run.log for all
  --quota GB  of run.log with its parts; default 10, but always the last 30 minutes.  A log that misses messages (a full disk) \
      is told with the verdict, and fails a run with --split or --quota
  --log FILE  of --stack replay: the log that is played
  --strict  keeps the clock of a simulated world hard; else, on a machine without real-time rights, it stands still while a \
      command is late, up to 200 ms
  --no-fifo  ordinary priority for every process
  --report F  writes the figures as JSON, also those up to Ctrl-C; the run is judged then, as with --for
  --prefix --url --allow)"};
}

std::vector<std::string> face_options(const Arguments& arguments) {
  std::vector<std::string> words{"--interface", arguments.text("--interface", "lo")};
  const auto add = [&](const std::string& name, double usual, double least, double most) {
    const std::string own = "--face-" + name;
    if (arguments.has(own)) words.insert(words.end(), {"--" + name, std::to_string(arguments.number(own, usual, least, most))});
  };
  add("rate", 500.0, 10.0, 500.0);
  add("patience", 0.1, 0.0, 1.0);
  return words;
}

bool records(const Arguments& arguments) {
  const char* record = std::getenv("TWINBUS_RECORD");
  return !arguments.has("--no-record") && (record == nullptr || std::string(record) != "0");
}

bool waits_for_late_commands(const Arguments& arguments, const Stack& stack) {
  return !arguments.has("--lockstep") && !arguments.has("--strict") && !moves_hardware(stack) && !may_enter_real_time();
}

std::vector<std::string> pace_words(const Arguments& arguments, bool patient) {
  std::vector<std::string> words;
  if (arguments.has("--lockstep")) words.emplace_back("--lockstep");
  if (patient) words.emplace_back("--patient");
  if (arguments.has("--rate")) words.insert(words.end(), {"--rate", arguments.text("--rate", "1")});
  // In lock-step the simulator itself ends after its last tick, so that two runs have the same ticks.
  if (arguments.has("--lockstep") && arguments.has("--for"))
    words.insert(words.end(), {"--for", arguments.text("--for", "")});
  return words;
}

Placeholders placeholders_of(const Arguments& arguments, const RunRequest& request, const std::string& folder) {
  Placeholders values;
  auto& bus = values["bus"];
  for (const char* option : {"--url", "--prefix"}) {
    for (const std::string& value : arguments.all(option)) bus.insert(bus.end(), {option, value});
  }
  std::string allowed;
  for (const std::string& address : arguments.all("--allow"))
    allowed += (allowed.empty() ? "" : ",") + address;
  if (!allowed.empty()) bus.insert(bus.end(), {"--allow", allowed});
  values["robot"] = {"--robot", request.robot};
  values["scene"] = {arguments.word(0, "stand")};
  values["start"] = arguments.has("--start-pose")
                        ? std::vector<std::string>{"--start-pose", arguments.text("--start-pose", "")}
                        : std::vector<std::string>{};
  values["pace"] = pace_words(arguments, request.patient);
  values["engine"] = {"--engine", request.engine};
  auto& settings = values["settings"];
  for (const std::string& setting : arguments.all("--set"))
    settings.insert(settings.end(), {"--set", setting});
  if (arguments.has("--seed"))
    settings.insert(settings.end(), {"--seed", arguments.text("--seed", "1")});
  values["folder"] = {folder};
  values["record"] = recorder_words(arguments);
  values["listen"] = arguments.has("--listen")
                         ? std::vector<std::string>{"--listen", arguments.text("--listen", "")}
                         : std::vector<std::string>{};
  values["log"] = {arguments.text("--log", "")};
  values["device"] = {"twinbus_" + arguments.text("--prefix", "") + std::to_string(getpid())};
  return values;
}

void refuse_without_log(const Arguments& arguments, const Stack& stack) {
  if (arguments.has("--log") || !stack.wants("{log}")) return;
  throw UsageError("up: --stack " + stack.name +
                   " plays a log: say which with --log FILE, as in --log runs/DATE-TIME/run.log");
}

std::vector<std::string> recorder_words(const Arguments& arguments) {
  std::vector<std::string> words;
  for (const char* option : {"--split", "--quota"}) {
    if (arguments.has(option)) words.insert(words.end(), {option, arguments.text(option, "")});
  }
  return words;
}

}  // namespace twinbus::launcher
