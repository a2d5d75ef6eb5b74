// A process that hears the STATE of one robot: what controller, guard and planner have in common.  For mains only.

#pragma once

#include <cstdint>
#include <cstdio>

#include "common/process/priority.h"
#include "lcmtypes/bus/node.h"
#include "lcmtypes/msg/state_admission.h"
#include "robot/collision/loop_joints.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/description/load.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::inline control {

class RobotProcess {
 protected:
  RobotProcess(const CommonOptions& common, ProcessKind kind, const Model& model, RealTime real_time = RealTime::kNone)
      : model_(model), node_(common, kind, real_time) {}

  // Counted when it is of another robot.
  bool is_ours(const RobotState& state) noexcept {
    const bool ours = state.joint_count == model_.bus_count() && state.model_hash == model_.hash;
    rejected_ += ours ? 0 : 1;
    return ours;
  }
  void take(const RobotState& state, std::int64_t now_ns) noexcept {
    state_ = state;
    heard_ns_ = now_ns;
    fresh_ = true;
  }

  // What each of them hears by hear_state, hear_obstacles and hear_held of its own.
  template <class Process>
  void listen_to_robot(Process& process) {
    Bus& bus = node_.bus();
    bus.listen<&Process::hear_state>(channel::kState, process);
    bus.listen<&Process::hear_obstacles>(channel::kObstacles, process);
    bus.listen<&Process::hear_held>(channel::kHeld, process);
  }

  // Once per scene: not part of the loop.
  template <class Journal, class Taker>
  void hand_on_obstacles(Journal& journal, Taker& taker) {
    if (!new_obstacles_) return;
    new_obstacles_ = false;
    journal.consumed(JournalInput::kTakeObstacles, {}, monotonic_ns());
    taker.set_obstacles(obstacles_.obstacles());
  }

  // The heartbeat of now; what only one of them counts is still to be filled in.
  Heartbeat& beat() noexcept {
    Heartbeat& beat = node_.beat();
    beat.messages_rejected += rejected_ + admission_.ignored();
    beat.allocations = allocations_counted() ? allocations_ : -1;
    return beat;
  }

  const Model& model_;
  Node node_;
  Pulse& pulse_ = node_.pulse();
  StateAdmission admission_;
  ObstacleCollector obstacles_;
  RobotState state_;
  bool fresh_ = false, new_obstacles_ = false;  // not yet looked at
  std::int64_t heard_ns_ = 0;                   // the state
  std::int64_t rejected_ = 0, allocations_ = 0;
};

// The process called so, from its options to its end; about(): what it says of itself once it is ready.
template <class Process, class Arguments>
int run_ready(const char* name, const Arguments& arguments, int priority) {
  catch_quit_signals();
  const Model model = load_robot(arguments.common.robot);
  const RealTime real_time = enter_real_time(priority, name);
  Process process(arguments, model, real_time);
  print_loops(model, name);
  std::printf("%s ready: %s, %s, %s\n", name, model.name.c_str(), process.about().c_str(), to_text(real_time));
  process.run();
  return 0;
}

}  // namespace twinbus::control
