// The controller process: answers each STATE at once with a COMMAND.
//
// Everything that decides is ControlLoop; here are the bus, the heartbeat and the sentences for
// people.  The loop allocates nothing; only obstacles, which change with the scene, are taken over
// between ticks with an allocation that is not counted.

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>

#include "common/process/options.h"
#include "control/loop/control_loop.h"
#include "control/robot_process_main.h"
#include "lcmtypes/msg/event_code.h"
#include "lcmtypes/msg/journal.h"
#include "lcmtypes/node/missed_ticks.h"

namespace twinbus::inline control {
namespace {

// FIFO, above the sources': its tick is the shortest, and a standby's long one must not delay it.
constexpr int kPriority = 75;
constexpr double kWait = 0.02;  // [s] for a message, then the heartbeat gets its turn
constexpr std::int64_t kQuietNs = 1'000'000'000;     // between two events of the same sentence
constexpr std::int64_t kQuietOfPathNs = 50'000'000;  // the same, where it answers a path
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

class Controller : RobotProcess {
 public:
  Controller(const Arguments& a, const Model& model, RealTime real_time)
      : RobotProcess(a.common, ProcessKind::kController, model, real_time),
        loop_(model, config(a)),
        journal_(ProcessKind::kController, node_.id(),
                 {static_cast<double>(config(a).first_mode), a.no_guard ? 0.0 : 1.0},
                 SendPage{&node_}) {
    missed_.watch(model.period_ns);
    listen();
  }

  std::string about() const { return std::to_string(model_.bus_count()) + " joints"; }

  void run() {
    while (!quit_requested()) {
      NoAlloc no_alloc;
      caught_up_ = 0;
      node_.receive(kWait);
      if (fresh_) answer();
      if (pulse_.due(monotonic_ns())) send_heartbeat();
      allocations_ += no_alloc.count();
      hand_on_obstacles(journal_, loop_);
    }
  }

 private:
  friend class RobotProcess;
  using Bytes = std::span<const std::uint8_t>;

  ControlConfig config(const Arguments& a) const {
    ControlConfig c;
    c.controller_id = node_.id();
    c.first_mode = a.first_mode == "idle"   ? Mode::kIdle
                   : a.first_mode == "hold" ? Mode::kHold
                                            : Mode::kBalance;
    c.guard_in_loop = !a.no_guard;
    return c;
  }

  void listen() {
    listen_to_robot(*this);
    for_each_control_input([this]<auto kOn>() {
      node_.bus().listen<&Controller::hear<kOn>>(channel_of(MessageOf<kOn>{}), *this);
    });
  }

  // Into the journal, then into the loop.
  template <auto kOn>
  void hear(const MessageOf<kOn>& message, Bytes bytes) {
    const std::int64_t now = monotonic_ns();
    journal_.consumed(journal_input(message), bytes, now);
    hand_over<kOn>(message, loop_, now);
  }

  void hear_obstacles(const ObstaclesPiece& piece, Bytes bytes) {
    journal_.consumed(JournalInput::kObstacles, bytes, monotonic_ns());
    new_obstacles_ = obstacles_.add(piece) || new_obstacles_;
  }

  void hear_held(const ObstaclesPiece& piece, Bytes bytes) {
    journal_.consumed(JournalInput::kHeld, bytes, monotonic_ns());
    new_obstacles_ = obstacles_.hold(piece) || new_obstacles_;
  }

  void hear_state(const RobotState& state, Bytes bytes) {
    if (!is_ours(state)) {
      if (rejected_ == 1) {
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
    take(state, now);
    state_hash_ = content_hash(bytes);
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
      while (loop_.take_plan(plan_)) node_.send(channel::kStopPlan, plan_);
      pulse_.answered(monotonic_ns() - heard_ns_);
      pulse_.tick(end, end - begin);
      ControllerStatus status = loop_.status();
      report_hash = hash_of(status);
      status.compute_ns = static_cast<std::int32_t>(std::min<std::int64_t>(end - begin, INT32_MAX));
      node_.send(channel::kControllerStatus, status);
      if (state_.tick - footsteps_tick_ >= kFootstepsEvery || state_.tick < footsteps_tick_)
        send_footsteps();
    }
    journal_.stepped(state_, state_hash_, begin, answer_hash, report_hash);
    bool of_path = false;
    if (const char* sentence = loop_.take_sentence(&of_path)) tell(sentence, of_path);
    if (loop_.guard_report().stop_asked && state_.stop_kind == StopKind::kNone) ask_for_a_stop();
  }

  // The COMMAND; gives the hash of its bytes.
  std::int64_t send_answer() {
    std::array<std::uint8_t, kLargestMessage> bytes;
    const auto size = static_cast<std::size_t>(encode(command_, bytes));
    const auto message = std::span<const std::uint8_t>(bytes).first(size);
    static_cast<void>(node_.bus().send_raw(channel::kCommand, message));  // counted by the bus
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
    node_.send(channel::kFootsteps, footsteps_);
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
    node_.ask_for_a_stop(StopReason::kGuard);
  }

  void tell(const char* sentence, bool of_path) {
    const std::int64_t now = monotonic_ns();
    // Of each path that is not followed, and of each mode that was asked, somebody waits to hear it; nobody sends goals at the rate of
    // a loop.
    const std::int32_t asked = loop_.status().mode_sequence;
    const bool answers = of_path || asked != told_sequence_;
    if (sentence == last_sentence_ && now - told_ns_ < (answers ? kQuietOfPathNs : kQuietNs)) return;
    told_sequence_ = asked;
    last_sentence_ = sentence;
    told_ns_ = now;
    node_.tell(1, sentence, state_.run_id, state_.tick, of_path ? kArmPathRefused : 0);
  }

  void send_heartbeat() {
    Heartbeat& now = beat();
    now.messages_lost = missed_.count();
    missed_.tell(now);
    node_.send_heartbeat(now);
  }

  ControlLoop loop_;
  int caught_up_ = 0;  // states answered late since the last wait
  JointCommand command_;
  StopPlanPiece plan_;
  ObstaclesPiece footsteps_;
  std::int64_t footsteps_tick_ = 0;
  MissedTicks missed_;
  JournalWriter<SendPage> journal_;
  std::int64_t told_ns_ = 0, state_hash_ = 0, next_stop_tick_ = 0;
  const char* last_sentence_ = nullptr;
  std::int32_t told_sequence_ = 0;  // of the mode request that had been heard when it was told
};

int run(int argc, char** argv) { return run_ready<Controller>("controller", parse(argc, argv), kPriority); }

}  // namespace
}  // namespace twinbus::control

int main(int argc, char** argv) { return twinbus::run_process("controller", twinbus::run, argc, argv); }
