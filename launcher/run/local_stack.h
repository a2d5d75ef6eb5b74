// A whole stack in one process and without a bus: simulator behind its source and gate, control loop with
// the guard in it, planner, script of the scene.
//
// Every message passes encode and decode and every event has its tick, so the states are bit for bit those
// of lock-step over LCM.  Time is simulated time alone: a run is as fast as the machine, and repeatable.

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bridge/source/scene_script.h"
#include "bridge/source/source.h"
#include "control/loop/control_loop.h"
#include "launcher/bus/stack_monitor.h"
#include "launcher/run/state_hash.h"
#include "launcher/figures/energy_watch.h"
#include "launcher/figures/goal_watch.h"
#include "launcher/figures/loose_watch.h"
#include "launcher/figures/swing_watch.h"
#include "launcher/figures/touch_watch.h"
#include "launcher/figures/walk_figures.h"
#include "planner/arm_planner.h"
#include "robot/estimation/estimator.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/journal.h"
#include "robot/description/model.h"
#include "robot/collision/obstacle_collector.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"

namespace twinbus::inline launcher {

// Hears every message as a recorder on a bus would: channel, encoded bytes, simulated time [ns].
using BusListener = std::function<void(const char* channel, std::span<const std::uint8_t> bytes,
                                       std::int64_t now_ns)>;

struct OneProcessConfig {
  std::vector<std::pair<std::string, std::string>> settings;  // as --set; they win over the scene's
  std::uint64_t seed = 1;
  ControlConfig control;
  bool controller = true;  // false: whoever calls act() gives the command, own_command()
  BusListener listener;    // may be empty
};

class OneProcess {
 public:
  // Opens everything and activates the source.  The model must outlive this.  Throws std::runtime_error.
  OneProcess(const Model& model, const Scene& scene, const OneProcessConfig& config);

  // STATE, COMMAND, physics: one period.  False when the simulation gave up; failure() says why.
  bool tick() { return observe() && act(); }
  const std::string& failure() const { return failure_; }
  // Runs of one robot, up to four, whose physics goes in the lanes of one vector from now on (SimAdaptor): after a tick of each,
  // advance_together().  Throws std::runtime_error with what forbids it.
  static void share_lanes(const std::vector<OneProcess*>& runs) { SimAdaptor::share_lanes(sims_of(runs)); }
  static void advance_together(const std::vector<OneProcess*>& runs) { SimAdaptor::advance_together(sims_of(runs)); }
  // The two halves of a tick: the next STATE, then what answers it and the physics that follows.
  bool observe();
  bool act();
  // Without our controller: what the next act() commands; tick, run, term, model and sender are filled in.  A command that is
  // not finite is not obeyed.
  JointCommand& own_command() { return own_command_; }

  // Said on the bus before the next tick: a ModeRequest, WalkCommand, StopRequest or ArmGoal, which the planner answers at once
  // (arm_answer()).
  template <class T>
  void say(T request);
  void say_held(const ObstaclesPiece& piece);  // on HELD, at once
  // A force on a link for a while from now on; force: world [N], point: in the frame of the link [m].
  Status push(int link, const Eigen::Vector3d& force, const Eigen::Vector3d& point, double seconds) {
    return sim_.push(link, force, point, seconds);
  }
  // What went out on ARM_PATH for the last goal.
  const std::vector<ArmPathPiece>& arm_answer() const { return arm_answer_; }

  // The controller stands still, as a process that is stopped does: it hears what it missed once it goes on.  seconds < 0:
  // it has died.
  void stall_controller(double seconds);
  // Another controller begins.
  void restart_controller(std::int64_t controller_id);

