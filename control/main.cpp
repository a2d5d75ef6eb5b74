// The controller process: answers each STATE at once with a COMMAND.
//
// Everything that decides is ControlLoop; here are the bus, the heartbeat and the sentences for
// people.  The loop allocates nothing; only obstacles, which change with the scene, are taken over
// between ticks with an allocation that is not counted.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "control/loop/control_loop.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/journal.h"
#include "robot/description/load.h"
#include "robot/collision/loop_joints.h"
#include "lcmtypes/node/missed_ticks.h"
#include "robot/collision/obstacle_collector.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "lcmtypes/node/pulse.h"
#include "lcmtypes/msg/state_admission.h"
#include "test/no_alloc.h"

namespace twinbus {
namespace {

// FIFO, above the sources': its tick is the shortest, and a standby's long one must not delay it.
constexpr int kPriority = 75;
constexpr double kWait = 0.02;  // [s] for a message, then the heartbeat gets its turn
constexpr std::int64_t kQuietNs = 1'000'000'000;  // between two events of the same sentence
constexpr std::int64_t kStoppedEvery = 10;        // a stop is published that often [ticks]
constexpr std::int64_t kFootstepsEvery = 25;      // [ticks]
constexpr int kMostCaughtUp = 8;                  // states answered late in a row

struct Arguments {
  CommonOptions common;
  std::string first_mode = "balance";
  bool no_guard = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options("twinbus_controller", "Answers every STATE of the active source with a COMMAND.");
  add_common(options, a.common);
  options.choice("--mode", {"idle", "hold", "balance"}, a.first_mode,
                 "entered when a robot is first heard");
  options.flag("--no-guard", a.no_guard, "leaves the guard inside the loop out");
  options.parse(argc, argv);
  return a;
}

class Controller {
 public:
  Controller(const Arguments& a, const Model& model, RealTime real_time)
      : model_(model),
        id_(a.common.id != 0 ? a.common.id : random_id()),
        bus_({.url = a.common.url, .prefix = a.common.prefix, .allow = {a.common.allow}}),
        loop_(model, config(a)),
        pulse_(ProcessKind::kController, id_, real_time),
        journal_(ProcessKind::kController, id_,
                 {static_cast<double>(config(a).first_mode), a.no_guard ? 0.0 : 1.0},
                 SendPage{this}) {
    missed_.watch(model.period_ns);
    listen();
  }

  void run() {
    while (!quit_requested()) {
      NoAlloc no_alloc;
      caught_up_ = 0;
      if (bus_.receive(kWait) < 0) throw std::runtime_error("the bus is gone");
      if (fresh_) answer();
      if (pulse_.due(monotonic_ns())) send_heartbeat();
      allocations_ += no_alloc.count();
      if (new_obstacles_) {
        new_obstacles_ = false;
        journal_.consumed(JournalInput::kTakeObstacles, {}, monotonic_ns());
        loop_.set_obstacles(obstacles_.obstacles());
      }
    }
  }

 private:
  ControlConfig config(const Arguments& a) const {
    ControlConfig c;
    c.controller_id = id_;
    c.first_mode = a.first_mode == "idle"   ? Mode::kIdle
                   : a.first_mode == "hold" ? Mode::kHold
                                            : Mode::kBalance;
    c.guard_in_loop = !a.no_guard;
    return c;
  }

  void listen() {
    bus_.listen_each<RobotState>(channel::kState, on_state_);
    bus_.listen_each<ModeRequest>(channel::kModeRequest, on_mode_);
    bus_.listen_each<WalkCommand>(channel::kWalk, on_walk_);
    bus_.listen_each<StepList>(channel::kSteps, on_steps_);
    bus_.listen_each<MotionPiece>(channel::kMotion, on_motion_);
    bus_.listen_each<Gamepad>(channel::kGamepad, on_gamepad_);
    bus_.listen_each<ArmPathPiece>(channel::kArmPath, on_path_);
    bus_.listen_each<ArmGoal>(channel::kArmGoal, on_goal_);
    bus_.listen_each<StopRequest>(channel::kStop, on_stop_);
    bus_.listen_each<GuardReport>(channel::kGuard, on_guard_);
    bus_.listen_each<ObstaclesPiece>(channel::kObstacles, on_obstacles_);
  }

