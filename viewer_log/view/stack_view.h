// What the viewer knows of the running stack: the newest of everything heard, how old it is and how
// often it comes.
//
// Pure: neither bus nor clock; now_ns is the steady clock.  The world it draws in is the
// estimator's, which goes on across a switch; what a simulator tells in its own world (TRUTH) is
// anchored there once per run.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "robot/collision/near_pairs.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"
#include "viewer_log/view/arm_path_view.h"
#include "viewer_log/view/bus_rates.h"
#include "viewer_log/view/camera_view.h"
#include "viewer_log/view/shape_set.h"

namespace twinbus::inline viewer_log {

template <class T>
struct Heard {
  T value{};
  std::int64_t at_ns = 0;  // when it came, 0 never
  double age(std::int64_t now_ns) const { return at_ns == 0 ? 1e9 : 1e-9 * double(now_ns - at_ns); }
  bool fresh(std::int64_t now_ns, double limit) const { return age(now_ns) < limit; }
};

struct ShownEvent {
  std::int64_t number = 0;  // counts up by one per event shown
  std::int64_t utime = 0;
  ProcessKind kind = ProcessKind::kNone;
  int severity = 0;
  std::string text;
  int count = 1;  // how often within a short while
};

class StackView {
 public:
  explicit StackView(const Model& model);

  void on_state(const RobotState& state, std::int64_t now_ns);  // on STATE
  void on_standby_state(const RobotState& state,
                        std::int64_t now_ns);  // on STATE_SIM, _BRIDGE, _REPLAY
  void on_command(const JointCommand& command, std::int64_t now_ns);
  void on_controller_status(const ControllerStatus& status, std::int64_t now_ns);
  void on_truth(const SimTruth& truth, std::int64_t now_ns);
  void on_guard(const GuardReport& report, std::int64_t now_ns);
  void on_source_status(const SourceStatus& status, std::int64_t now_ns);
  void on_heartbeat(const Heartbeat& heartbeat, std::int64_t now_ns);
  void on_event(const Event& event);
  void on_obstacles(const ObstaclesPiece& piece) { things_changes_ += things_.add(piece) ? 1 : 0; }
  void on_held(const ObstaclesPiece& piece) { things_changes_ += things_.hold(piece) ? 1 : 0; }
  // Of the active run only, as TRUTH.
  void on_terrain(const ObstaclesPiece& piece);
  void on_loose(const ObstaclesPiece& piece, std::int64_t now_ns);
  void on_footsteps(const ObstaclesPiece& piece, std::int64_t now_ns);
  void on_arm_path(const ArmPathPiece& piece) { arm_path_.on_piece(piece); }
  void on_camera(const ModelTextPiece& piece, std::int64_t now_ns) {
    camera_.on_piece(piece, now_ns);
  }
  // Messages admitted so far on STATE, COMMAND and GUARD.
  void on_totals(std::int64_t states, std::int64_t commands, std::int64_t guards,
                 std::int64_t now_ns, Receiver receiver = Receiver::kExact);

  // The robot behind the bridge is a stand-in, which begins anew with its stack.
  void say_stand_in(bool stand_in) { stand_in_ = stand_in; }
  bool stand_in() const { return stand_in_; }

  const Model& model() const { return *model_; }
  const Heard<RobotState>& state() const { return state_; }
  // How long STATE has been heard without a pause: what was not heard in a shorter time may not be silent. [s]
  double listened(std::int64_t now_ns) const { return state_.at_ns == 0 ? 0.0 : 1e-9 * double(now_ns - state_since_ns_); }
  const Heard<RobotState>& standby() const { return standby_; }
  const Heard<JointCommand>& command() const { return command_; }
  const ArmPathView& arm_path() const { return arm_path_; }
  const CameraView& camera() const { return camera_; }
  // COMMAND is for the run that is shown, and fresh; a standby source is heard beside STATE.
  bool command_applies(std::int64_t now_ns) const;
  bool standby_applies(std::int64_t now_ns) const;
  const Heard<ControllerStatus>& controller() const { return controller_; }
  const Heard<GuardReport>& guard() const { return guard_; }
  const Heard<SimTruth>& truth() const { return truth_; }
  // TRUTH is of the run that is active now, and fresh.
  bool truth_applies(std::int64_t now_ns) const;
  // The state to draw: STATE, or the newest of a standby when STATE is silent; never null.
  const RobotState& shown(std::int64_t now_ns) const;
  const Estimator& estimator() const { return estimator_; }
  // Base link in the drawn world: from TRUTH where it applies, so that a fall looks like one, else
  // estimated.
  Eigen::Isometry3d base(std::int64_t now_ns) const;
  // From the estimator's world to the one that is drawn: not the identity where TRUTH is drawn.
  Eigen::Isometry3d drawn_from_estimated(std::int64_t now_ns) const;
  const Eigen::Isometry3d& world_from_sim() const { return world_from_sim_; }

  const std::vector<Heard<SourceStatus>>& sources() const { return sources_; }
  const std::vector<Heard<Heartbeat>>& processes() const { return processes_; }
  const std::deque<ShownEvent>& events() const { return events_; }
  // What the guard keeps of two links, as a share of what it keeps of others.
  double margin_share(int link_a, int link_b) const { return link_a < 0 || link_b < 0 ? 1.0 : margins_.of(link_a, link_b); }
  // As guard and planner number them, with what hands hold.
  const std::vector<Obstacle>& things() const { return things_.obstacles(); }
  const std::vector<ObstaclesPiece>& terrain() const { return terrain_.pieces(); }
  const std::vector<ObstaclesPiece>& loose() const { return loose_.pieces(); }
  // Loose bodies are those of the active run, and fresh.
  bool loose_applies(std::int64_t now_ns) const;
  const Heard<ObstaclesPiece>& footsteps() const { return footsteps_; }
  bool footsteps_apply(std::int64_t now_ns) const;
  // Changes with what stands around and is held: obstacles, terrain and where it is drawn, which loose bodies there are.
  std::int64_t scene_version() const {
    return things_changes_ + terrain_.version() + loose_.version() + anchors_;
  }
  const BusRates& rates() const { return rates_; }

  // Forgets processes and sources silent for 10 s.  Call now and then.
  void forget_silent(std::int64_t now_ns);

 private:
  void anchor_truth();

  const Model* model_;
  bool stand_in_ = false;
  Estimator estimator_;
  Heard<RobotState> state_, standby_;
  std::int64_t state_since_ns_ = 0;
  Heard<JointCommand> command_;
  Heard<ControllerStatus> controller_;
  ArmPathView arm_path_;
  CameraView camera_;
  Heard<SimTruth> truth_;
  Heard<GuardReport> guard_;
  std::vector<Heard<SourceStatus>> sources_;
  std::vector<Heard<Heartbeat>> processes_;
  std::deque<ShownEvent> events_;
  std::vector<std::pair<std::int64_t, std::int32_t>> event_sequences_;  // newest per sender
  std::int64_t events_seen_ = 0;
  ShapeSet terrain_{ShapeSet::Matters::kAll};
  MarginShares margins_;
  ObstacleCollector things_;
  std::int64_t things_changes_ = 0;
  ShapeSet loose_{ShapeSet::Matters::kShapes};
  std::int64_t loose_ns_ = 0, anchors_ = 0;
  Heard<ObstaclesPiece> footsteps_;
  BusRates rates_;
  std::int64_t anchored_run_ = 0;
  Eigen::Isometry3d world_from_sim_ = Eigen::Isometry3d::Identity();
};

}  // namespace twinbus::viewer_log
