// The planner process: ARM_GOAL in, a timed collision-free motion out on ARM_PATH.
//
// It listens to STATE all the time, to know where the robot is and so that no queue runs full;
// planning is done by a worker.  Pieces of a path are sent a few times, because any datagram may be
// lost.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/obeyed_once.h"
#include "lcmtypes/msg/state_admission.h"
#include "lcmtypes/node/pulse.h"
#include "planner/arm_path_pieces.h"
#include "planner/plan_start.h"
#include "planner/plan_worker.h"
#include "robot/collision/loop_joints.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/description/load.h"
#include "robot/estimation/estimator.h"
#include "test/no_alloc.h"

namespace twinbus {
namespace {

constexpr double kWait = 0.01;         // [s] for a message
constexpr std::int64_t kWarmUp = 100;  // ticks; LCM makes a list per channel with its first message
constexpr std::int64_t kFreshNs = 200'000'000;  // a plan needs a state not older than this
constexpr std::int64_t kResendNs = 40'000'000;
constexpr int kSends = 4;  // of every path

class PlannerProcess {
 public:
  PlannerProcess(const CommonOptions& common, const Model& model)
      : model_(model),
        id_(common.id != 0 ? common.id : random_id()),
        bus_({.url = common.url, .prefix = common.prefix, .allow = {common.allow}}),
        estimator_(model),
        pulse_(ProcessKind::kPlanner, id_),
        worker_(model) {
    bus_.listen_each<RobotState>(channel::kState, on_state_);
    bus_.listen_each<JointCommand>(channel::kCommand, on_command_);
    bus_.listen_each<ControllerStatus>(channel::kControllerStatus, on_controller_);
    bus_.listen_each<ArmGoal>(channel::kArmGoal, on_goal_);
    bus_.listen_each<ObstaclesPiece>(channel::kObstacles, on_obstacles_);
  }

  void run() {
    while (!quit_requested()) {
      NoAlloc no_alloc;
      if (bus_.receive(kWait) < 0) throw std::runtime_error("the bus is gone");
      if (fresh_) {
        fresh_ = false;
        const std::int64_t begin = monotonic_ns();
        estimator_.update(state_);
        const std::int64_t end = monotonic_ns();
        pulse_.tick(end, end - begin);
      }
      if (pulse_.due(monotonic_ns())) send_heartbeat();
      if (pulse_.ticks() > kWarmUp) allocations_ += no_alloc.count();
      // A goal, an answer and a resend are events, not part of the loop.
      if (new_goal_) start_plan();
      if (auto answer = worker_.answer()) finish_plan(*answer);
      if (sends_left_ > 0 && monotonic_ns() - sent_ns_ >= kResendNs) send_pieces();
    }
  }

 private:
  void hear_state(const RobotState& state) noexcept {
    if (state.joint_count != model_.bus_count() || state.model_hash != model_.hash) {
      ++rejected_;
      return;
    }
    const std::int64_t now = monotonic_ns();
    if (!admission_.admit(state, now)) return;
    state_ = state;
    heard_ns_ = now;
    fresh_ = true;
  }

  void hear_command(const JointCommand& command) noexcept {
    if (command.run_id == admission_.run_id() && command.term == admission_.term() &&
        command.joint_count == model_.bus_count()) {
      command_ = command;
    }
  }

  void hear_goal(const ArmGoal& goal) noexcept {
    if (goal.run_id != admission_.run_id() || heard_ns_ == 0) {
      ++rejected_;  // of another run, or an old log
      return;
    }
    // Said again, or from a log of this run.  A goal and the end of it may have one number.
    SpentNumbers<256>& spent = goal.kind == ArmGoalKind::kCancel ? cancelled_ : planned_;
    if (spent.contains(goal.goal_id)) return;
    spent.spend(goal.goal_id);
    goal_ = goal;
    new_goal_ = true;
  }

  void start_plan() {
    new_goal_ = false;
    sends_left_ = 0;
    if (goal_.kind == ArmGoalKind::kCancel) {
      worker_.cancel();
      return;
    }
    if (monotonic_ns() - heard_ns_ > kFreshNs) {
      tell("the goal came while no robot was heard: ask again", 1);
      return;
    }
    PlanQuestion question;
    question.goal = goal_;
    question.start = plan_start(model_, estimator_.configuration(), state_, command_);
    question.ground_in_world = estimator_.ground_in_world();
    question.obstacles = obstacles_.obstacles();
    question.seed = static_cast<std::uint64_t>(goal_.goal_id);
    question.balancing = mode_ == Mode::kBalance;
    worker_.ask(std::move(question));
  }