  std::int64_t ticks() const { return ticks_; }
  const RobotState& state() const { return heard_; }  // as decoded
  const SimTruth& truth() const { return *sim_.truth(); }
  const World& world() const { return *sim_.world(); }
  const WorldConfig& world_config() const { return sim_.world_config(); }
  const TrustCounts& trust() const { return sim_.watch().counts(); }
  TrustBands bands() const { return sim_.watch().bands(); }
  void time_physics() { sim_.time_steps(); }  // from now on
  double physics_seconds() const { return sim_.watch().seconds(); }  // CPU [s]
  const std::string& loose_name(int body) const {
    return loose_names_[static_cast<std::size_t>(body)];
  }
  const Eigen::Vector3d& origin() const { return origin_; }  // of the scene, world [m]
  int find_loose(const std::string& name) const;  // -1: there is none
  struct FurtherRobot {
    std::string name;
    Eigen::Vector3d start;  // of its base, world [m]
  };
  const std::vector<FurtherRobot>& further_robots() const { return further_robots_; }
  const ControlLoop& loop() const { return *loop_; }
  const Source& source() const { return source_; }
  const StackMonitor& seen() const { return seen_; }
  const WalkFigures& walked() const { return walked_; }
  const SwingWatch& swing() const { return swing_; }
  const EnergyWatch& energy() const { return energy_; }
  const LooseWatch& loose() const { return loose_; }
  const TouchWatch& touch() const { return touch_; }
  const GoalWatch& goals() const { return goals_; }
  const Model& model() const { return model_; }
  // Why the source was stopped, in words; empty when it was not, or nobody said.
  const std::string& stop_cause() const { return stop_cause_; }
  // The first two that touched and how deep they came, as the end of a sentence; empty when nothing touched.
  std::string first_touch() const;
  double sole_tilt_max() const { return sole_tilt_max_; }  // [rad]
  std::string state_hash() const { return hash_.text(); }
  // What controller and planner had to say since the last call.
  std::vector<std::string> take_sentences() { return std::exchange(sentences_, {}); }

 private:
  static std::vector<SimAdaptor*> sims_of(const std::vector<OneProcess*>& runs);
  template <class T>
  bool over_the_bus(const Channel<T>& channel, const T& sent, T& received, StateHash* hash = nullptr,
                    std::int64_t* content = nullptr);
  struct SendPage {
    OneProcess* o;
    void operator()(const JournalPage& page) const noexcept;
  };
  void activate();
  void tell_obstacles();
  void take_obstacles();
  void tell_held();
  template <class T>
  void show(const Channel<T>& channel, T message);
  template <class T>
  void deliver(const T& received);
  void show_scene();
  void control();
  void obey();
  void answer(const RobotState& state);
  void plan(const ArmGoal& goal);
  void say_script();
  void watch();
  void note_touch(const GuardReport& report);

  const Model& model_;
  SimAdaptor sim_;
  Eigen::Vector3d origin_;
  std::vector<std::string> loose_names_;
  std::vector<FurtherRobot> further_robots_;
  Source source_;
  ControlConfig control_;
  std::unique_ptr<ControlLoop> loop_;
  Estimator planner_view_;
  ObstacleCollector obstacles_;
  std::array<std::int64_t, kMostHands> told_held_{};  // scene_id of each hand
  std::unique_ptr<ArmPlanner> planner_;  // with the first goal
  SceneScript script_;
  StateHash hash_;
  StackMonitor seen_;
  WalkFigures walked_;
  SwingWatch swing_;
  EnergyWatch energy_;
  LooseWatch loose_;
  TouchWatch touch_;
  GoalWatch goals_;
  BusListener listener_;
  std::vector<ObstaclesPiece> shown_obstacles_, shown_terrain_;
  JournalWriter<SendPage> journal_;

  RobotState heard_;
  JointCommand command_, own_command_;
  bool controller_;
  std::int64_t now_ns_ = 0;  // simulated
  std::int64_t silent_until_ = 0;       // the controller stands still before this tick
  std::vector<RobotState> missed_;      // its first ones since
  std::int64_t ticks_ = 0, first_tick_ = 0, stop_asked_tick_ = -1000, planned_goal_ = 0;
  std::int32_t sequence_ = 0;
  std::int64_t state_content_ = 0;
  double sole_tilt_max_ = 0.0;
  bool walked_on_ = false;
  std::vector<std::string> sentences_;
  std::vector<ArmPathPiece> arm_answer_;
  std::string failure_, stop_cause_;
  int touch_a_ = -1, touch_b_ = -1;  // links >= link_count are obstacles
  bool arm_held_ = false;  // by the guard
  double touch_depth_ = 0.0, touch_time_ = 0.0;  // deepest of these two [m]; since the start of the scene [s]
};

}  // namespace twinbus::launcher