  void hear_state(const RobotState& state, std::span<const std::uint8_t> bytes) {
    if (state.joint_count != model_.bus_count() || state.model_hash != model_.hash) {
      if (rejected_++ == 0) {
        std::fprintf(stderr,
                     "controller: STATE of another robot (model hash %lld, %d joints; %s has %lld, "
                     "%d): start the "
                     "source and the controller with the same --robot\n",
                     static_cast<long long>(state.model_hash), static_cast<int>(state.joint_count),
                     model_.name.c_str(), static_cast<long long>(model_.hash), model_.bus_count());
      }
      return;
    }
    const std::int64_t now = monotonic_ns();
    const std::int64_t last = admission_.run_id();
    if (!admission_.admit(state, now)) return;
    // A process that slept finds several: each gets its answer, in order, as far as that helps.
    if (fresh_ && caught_up_ < kMostCaughtUp) {
      ++caught_up_;
      answer();
    }
    if (pulse_.ticks() > 0 && last == state.run_id) {
      // Ticks that never came, and one that came but was overtaken before it was answered.
      const std::int64_t unanswered =
          std::max<std::int64_t>(state.tick - state_.tick - 1, 0) + (fresh_ && state.tick != state_.tick ? 1 : 0);
      if (unanswered > 0) {
        missed_.add(unanswered, model_.period_ns / 2, heard_ns_ - model_.period_ns, now);
      }
    }
    state_ = state;
    state_hash_ = content_hash(bytes);
    heard_ns_ = now;
    fresh_ = true;
  }

  void answer() {
    fresh_ = false;
    loop_.on_state(state_, heard_ns_);
    const std::int64_t begin = monotonic_ns();
    const bool has_answer = loop_.step(begin, command_);
    const std::int64_t end = monotonic_ns();
    std::int64_t answer_hash = 0, report_hash = 0;
    if (has_answer) {
      answer_hash = send_answer();
      while (loop_.take_plan(plan_)) {
        if (!bus_.send(channel::kStopPlan, plan_)) ++send_failures_;
      }
      pulse_.answered(monotonic_ns() - heard_ns_);
      pulse_.tick(end, end - begin);
      ControllerStatus status = loop_.status();
      report_hash = hash_of(status);
      status.compute_ns = static_cast<std::int32_t>(std::min<std::int64_t>(end - begin, INT32_MAX));
      if (!bus_.send(channel::kControllerStatus, status)) ++send_failures_;
      if (state_.tick - footsteps_tick_ >= kFootstepsEvery || state_.tick < footsteps_tick_)
        send_footsteps();
    }
    journal_.stepped(state_, state_hash_, begin, answer_hash, report_hash);
    if (const char* sentence = loop_.take_sentence()) tell(sentence);
    if (loop_.guard_report().stop_asked && state_.stop_kind == StopKind::kNone) ask_for_a_stop();
  }

  // The COMMAND; gives the hash of its bytes.
  std::int64_t send_answer() {
    std::array<std::uint8_t, kLargestMessage> bytes;
    const auto size = static_cast<std::size_t>(encode(command_, bytes));
    const auto message = std::span<const std::uint8_t>(bytes).first(size);
    if (!bus_.send_raw(channel::kCommand, message)) ++send_failures_;
    return content_hash(message);
  }

  // For whoever draws, while there are any and once when there are none any more.
  void send_footsteps() {
    footsteps_tick_ = state_.tick;
    const bool walked = footsteps_.count > 0;
    loop_.footsteps(footsteps_);
    if (footsteps_.count == 0 && !walked) return;
    footsteps_.utime = wall_us();
    footsteps_.scene_id = state_.run_id;
    if (!bus_.send(channel::kFootsteps, footsteps_)) ++send_failures_;
  }

  static std::int64_t hash_of(ControllerStatus status) {
    status.compute_ns = 0;  // the one number that a re-run does not have again
    std::array<std::uint8_t, kLargestMessage> bytes;
    const auto size = static_cast<std::size_t>(encode(status, bytes));
    return content_hash(std::span<const std::uint8_t>(bytes).first(size));
  }

  void ask_for_a_stop() {
    if (state_.tick < next_stop_tick_ && next_stop_tick_ - state_.tick <= kStoppedEvery) return;
    next_stop_tick_ = state_.tick + kStoppedEvery;
    StopRequest stop;
    stop.utime = wall_us();
    stop.sender_id = id_;
    stop.sequence = ++sequence_;
    stop.kind = StopKind::kBalanced;
    stop.reason = StopReason::kGuard;
    if (!bus_.send(channel::kStop, stop)) ++send_failures_;
  }

  void tell(const char* sentence) {
    const std::int64_t now = monotonic_ns();
    if (sentence == last_sentence_ && now - told_ns_ < kQuietNs) return;
    last_sentence_ = sentence;
    told_ns_ = now;
    Event event;
    event.utime = wall_us();
    event.sender_id = id_;
    event.run_id = state_.run_id;
    event.tick = state_.tick;
    event.sequence = ++event_sequence_;
    event.severity = 1;
    event.kind = ProcessKind::kController;
    std::strncpy(event.text.data(), sentence, event.text.size() - 1);
    if (!bus_.send(channel::kEvent, event)) ++send_failures_;
  }

  void send_heartbeat() {
    Heartbeat& beat = pulse_.beat(monotonic_ns());
    const BusCounters& c = bus_.counters();
    beat.messages_received = c.received;
    beat.messages_rejected = c.rejected + rejected_ + admission_.ignored();
    beat.messages_lost = missed_.count();
    missed_.tell(beat);
    beat.allocations = allocations_counted() ? allocations_ : -1;
    beat.send_failures =
        static_cast<std::int32_t>(std::min<std::int64_t>(c.send_failures, INT32_MAX));
    if (!bus_.send_heartbeat(beat)) ++send_failures_;
  }