  void finish_plan(const PlanAnswer& answer) {
    if (answer.goal.goal_id != goal_.goal_id || answer.plan.status == ArmPathStatus::kCancelled)
      return;
    pieces_ = to_pieces(answer.plan, {id_, answer.goal.run_id, answer.goal.goal_id, random_id()});
    sends_left_ = kSends;
    send_pieces();
    char sentence[200];
    const char* side = answer.goal.side == ArmSide::kRight ? "right hand" : "left hand";
    std::snprintf(sentence, sizeof sentence, "%s: %s (planned in %.0f ms)",
                  answer.goal.kind == ArmGoalKind::kJoints ? "arm joints" : side,
                  describe(model_, answer.plan).c_str(), 1e3 * answer.seconds);
    tell(sentence, answer.plan.status == ArmPathStatus::kOk ? 0 : 1);
  }

  void send_pieces() {
    sent_ns_ = monotonic_ns();
    --sends_left_;
    for (ArmPathPiece& piece : pieces_) {
      piece.utime = wall_us();
      if (!bus_.send(channel::kArmPath, piece)) ++send_failures_;
    }
  }

  void tell(const char* sentence, int severity) {
    Event event;
    event.utime = wall_us();
    event.sender_id = id_;
    event.run_id = state_.run_id;
    event.tick = state_.tick;
    event.sequence = ++event_sequence_;
    event.severity = static_cast<std::int8_t>(severity);
    event.kind = ProcessKind::kPlanner;
    std::snprintf(event.text.data(), event.text.size(), "%s", sentence);
    if (!bus_.send(channel::kEvent, event)) ++send_failures_;
  }

  void send_heartbeat() {
    Heartbeat& beat = pulse_.beat(monotonic_ns());
    const BusCounters& c = bus_.counters();
    beat.messages_received = c.received;
    beat.messages_rejected = c.rejected + rejected_ + admission_.ignored();
    beat.messages_lost = c.lost;
    beat.allocations = allocations_counted() ? allocations_ : -1;
    beat.send_failures =
        static_cast<std::int32_t>(std::min<std::int64_t>(send_failures_, INT32_MAX));
    if (!bus_.send_heartbeat(beat)) ++send_failures_;
  }

  struct OnState {
    PlannerProcess* p;
    void operator()(const RobotState& m) const noexcept { p->hear_state(m); }
  };
  struct OnCommand {
    PlannerProcess* p;
    void operator()(const JointCommand& m) const noexcept { p->hear_command(m); }
  };
  struct OnController {
    PlannerProcess* p;
    void operator()(const ControllerStatus& m) const noexcept { p->mode_ = m.mode; }
  };
  struct OnGoal {
    PlannerProcess* p;
    void operator()(const ArmGoal& m) const noexcept { p->hear_goal(m); }
  };
  struct OnObstacles {
    PlannerProcess* p;
    void operator()(const ObstaclesPiece& m) const noexcept { p->obstacles_.add(m); }
  };

  const Model& model_;
  std::int64_t id_;
  Bus bus_;
  Estimator estimator_;
  StateAdmission admission_;
  ObstacleCollector obstacles_;
  RobotState state_;
  JointCommand command_;
  Mode mode_ = Mode::kNone;  // of the controller
  ArmGoal goal_;
  SpentNumbers<256> planned_, cancelled_;  // goals that were obeyed
  bool fresh_ = false, new_goal_ = false;
  std::vector<ArmPathPiece> pieces_;
  int sends_left_ = 0;
  Pulse pulse_;
  std::int64_t heard_ns_ = 0, sent_ns_ = 0;
  std::int64_t rejected_ = 0, allocations_ = 0, send_failures_ = 0;
  std::int32_t event_sequence_ = 0;

  OnState on_state_{this};
  OnCommand on_command_{this};
  OnController on_controller_{this};
  OnGoal on_goal_{this};
  OnObstacles on_obstacles_{this};
  PlanWorker worker_;  // last: its thread ends before anything else does
};

int run(int argc, char** argv) {
  CommonOptions common;
  Options options("twinbus_planner",
                  "Answers ARM_GOAL with a collision-free arm motion on ARM_PATH.");
  add_common(options, common);
  options.parse(argc, argv);
  catch_quit_signals();
  give_way();
  const Model model = load_robot(common.robot);
  PlannerProcess planner(common, model);
  const std::string loops = loops_sentence(model);
  if (!loops.empty()) std::fprintf(stderr, "planner: %s\n", loops.c_str());
  std::printf("planner ready: %s\n", model.name.c_str());
  std::fflush(stdout);
  planner.run();
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("planner", twinbus::run, argc, argv);
}
