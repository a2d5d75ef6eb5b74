// The guard process: judges every STATE and the COMMAND that answers it, and says on GUARD which
// joints to hold.
//
// A second opinion beside the guard inside the controller, with a smaller margin, so that it acts
// when the controller is wrong and is silent otherwise.  The gate obeys its mask; what the legs
// bring together asks for a balanced stop.

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>

#include "common/process/options.h"
#include "control/guard/guard_watch.h"
#include "control/robot_process_main.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "lcmtypes/msg/journal.h"

namespace twinbus::inline control {
namespace {

constexpr int kPriority = 50;          // FIFO, below the controller's
constexpr double kWait = 0.02;         // [s] for a message, then the heartbeat gets its turn
constexpr std::int64_t kWarmUp = 100;  // ticks; LCM makes a list per channel with its first message
constexpr std::int64_t kStopEvery = 10;  // a stop is asked for again after as many ticks
constexpr std::int64_t kQuietNs = 1'000'000'000;
constexpr std::int64_t kQuietSameNs = 10 * kQuietNs;

struct Arguments {
  CommonOptions common;
  double margin_mm = 1e3 * GuardDefaults::kSecondOpinion;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options("twinbus_guard",
                  "Watches the robot for contact with itself and obstacles; says on GUARD which "
                  "joints to hold.");
  add_common(options, a.common);
  options.number("--margin-mm", "MM", a.margin_mm, 0.0, 100.0,
                 "distance that is left when everything has come to rest");
  options.parse(argc, argv);
  return a;
}

class GuardProcess : RobotProcess {
 public:
  GuardProcess(const Arguments& a, const Model& model, RealTime real_time)
      : RobotProcess(a.common, ProcessKind::kGuard, model, real_time),
        margin_mm_(a.margin_mm),
        watch_(model, {.guard_id = node_.id(), .margin = 1e-3 * a.margin_mm}),
        journal_(ProcessKind::kGuard, node_.id(), {1e-3 * a.margin_mm}, SendPage{&node_}) {
    listen_to_robot(*this);
    Bus& bus = node_.bus();
    bus.listen<&GuardProcess::hear_command>(channel::kCommand, *this);
    bus.listen<&GuardProcess::hear_source>(channel::kSourceStatus, *this);
  }

  std::string about() const {
    char text[40];
    std::snprintf(text, sizeof text, "margin %.0f mm", margin_mm_);
    return text;
  }

  void run() {
    while (!quit_requested()) {
      NoAlloc no_alloc;
      node_.receive(kWait);
      if (fresh_) judge();
      if (pulse_.due(monotonic_ns())) send_heartbeat();
      if (pulse_.ticks() > kWarmUp) allocations_ += no_alloc.count();
      hand_on_obstacles(journal_, watch_);
    }
  }

 private:
  friend class RobotProcess;
  using Bytes = std::span<const std::uint8_t>;

  void hear_state(const RobotState& state, Bytes bytes) noexcept {
    if (!is_ours(state)) return;
    const std::int64_t now = monotonic_ns();
    const std::int64_t last = admission_.run_id();
    if (!admission_.admit(state, now)) return;
    if (pulse_.ticks() > 0 && last == state.run_id && state.tick > state_.tick + 1)
      missed_ += state.tick - state_.tick - 1;
    take(state, now);
    state_hash_ = content_hash(bytes);
  }

  void hear_obstacles(const ObstaclesPiece& piece, Bytes bytes) noexcept {
    journal_.consumed(JournalInput::kObstacles, bytes, monotonic_ns());
    new_obstacles_ = obstacles_.add(piece) || new_obstacles_;
  }

  void hear_held(const ObstaclesPiece& piece, Bytes bytes) noexcept {
    journal_.consumed(JournalInput::kHeld, bytes, monotonic_ns());
    new_obstacles_ = obstacles_.hold(piece) || new_obstacles_;
  }

