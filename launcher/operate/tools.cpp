// Commands that become another program: spy, policy, env, gamepad, face, replay, record, view, bench, chart, campaign.

#include "launcher/commands/commands.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "common/file/beside_program.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "launcher/stack/face_program.h"
#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

namespace {

namespace fs = std::filesystem;

// Becomes the program; command: how its --help calls it.
[[noreturn]] void become(const std::string& program, const std::vector<std::string>& words,
                         const char* command = nullptr) {
  if (command != nullptr) setenv("TWINBUS_COMMAND", as_typed(command).c_str(), 1);
  setenv("TWINBUS_BUILD", fs::path(program_folder()).parent_path().c_str(), 0);  // for scripts: types, programs
  std::vector<std::string> copy = words;
  std::string name = program;
  std::vector<char*> arguments = {name.data()};
  for (std::string& word : copy) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::fflush(stdout);
  execv(name.c_str(), arguments.data());
  throw std::runtime_error("cannot run " + program + ": " + std::strerror(errno));
}

std::string script(const std::string& name) { return install_folder() + "/launcher/" + name; }

// What can be measured: name -> program in bin, or script in the source tree.
std::map<std::string, std::string> benches() {
  std::map<std::string, std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(program_folder(), ignored)) {
    std::string name = entry.path().filename().string();
    if (name.starts_with("bench_")) {
      found[name.substr(6)] = entry.path().string();
    } else if (name.ends_with("_bench")) {
      found[name.substr(0, name.size() - 6)] = entry.path().string();
    }
  }
  for (const auto& entry : fs::directory_iterator(install_folder() + "/test/bench", ignored)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".py" && name.starts_with("bench_"))
      found[name.substr(6)] = entry.path().string();
  }
  return found;
}

struct BenchRow {
  const char* group;
  const char* name;
  const char* about;
};
constexpr BenchRow kBenches[] = {
    {"control", "control", "a tick of the controller in each mode; does a loop allocate"},
    {"control", "kinematics", "one call of the robot library"},
    {"control", "ik", "inverse kinematics of arms and legs"},
    {"control", "pushes", "the largest push a standing robot survives, by direction"},
    {"walking", "any_robot", "humanoids never met: proposed, they stand and walk"},
    {"walking", "quadruped", "robots on four point feet: proposed, they stand, are pushed, trot and crawl"},
    {"walking", "walk", "stops, pushes, another robot, time of a tick"},
    {"walking", "pad_walk", "a long walk with the pad, page open, beside a build"},
    {"walking", "policy", "policies that others trained: starts, walks, estimate of the base"},
    {"walking", "walkers", "our walker beside policies on one robot: the same courses, pushes and seeds in every engine"},
    {"walking", "walk_map", "pushes survived on the spot, by direction and phase"},
    {"walking", "walk_switch", "sources switched under a robot that walks"},
    {"walking", "walk_trace", "a walk tick by tick"},
    {"walking", "robust", "other masses, trunk, soles, delay, noise"},
    {"walking", "estimate", "velocity of the base as ESTIMATE says it, against TRUTH of a log"},
    {"guard and planner", "guard", "a tick of the guard beside FCL"},
    {"guard and planner", "guard_soft", "arms of soft servos swung into the robot: how many the guard brakes before they touch"},
    {"guard and planner", "guard_drive", "random motions into self-collision"},
    {"guard and planner", "guard_log", "what a guard would have said of a recorded run, and how near the two then came"},
    {"guard and planner", "guard_walk", "what watching all pairs costs while it walks"},
    {"guard and planner", "collision", "the exact check beside FCL, every verdict compared"},
    {"guard and planner", "distance", "distances of hulls and meshes beside FCL"},
    {"guard and planner", "planner", "arm paths beside VAMP and OMPL"},
    {"guard and planner", "reach", "a balancing robot reaches among obstacles"},
    {"simulation", "physics", "engines beside their peers, asked and reached"},
    {"simulation", "published", "the tests of SimBenchmark, beside MuJoCo and what RaiSim reached"},
    {"simulation", "sim2sim", "one controller in every engine: how far they part, and why"},
    {"simulation", "maps", "where each engine fails, how, and whether it said so"},
    {"simulation", "accuracy", "errors asked for and reached, against converged references"},
    {"simulation", "manifold", "contact of two sets of triangles beside FCL"},
    {"simulation", "lanes", "many worlds on one core, four in the lanes of a vector, beside single runs and MuJoCo"},
    {"simulation", "python", "a step from Python beside C++, and many worlds beside MuJoCo's rollout"},
    {"simulation", "tumble", "bodies of many shapes that fall: energy and penetration"},
    {"bus and logs", "bus", "STATE to COMMAND through another process"},
    {"bus and logs", "switch", "live switches of the source"},
    {"bus and logs", "explorer", "how many states of the protocol a second are explored"},
    {"bus and logs", "stalls", "what a process that stands still does to a robot"},
    {"bus and logs", "stop_plan", "what stop plans cost controller and source"},
    {"bus and logs", "record", "what recording costs a stack"},
    {"bus and logs", "log", "how fast the log tools are on a long log"},
    {"bus and logs", "viewer", "what the page gives, and what it costs"}};

