// The program `twinbus`: finds the command that was asked for and hands it the rest of the line.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "common/file/beside_program.h"
#include "common/file/disk_cache.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/text/closest_name.h"
#include "common/text/printable.h"
#include "launcher/commands/commands.h"
#include "launcher/stack/run_folder.h"

using namespace twinbus;

namespace {

constexpr Command kCommands[] = {
    {"up", "start and supervise simulator, controller, guard, planner and viewer", &up_command},
    {"run", "run a scene in one process, without a bus, as fast as it goes", &run_command},
    {"tune", "find the cheapest order and step of a scene that hold an error", &tune_command},
    {"explain", "what of a scene is modelled, at what cost and error", &explain_command},
    {"campaign", "thousands of seeded runs, the smallest failure, a release gate", &campaign_command},
    {"scenes", "which scenes there are", &scenes_command},
    {"restart", "start one process of the stack anew", &restart_command},
    {"status", "who is there, rates, roles, terms, timing", &status_command},
    {"switch", "let simulator, hardware bridge or replay take over", &switch_command},
    {"stop", "stop the robot: balanced, hold or off", &stop_command},
    {"clear", "end a stop", &clear_command},
    {"mode", "ask the controller for a mode", &mode_command},
    {"pose", "go to a named pose", &pose_command},
    {"sway", "sway from side to side", &sway_command},
    {"squat", "move up and down", &squat_command},
    {"walk", "walk at a velocity, or footsteps of a file", &walk_command},
    {"motion", "check a recorded motion before it plays, and play it", &motion_file_command},
    {"reach", "bring a hand to a point around obstacles", &reach_command},
    {"grip", "open and close the fingers of a hand", &grip_command},
    {"attach", "tell planner and guard what a hand holds", &attach_command},
    {"release", "tell them that a hand is empty", &release_command},
    {"gamepad", "drive with a gamepad or the keyboard", &gamepad_command},
    {"policy", "run a learned policy (ONNX) as the controller, check it, map it", &policy_command},
    {"face", "answer as a Unitree robot on DDS, for programs written for it", &face_command},
    {"push", "push the simulated robot", &push_command},
    {"sim", "pause, single steps, slow motion, reset: a robot that has fallen stands again", &sim_command},
    {"replay", "play a log as a source of STATE", &replay_command},
    {"view", "look at a log in the browser, two on one timeline", &view_command},
    {"record", "record the bus into a log", &record_command},
    {"log", "look into logs, cut, convert, compare, re-run them", &log_command},
    {"spy", "lcm-spy that knows the messages", &spy_command},
    {"env", "shell variables for stock LCM tools: eval \"$(./twinbus env)\"", &env_command},
    {"check", "load a robot's folder and print what it is", &check_command},
    {"export", "a scene for MuJoCo (MJCF) or Drake (URDF)", &export_command},
    {"doctor", "is this machine ready", &doctor_command},
    {"bench", "measure", &bench_command},
    {"chart", "draw what was measured: SVG, PNG, CSV", &chart_command},
};

bool is_left_out(const Command& command) { return command.run == &bench_command || command.run == &chart_command; }

void print_help() {
  const bool installed = program_is_installed();
  print_typed(stdout, "usage: ./twinbus COMMAND [ARGUMENT...]\n\n");
  for (const Command& command : kCommands) {
    if (!installed || !is_left_out(command)) print_typed(stdout, "  %-9s %s\n", command.name, command.about);
  }
  if (installed) {
    std::printf("\nAn installation leaves out what the source tree builds: bench, chart, test.\n");
  } else {
    std::printf("  %-9s %s\n", "test", "build and run the tests");
    std::printf(
        "\nIn front of COMMAND: --no-install only says which packages are missing; --own-network gives the stack a network of its own,\n"
        "which later commands with it join, and a program of yours: --own-network -- PROGRAM.\n");
  }
  print_typed(
      stdout,
      "\n./twinbus COMMAND --help says more, ./twinbus --version which this is.  Exit status: 0 done, 1 failed, 2 wrong arguments.\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "--help";
  if (name == "--help" || name == "-h" || name == "help") {
    print_help();
    return 0;
  }
  if (name == "--version" || name == "version") {
    std::printf("twinbus %s, commit %s\n", TWINBUS_VERSION, commit_of_program().c_str());
    return 0;
  }
  std::vector<std::string> names = {"test"};
  for (const Command& command : kCommands) {
    names.push_back(command.name);
    if (name != command.name) continue;
    try {
      use_user_cache();
      return command.run({argv + 2, argv + argc});
    } catch (const UsageError& error) {
      print_typed(stderr, "%s\n", printable(error.what(), kLongestError, true).c_str());
      return 2;
    } catch (const std::exception& error) {
      print_typed(stderr, "%s: %s\n", name.c_str(), printable(error.what(), kLongestError, true).c_str());
      return 1;
    }
  }
  std::fprintf(stderr, "twinbus: no command '%s'%s\n", printable(name, 200).c_str(),
               suggestion(name, names).c_str());
  return 2;
}
