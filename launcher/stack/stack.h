// A stack: which processes make a running robot, in which order they start, and what says that each is ready.
//
// Read from config/stacks/NAME.yaml.  Arguments may hold placeholders, {scene} and the like, which the launcher fills
// in from its own command line; a placeholder that stands alone may become any number of arguments.

#pragma once

#include <map>
#include <string>
#include <vector>

namespace twinbus::inline launcher {

enum class ReadyWhen {
  kMessage,  // first message on a channel, from this very process where the message tells
  kLine,     // first line of its output
};

struct StackProcess {
  std::string name;
  std::string program;                 // file beside the launcher's own program
  std::vector<std::string> arguments;  // with placeholders
  std::vector<std::string> after;      // names of processes that must be ready first
  ReadyWhen ready_when = ReadyWhen::kMessage;
  std::string ready_channel;    // without prefix
  double ready_timeout = 20.0;  // [s]
  bool required = true;         // its death ends the run with exit status 1
  bool restart = false;         // started again when it dies
  bool hardware = false;        // moves real motors: outlives a launcher that is killed
  bool viewer = false;          // left out by --no-viewer
  bool recorder = false;        // left out by --no-record
  double grace = 2.0;           // SIGTERM to SIGKILL [s]
};

struct Stack {
  std::string name;
  std::string about;     // one sentence
  std::string activate;  // the process whose source is asked to be active first
  std::string shadow;    // one that then follows it with the same commands; may be empty
  std::string text;      // as read
  std::vector<StackProcess> processes;  // sorted: each after those it waits for

  const StackProcess* find(const std::string& name) const;
  // Is this placeholder among the arguments of any process?
  bool wants(const std::string& placeholder) const;
  // Those of which unwanted says true, also from the lists of what others wait for.
  void leave_out(bool (*unwanted)(const StackProcess&));
};

// name_or_file: a YAML file, or a name under config/stacks.  Throws std::runtime_error naming file, line and the nearest
// valid key.
Stack load_stack(const std::string& name_or_file);
Stack parse_stack(const std::string& text, const std::string& file_for_errors);

// Names of the stacks of the installation.
std::vector<std::string> stack_names();

// Whether any process of it has motors behind it, or something that stands in for them.
bool moves_hardware(const Stack& stack);

// Whether it is the stand-in robot, or the bridge to one: nothing of it is more than simulated.
bool is_stand_in(const StackProcess& process);

// The arguments with placeholders filled in.  Throws std::runtime_error naming an unknown one.
using Placeholders = std::map<std::string, std::vector<std::string>>;
std::vector<std::string> fill_in(const StackProcess& process, const Placeholders& values);

}  // namespace twinbus::launcher
