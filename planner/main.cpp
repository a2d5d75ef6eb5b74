// The planner process: ARM_GOAL in, a timed collision-free motion out on ARM_PATH.
//
// It listens to STATE all the time, to know where the robot is and so that no queue runs full;
// planning is done by a worker.  Pieces of a path are sent a few times, because any datagram may be
// lost.

#include <cstdio>
#include <vector>

#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "control/robot_process_main.h"
#include "lcmtypes/msg/event_code.h"
#include "lcmtypes/msg/obeyed_once.h"
#include "planner/arm_path_pieces.h"
#include "planner/plan_start.h"
#include "planner/plan_worker.h"
#include "robot/collision/loop_joints.h"
#include "robot/description/load.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline planner {
namespace {

constexpr double kWait = 0.01;         // [s] for a message
constexpr std::int64_t kWarmUp = 100;  // ticks; LCM makes a list per channel with its first message
constexpr std::int64_t kFreshNs = 200'000'000;  // a plan needs a state not older than this
constexpr std::int64_t kResendNs = 40'000'000;
constexpr int kSends = 4;  // of every path

class PlannerProcess : RobotProcess {
 public:
  PlannerProcess(const CommonOptions& common, const Model& model)
      : RobotProcess(common, ProcessKind::kPlanner, model),
        estimator_(model),
        worker_(model) {
    listen_to_robot(*this);
    Bus& bus = node_.bus();
    bus.listen<&PlannerProcess::hear_command>(channel::kCommand, *this);
    bus.listen<&PlannerProcess::hear_controller>(channel::kControllerStatus, *this);
    bus.listen<&PlannerProcess::hear_goal>(channel::kArmGoal, *this);
  }

  void run() {
    while (!quit_requested()) {
      NoAlloc no_alloc;
      node_.receive(kWait);
      if (fresh_) {
        fresh_ = false;
        const std::int64_t begin = monotonic_ns();
        estimator_.update(state_);
        const std::int64_t end = monotonic_ns();
        pulse_.tick(end, end - begin);
      }
      if (pulse_.due(monotonic_ns())) node_.send_heartbeat(beat());
      if (pulse_.ticks() > kWarmUp) allocations_ += no_alloc.count();
      // A goal, an answer and a resend are events, not part of the loop.
      if (new_goal_) start_plan();
      if (auto answer = worker_.answer()) finish_plan(*answer);
      if (sends_left_ > 0 && monotonic_ns() - sent_ns_ >= kResendNs) send_pieces();
    }
  }

 private:
  friend class twinbus::RobotProcess;
  void hear_state(const RobotState& state) noexcept {
    const std::int64_t now = monotonic_ns();
    if (is_ours(state) && admission_.admit(state, now)) take(state, now);
  }

  void hear_command(const JointCommand& command) noexcept {
    if (command.run_id == admission_.run_id() && command.term == admission_.term() &&
        command.joint_count == model_.bus_count()) {
      command_ = command;
    }
  }

  void hear_controller(const ControllerStatus& status) noexcept { mode_ = status.mode; }
  void hear_obstacles(const ObstaclesPiece& piece) noexcept { obstacles_.add(piece); }
  void hear_held(const ObstaclesPiece& piece) noexcept { obstacles_.hold(piece); }

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
    pieces_ = to_pieces(answer.plan, {node_.id(), answer.goal.run_id, answer.goal.goal_id, random_id()});
    sends_left_ = kSends;
    send_pieces();
    char sentence[200];
    const Hand* hand = hand_of(model_, number_of(answer.goal.side));
    const std::string side = answer.goal.side == ArmSide::kRight  ? "right hand"
                             : answer.goal.side == ArmSide::kLeft ? "left hand"
                                                                  : (hand == nullptr ? "arm" : hand->name);
    std::snprintf(sentence, sizeof sentence, "%s: %s (planned in %.0f ms)",
                  answer.goal.kind == ArmGoalKind::kJoints ? "arm joints" : side.c_str(),
                  describe(answer.plan).c_str(), 1e3 * answer.seconds);
    const bool found = answer.plan.status == ArmPathStatus::kOk;
    tell(sentence, found ? 0 : 1, found ? std::int16_t{0} : kArmGoalRefused);
  }

  void send_pieces() {
    sent_ns_ = monotonic_ns();
    --sends_left_;
    for (ArmPathPiece& piece : pieces_) {
      piece.utime = wall_us();
      node_.send(channel::kArmPath, piece);
    }
  }

  void tell(const char* sentence, int severity, std::int16_t code = 0) {
    node_.tell(severity, sentence, state_.run_id, state_.tick, code);
  }

  Estimator estimator_;
  JointCommand command_;
  Mode mode_ = Mode::kNone;  // of the controller
  ArmGoal goal_;
  SpentNumbers<256> planned_, cancelled_;  // goals that were obeyed
  bool new_goal_ = false;
  std::vector<ArmPathPiece> pieces_;
  int sends_left_ = 0;
  std::int64_t sent_ns_ = 0;
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
  print_loops(model, "planner");
  std::printf("planner ready: %s\n", model.name.c_str());
  planner.run();
  return 0;
}

}  // namespace
}  // namespace twinbus::planner

int main(int argc, char** argv) { return twinbus::run_process("planner", twinbus::run, argc, argv); }
