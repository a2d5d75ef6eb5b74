// What the simulator's and the bridge's main() share: a bus, a Source around the adaptor, and the
// pace.
//
// A main parses its own arguments, opens its adaptor and calls run_source_main(), which returns
// when the process was asked to end.  Nothing in its loop allocates.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bridge/adaptor/adaptor.h"
#include "bridge/source/scene_script.h"
#include "bridge/source/source.h"
#include "robot/description/model.h"
#include "common/process/options.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline bridge {

struct SourceMainOptions {
  std::string program = "source";  // in front of every line it prints
  SourceKind kind = SourceKind::kSimulator;
  ProcessKind process = ProcessKind::kSimulator;
  CommonOptions common;  // url, prefix, id
  bool lockstep = false;
  bool patient = false;         // the clock of the simulated world stands still while a command is late
  bool guard_required = false;  // its silence masks the arms
  double rate = 1.0;            // real time: this many times faster (simulators)
  double duration = 0.0;        // [s] of active time, then it ends; 0: until a signal
  std::int64_t seed = 1;
  int priority = 60;  // FIFO

  std::string scene_text;                 // MODEL_TEXT kind 4
  std::vector<ObstaclesPiece> obstacles;  // OBSTACLES, at 1 Hz
  std::vector<ObstaclesPiece> terrain;    // TERRAIN, at 1 Hz; may be empty
  // Published with the run_id of this source while it is active.
  SceneRequests requests;
};

inline SourceMainOptions source_main_options(const char* program, SourceKind kind, ProcessKind process) {
  SourceMainOptions options;
  options.program = program;
  options.kind = kind;
  options.process = process;
  return options;
}

// --guard-required and --for; a simulator's also --lockstep, --patient, --rate and --seed.
void add_source_options(Options& parser, SourceMainOptions& options, bool simulator);

// The adaptor is open; closed by the caller.  Returns the exit code: 0 asked to end, 1 the adaptor
// failed for good. Throws std::runtime_error if the bus cannot be opened.
int run_source_main(const SourceMainOptions& options, const Model& model, RobotAdaptor& adaptor);

}  // namespace twinbus::bridge