  // Whom the source obeys.
  void hear_source(const SourceStatus& status) noexcept {
    if (status.run_id == admission_.run_id() && status.term == admission_.term())
      controller_ = status.controller_id;
  }

  // The newest command that is for the source we watch: one that its gate would refuse moves nothing, and must not stop it.
  void hear_command(const JointCommand& command, Bytes bytes) noexcept {
    if (command.run_id != admission_.run_id() || command.term != admission_.term() ||
        command.joint_count != model_.bus_count() || command.model_hash != model_.hash ||
        command.tick > state_.tick || (controller_ != 0 && command.controller_id != controller_)) {
      return;
    }
    journal_.consumed(JournalInput::kCommand, bytes, monotonic_ns());
    watch_.on_command(command);
  }

  void judge() noexcept {
    fresh_ = false;
    const std::int64_t begin = monotonic_ns();
    GuardReport report = watch_.judge(state_);
    const std::int64_t end = monotonic_ns();
    const std::int64_t answer_hash = hash_of(report);
    report.compute_ns = static_cast<std::int32_t>(std::min<std::int64_t>(end - begin, INT32_MAX));
    node_.send(channel::kGuard, report);
    journal_.stepped(state_, state_hash_, begin, answer_hash, 0);
    pulse_.tick(end, end - begin);
    pulse_.answered(end - heard_ns_);
    if (report.stop_asked) ask_for_a_stop();
    if (report.hold_mask != 0 || report.stop_asked) tell(report);
  }

  static std::int64_t hash_of(const GuardReport& report) noexcept {
    std::array<std::uint8_t, kLargestMessage> bytes;
    const auto size = static_cast<std::size_t>(encode(report, bytes));
    return content_hash(Bytes(bytes).first(size));
  }

  void ask_for_a_stop() noexcept {
    const std::int64_t since = state_.tick - stop_tick_;
    if (stop_tick_ != 0 && since >= 0 && since < kStopEvery) return;
    stop_tick_ = state_.tick;
    node_.ask_for_a_stop(StopReason::kGuard);
  }

  // Who comes too near whom, at most once a second; while it stays the same two, seldom.
  void tell(const GuardReport& report) noexcept {
    const std::int64_t now = monotonic_ns();
    const GuardCause& cause = watch_.cause();
    const std::array<int, 2> pair{cause.link_a, cause.link_b};
    const bool same = pair == told_pair_ && report.stop_asked == told_stop_ && now - held_ns_ < kQuietNs;
    held_ns_ = now;
    if (told_ns_ != 0 && now - told_ns_ < (same ? kQuietSameNs : kQuietNs)) return;
    told_ns_ = now;
    told_pair_ = pair;
    told_stop_ = report.stop_asked;
    Event event;
    event.run_id = state_.run_id;
    event.tick = state_.tick;
    event.severity = 1;
    const int used = std::snprintf(event.text.data(), event.text.size(), "%s: ",
                                   report.stop_asked ? "guard asks for a stop" : "guard holds joints");
    describe(model_, watch_.obstacles(), cause, std::span(event.text).subspan(static_cast<std::size_t>(used)));
    node_.tell(event);
  }

  void send_heartbeat() {
    Heartbeat& now = beat();
    now.messages_lost = now.ticks_missed = missed_;
    node_.send_heartbeat(now);
  }

  double margin_mm_;
  GuardWatch watch_;
  std::int64_t controller_ = 0;  // that the source obeys; 0 not known
  JournalWriter<SendPage> journal_;
  std::int64_t told_ns_ = 0, held_ns_ = 0, stop_tick_ = 0, state_hash_ = 0;
  std::array<int, 2> told_pair_{-1, -1};
  bool told_stop_ = false;
  std::int64_t missed_ = 0;
};

int run(int argc, char** argv) { return run_ready<GuardProcess>("guard", parse(argc, argv), kPriority); }

}  // namespace
}  // namespace twinbus::control

int main(int argc, char** argv) { return twinbus::run_process("guard", twinbus::run, argc, argv); }
