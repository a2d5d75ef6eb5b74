// A scene in one process for Python: the nodes of `./twinbus run`, stepped from outside, with everything that is looked at in
// memory that stays where it is.

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "launcher/run/local_stack.h"
#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus {

struct SimulationConfig {
  std::string scene = "stand";  // a name in config/scenes or a file
  std::string robot;            // a name in config/robots or a folder; empty: the scene's
  std::string engine;           // articulated, ode or mujoco; empty: the scene's
  std::string start_pose;       // empty: the scene's
  std::uint64_t seed = 1;       // of everything random
  bool controller = true;       // ours; false: command() is obeyed
  bool guard = true;            // in our controller
  bool fade = false;            // the first command() is faded in, as on a bus
  std::vector<std::pair<std::string, std::string>> settings;  // as --set of `run`
};

// A scene that is fitted to its robot, and that robot.
struct SceneAndRobot {
  std::unique_ptr<Model> model;  // stays where it is
  Scene scene;                   // before the seed
};

// Throws std::runtime_error with the sentence that `run` would print, UsageError's included.
SceneAndRobot load(const SimulationConfig& config);

class Simulation {
 public:
  // Throws as load() and OneProcess do.
  explicit Simulation(const SimulationConfig& config);

  // Begins anew: the first state is there, nothing has moved.
  void reset(std::uint64_t seed);
  // Answers the present state, lets `ticks` periods pass and measures; with command() in force for all of them when there is no
  // controller.  Throws std::invalid_argument naming a joint whose command is not finite or whose gain is negative;
  // std::runtime_error when the simulation gave up.
  void step(int ticks);

  const Model& model() const { return *loaded_.model; }
  const Scene& scene() const { return loaded_.scene; }
  RobotState& state() { return state_; }        // measured now
  SimTruth& truth() { return truth_; }          // what only a simulator knows, now
  JointCommand& command() { return command_; }  // for the next step
  double time() const { return 1e-9 * static_cast<double>(state_.period_ns) * static_cast<double>(steps_); }  // [s] since reset
  std::uint64_t seed() const { return seed_; }
  OneProcess& process() { return *process_; }
  // As `./twinbus run` prints: equal hashes, equal states to the last bit.
  std::string state_hash() const { return process_->state_hash(); }

 private:
  void observe();
  void check_command() const;

  SimulationConfig config_;
  SceneAndRobot loaded_;
  std::unique_ptr<OneProcess> process_;
  RobotState state_;
  SimTruth truth_;
  JointCommand command_;
  std::uint64_t seed_ = 1;
  std::int64_t steps_ = 0;
};

// Holds the posture that was measured with the robot's own gains: where a command begins.
void hold_posture(const Model& model, const RobotState& state, JointCommand& command);
// Throws std::invalid_argument that names the joint.
void check_command(const Model& model, const JointCommand& command);

}  // namespace twinbus