  using Bytes = std::span<const std::uint8_t>;
  struct SendPage {
    Controller* c;
    void operator()(const JournalPage& page) const noexcept {
      if (!c->bus_.send(channel::kJournal, page)) ++c->send_failures_;
    }
  };
  struct OnState {
    Controller* c;
    void operator()(const RobotState& m, Bytes bytes) { c->hear_state(m, bytes); }
  };
  struct OnMode {
    Controller* c;
    void operator()(const ModeRequest& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kMode, bytes, monotonic_ns());
      c->loop_.on_mode_request(m);
    }
  };
  struct OnWalk {
    Controller* c;
    void operator()(const WalkCommand& m, Bytes bytes) {
      const std::int64_t now = monotonic_ns();
      c->journal_.consumed(JournalInput::kWalk, bytes, now);
      c->loop_.on_walk_command(m, now);
    }
  };
  struct OnSteps {
    Controller* c;
    void operator()(const StepList& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kSteps, bytes, monotonic_ns());
      c->loop_.on_step_list(m);
    }
  };
  struct OnMotion {
    Controller* c;
    void operator()(const MotionPiece& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kMotion, bytes, monotonic_ns());
      c->loop_.on_motion(m);
    }
  };
  struct OnGamepad {
    Controller* c;
    void operator()(const Gamepad& m, Bytes bytes) {
      const std::int64_t now = monotonic_ns();
      c->journal_.consumed(JournalInput::kGamepad, bytes, now);
      c->loop_.on_gamepad(m, now);
    }
  };
  struct OnPath {
    Controller* c;
    void operator()(const ArmPathPiece& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kPath, bytes, monotonic_ns());
      c->loop_.on_arm_path(m);
    }
  };
  struct OnGoal {
    Controller* c;
    void operator()(const ArmGoal& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kGoal, bytes, monotonic_ns());
      c->loop_.on_arm_goal(m);
    }
  };
  struct OnStop {
    Controller* c;
    void operator()(const StopRequest& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kStop, bytes, monotonic_ns());
      c->loop_.on_stop(m);
    }
  };
  struct OnGuard {
    Controller* c;
    void operator()(const GuardReport& m, Bytes bytes) {
      const std::int64_t now = monotonic_ns();
      c->journal_.consumed(JournalInput::kGuard, bytes, now);
      c->loop_.on_guard(m, now);
    }
  };
  struct OnObstacles {
    Controller* c;
    void operator()(const ObstaclesPiece& m, Bytes bytes) {
      c->journal_.consumed(JournalInput::kObstacles, bytes, monotonic_ns());
      c->new_obstacles_ = c->obstacles_.add(m) || c->new_obstacles_;
    }
  };

  const Model& model_;
  std::int64_t id_;
  Bus bus_;
  ControlLoop loop_;
  StateAdmission admission_;
  ObstacleCollector obstacles_;
  bool new_obstacles_ = false, fresh_ = false;
  int caught_up_ = 0;  // states answered late since the last wait
  RobotState state_;
  JointCommand command_;
  StopPlanPiece plan_;
  ObstaclesPiece footsteps_;
  std::int64_t footsteps_tick_ = 0;
  Pulse pulse_;
  MissedTicks missed_;
  JournalWriter<SendPage> journal_;
  std::int64_t heard_ns_ = 0, told_ns_ = 0, state_hash_ = 0;
  std::int64_t rejected_ = 0, allocations_ = 0, send_failures_ = 0, next_stop_tick_ = 0;
  std::int32_t sequence_ = 0, event_sequence_ = 0;
  const char* last_sentence_ = nullptr;

  OnState on_state_{this};
  OnMode on_mode_{this};
  OnWalk on_walk_{this};
  OnSteps on_steps_{this};
  OnMotion on_motion_{this};
  OnGamepad on_gamepad_{this};
  OnPath on_path_{this};
  OnGoal on_goal_{this};
  OnStop on_stop_{this};
  OnGuard on_guard_{this};
  OnObstacles on_obstacles_{this};
};

int run(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  catch_quit_signals();
  const Model model = load_robot(a.common.robot);
  std::string why;
  const RealTime real_time = enter_real_time(kPriority, &why);
  if (!why.empty()) std::fprintf(stderr, "controller: %s\n", why.c_str());
  Controller controller(a, model, real_time);
  const std::string loops = loops_sentence(model);
  if (!loops.empty()) std::fprintf(stderr, "controller: %s\n", loops.c_str());
  std::printf("controller ready: %s, %d joints, %s\n", model.name.c_str(), model.bus_count(),
              real_time == RealTime::kNone ? "no real-time priority" : "FIFO priority");
  std::fflush(stdout);
  controller.run();
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("controller", twinbus::run, argc, argv);
}