// By group, those that are there.
std::string bench_list(const std::vector<std::string>& names) {
  std::string text, group;
  std::vector<std::string> left = names;
  for (const BenchRow& row : kBenches) {
    const auto found = std::find(left.begin(), left.end(), row.name);
    if (found == left.end()) continue;
    left.erase(found);
    if (group != row.group) text += (group = row.group) + "\n";
    text += formatted("  %-14s %s\n", row.name, row.about);
  }
  if (!left.empty()) text += "others\n";
  for (const std::string& name : left) text += "  " + name + "\n";
  return text;
}

// An installation has neither the programs that measure nor what they are built of.
void refuse_if_installed(const std::string& command) {
  if (program_is_installed())
    throw std::runtime_error("an installation leaves out what measures and draws: ask for " + command +
                             " in a checkout of the source tree");
}

}  // namespace

int spy_command(const std::vector<std::string>& words) { become(script("spy.sh"), words, "./twinbus spy"); }

int policy_command(const std::vector<std::string>& words) { become(script("policy.sh"), words, "./twinbus policy"); }

int env_command(const std::vector<std::string>& words) { become(script("env.sh"), words, "./twinbus env"); }

int gamepad_command(const std::vector<std::string>& words) {
  become(program_folder() + "/twinbus_gamepad", words, "./twinbus gamepad");
}

int face_command(const std::vector<std::string>& words) { become(face_program(), words, "./twinbus face"); }

int replay_command(const std::vector<std::string>& words) {
  become(program_folder() + "/twinbus_replay", words, "./twinbus replay");
}

int view_command(const std::vector<std::string>& words) {
  std::vector<std::string> given = words;
  given.push_back("--runs");
  given.push_back(runs_folder());
  become(program_folder() + "/twinbus_log_viewer", given, "./twinbus view");
}

int record_command(const std::vector<std::string>& words) {
  std::vector<std::string> given = words;
  std::replace(given.begin(), given.end(), std::string("-o"), std::string("--output"));
  become(program_folder() + "/twinbus_recorder", given, "./twinbus record");
}

int bench_command(const std::vector<std::string>& words) {
  refuse_if_installed("bench");
  const std::map<std::string, std::string> known = benches();
  std::vector<std::string> names;
  for (const auto& [name, program] : known) names.push_back(name);
  if (words.empty() || words[0] == "--help" || words[0] == "-h") {
    print_typed(
        stdout,
        "usage: ./twinbus bench [NAME] [OPTION...]\n"
        "Measures and prints median, 99th and 99.9th percentile and worst; without NAME lists what "
        "there is.\n"
        "  --csv F               also as rows "
        "bench,case,metric,unit,median,p99,p999,max,peer,peer_median,ratio\n"
        "Other options are the bench's own: ./twinbus bench NAME --help.\n%s",
        bench_list(names).c_str());
    return 0;
  }
  const auto found = known.find(words[0]);
  if (found == known.end())
    throw UsageError("bench: no bench '" + words[0] + "'" + suggestion(words[0], names));
  become(found->second, {words.begin() + 1, words.end()});
}

int campaign_command(const std::vector<std::string>& words) {
  become(install_folder() + "/campaign/campaign.py", words, "./twinbus campaign");
}

int chart_command(const std::vector<std::string>& words) {
  refuse_if_installed("chart");
  std::vector<std::string> names;
  std::string all;
  std::error_code ignored;
  const std::string folder = install_folder() + "/test/bench/";
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".py" || !name.starts_with("chart_")) continue;
    names.push_back(name.substr(6));
    all += " " + names.back();
  }
  if (words.empty() || words[0] == "--help" || words[0] == "-h") {
    print_typed(
        stdout,
        "usage: ./twinbus chart NAME [--out DIR] [OPTION...]\n"
        "Measures and draws.  Other options are the chart's own: ./twinbus chart NAME --help.  "
        "There "
        "are:%s\n",
        all.c_str());
    return 0;
  }
  if (std::find(names.begin(), names.end(), words[0]) == names.end())
    throw UsageError("chart: no chart '" + words[0] + "'" + suggestion(words[0], names));
  become(folder + "chart_" + words[0] + ".py", {words.begin() + 1, words.end()});
}

}  // namespace twinbus::launcher
