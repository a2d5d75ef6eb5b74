#include "bridge/source/source_main.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bridge/source/device_teller.h"
#include "bridge/source/estimate_teller.h"
#include "bridge/source/model_text.h"
#include "bridge/source/scene_teller.h"
#include "bridge/source/sim_obey.h"
#include "bridge/source/sim_pace.h"
#include "bridge/source/source_channels_main.h"
#include "bridge/source/refusal_teller.h"
#include "bridge/source/source_events.h"
#include "bridge/source/wait_count.h"
#include "common/process/priority.h"
#include "lcmtypes/bus/node.h"
#include "lcmtypes/node/missed_ticks.h"
#include "common/time/latency_histogram.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::inline bridge {

namespace {

constexpr double kCommandDeadline = 0.6;  // of the period, then the command is late
constexpr std::int64_t kStatusEvery_ns = 100'000'000;
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr double kResendEvery = 0.020;  // lock-step [s]
constexpr double kPausedWait = 0.02;    // [s]
constexpr std::int64_t kPatience_ns = 200'000'000;  // of a world that waits for a late command
constexpr int kLastTicks = 25;          // of a robot that is held before the process ends

class Shell {
 public:
  Shell(const SourceMainOptions& options, const Model& model, RobotAdaptor& adaptor,
        RealTime real_time)
      : options_(options),
        model_(model),
        adaptor_(adaptor),
        node_(options.common, options.process, real_time),
        run_id_(node_.id()),
        source_(model, adaptor, config()),
        estimate_(model),
        scene_(model_text_pieces(model, options.scene_text, run_id_), options.obstacles,
               options.terrain, run_id_),
        script_(options.requests, model.period(), run_id_) {
    period_ns_ = std::llround(model.period_ns / options.rate);
    told_ = source_.status();
    told_.role = Role::kNone;
    if (!options.lockstep) missed_.watch(period_ns_);
    listen();
  }

  std::int64_t run_id() const { return run_id_; }

  int run() {
    std::int64_t due = clock_.now();
    due += period_ns_ - due % period_ns_;
    while (!finished()) {
      if (clock_.paused()) {
        receive(kPausedWait);
        report();
        continue;
      }
      NoAlloc no_alloc;
      wait_until(due);
      wake_.add(clock_.now() - due);
      tick(due);
      clock_.ticked();
      due = next_due(due);
      allocations_ += no_alloc.count();
    }
    leave(due);
    return bus_gone_ ? 1 : 0;
  }

 private:
  SourceConfig config() const {
    SourceConfig c;
    c.run_id = run_id_;
    c.kind = options_.kind;
    c.pace = options_.lockstep ? Pace::kLockStep : Pace::kRealTime;
    // Lock-step does not wait for the guard's process, so its silence must not decide anything there; the
    // controller's own guard looks at every tick.
    c.guard_required = options_.guard_required && !options_.lockstep;
    c.seed = static_cast<std::uint64_t>(options_.seed) ^ static_cast<std::uint64_t>(monotonic_ns());
    return c;
  }

  void listen() {
    Bus& bus = node_.bus();
    bus.listen<&Shell::hear_state>(channel::kState, *this);
    for (const Channel<RobotState>& name : {channel::kStateSim, channel::kStateBridge, channel::kStateReplay}) {
      to_source<&Source::on_standby_state>(name);
    }
    to_source<&Source::on_command>(channel::kCommand);
    to_source<&Source::on_stop_plan>(channel::kStopPlan);
    to_source<&Source::on_source_request>(channel::kSourceRequest);
    to_source<&Source::on_controller_request>(channel::kControllerRequest);
    to_source<&Source::on_stop>(channel::kStop);
    to_source<&Source::on_guard>(channel::kGuard);
    to_source<&Source::on_controller_status>(channel::kControllerStatus);
    if (!adaptor_.is_hardware() && adaptor_.can_be_set())
      bus.listen<&Shell::obey>(channel::kSimRequest, *this);
    bus.listen(channel::kEstimate, estimate_);  // last: HEARTBEAT has rows for twelve
  }

  // What comes on the channel goes to the source, at the time of its clock.
  template <auto kOn>
  void to_source(const Channel<MessageOf<kOn>>& name) {
    node_.bus().listen<&Shell::hear<kOn>>(name, *this);
  }
  template <auto kOn>
  void hear(const MessageOf<kOn>& message) noexcept {
    (source_.*kOn)(message, clock_.now());
  }

  void hear_state(const RobotState& state) noexcept {
    estimate_.heard(state);
    source_.on_state(state, clock_.now());
  }

  // Once per sequence: the same request is sent several times.
  void obey(const SimRequest& m) {
    if (m.run_id != run_id_ || (m.sender_id == sim_sender_ && m.sequence == sim_sequence_)) return;
    sim_sender_ = m.sender_id;
    sim_sequence_ = m.sequence;
    tell(0, obey_sim_request(m, model_, clock_, adaptor_).data());
  }

  bool finished() const {
    if (quit_requested() || bus_gone_) return true;
    if (!(options_.duration > 0.0) || first_tick_ == 0) return false;
    const double active = model_.period() * static_cast<double>(source_.state().tick - first_tick_ + 1);
    return active >= options_.duration - 1e-9;
  }

  // In lock-step the command is the clock, as long as somebody may command.
  bool lockstep_now() const {
    return options_.lockstep && source_.publishes_on_state() &&
           source_.status().stop_kind <= StopKind::kBalanced;
  }

  // The world may stand still for somebody who is obeyed.
  bool patient_now() const {
    const SourceStatus& s = source_.status();
    // In a balanced stop the controller is obeyed, too.
    const bool obeys = s.role == Role::kActive || (s.role == Role::kStopped && s.stop_kind == StopKind::kBalanced);
    return options_.patient && !options_.lockstep && !clock_.changed() && obeys && s.controller_id != 0 &&
           s.stop_kind <= StopKind::kBalanced;
  }

  void receive(double timeout_s) {
    if (node_.bus().receive(timeout_s) < 0) bus_gone_ = true;
  }

  void wait_until(std::int64_t due) {
    if (lockstep_now()) return receive(0.0);
    for (std::int64_t left = due - clock_.now(); left > 0 && !quit_requested() && !bus_gone_;
         left = due - clock_.now()) {
      if (clock_.paused()) return;
      receive(1e-9 * static_cast<double>(left) / clock_.factor());
    }
    receive(0.0);
  }

  void tick(std::int64_t due) {
    const std::int64_t begin = clock_.now();
    source_.begin_tick(begin);
    const RobotState& state = source_.state();
    if (source_.publishes_on_state() && first_tick_ == 0) first_tick_ = state.tick;
    const std::int64_t sent = clock_.now();
    publish_state();
    if (source_.publishes_on_state() && !lockstep_now() && !clock_.changed() && !patient_now() &&
        sent - due > period_ns_ / 2) {
      missed_.add(1, sent - due - period_ns_ / 2, clock_.real_of(due - 2 * period_ns_), clock_.real_of(sent));
    }
    const bool has_truth = keep_truth();
    const std::int64_t published = clock_.now();
    if (lockstep_now()) {
      wait_for_answer();
    } else {
      const std::int64_t deadline =
          due + std::llround(kCommandDeadline * static_cast<double>(period_ns_));
      for (std::int64_t left = deadline - clock_.now();
           left > 0 && !source_.command_ready() && !bus_gone_ && !clock_.paused();
           left = deadline - clock_.now()) {
        receive(1e-9 * static_cast<double>(left));
      }
    }
    const std::int64_t waited = source_.command_ready() ? 0 : wait_for_late_command();
    if (source_.command_ready()) gave_up_ = false;
    const std::int64_t answered = clock_.now();
    // A tick without an answer counts with the whole time that was waited.
    if (is_commanded()) pulse_.answered(answered - sent + waited);
    source_.end_tick(answered);
    if (has_truth) {
      send(channel::kTruth, truth_);
      scene_.tell_loose(answered, adaptor_, tell_scene_);
      scene_.tell_held(answered, adaptor_, tell_scene_);
    }
    report();
    const std::int64_t end = clock_.now();
    pulse_.tick(monotonic_ns(), (published - begin) + (end - answered));
  }

  // The truth of the tick that was just published.  It is sent after the answer, which it would
  // delay.
  bool keep_truth() {
    const SimTruth* truth = adaptor_.truth();
    if (truth == nullptr || !source_.publishes_on_state()) return false;
    truth_ = *truth;
    truth_.tick = source_.state().tick;
    truth_.run_id = run_id_;
    return true;
  }

  bool is_commanded() const {
    const SourceStatus& s = source_.status();
    return s.role == Role::kActive && s.controller_id != 0 && s.stop_kind == StopKind::kNone;
  }

  void publish_state() {
    const bool active = source_.publishes_on_state();
    send(active ? channel::kState : own_channel(options_.kind), source_.state());
    if (!active) return estimate_.rest();
    send(channel::kEstimate, estimate_.of(source_.state()));  // after STATE, which it would delay
  }

  // Lock-step: the state is sent again until it is answered.
  void wait_for_answer() {
    const std::int64_t asked = clock_.now();
    bool said = false;
    while (!source_.command_ready() && lockstep_now() && !quit_requested() && !bus_gone_) {
      const std::int64_t sent = clock_.now();
      for (double left = kResendEvery; left > 0.0 && !source_.command_ready() && !bus_gone_;
           left = kResendEvery - 1e-9 * static_cast<double>(clock_.now() - sent)) {
        receive(left);
      }
      if (source_.command_ready()) break;
      report();
      publish_state();
      if (!said && clock_.now() - asked > kSecond_ns) {
        said = true;
        tell(1, "lock-step pauses: no controller has answered for 1 s");
        std::fprintf(stderr, "%s: lock-step pauses: no controller has answered tick %lld for 1 s\n",
                     options_.program.c_str(), static_cast<long long>(source_.state().tick));
      }
    }
  }

  // The world stands still until the command comes, but not for ever: then the robot follows its stop plan, and nobody is
  // waited for again before he has spoken.  Gives the time that was waited.
  std::int64_t wait_for_late_command() {
    if (!patient_now() || gave_up_) return 0;
    const std::int64_t begin = monotonic_ns();
    const auto resend = static_cast<std::int64_t>(1e9 * kResendEvery);
    clock_.stand();
    std::int64_t sent = begin, now = begin;
    while (!source_.command_ready() && !quit_requested() && !bus_gone_ && now - begin < kPatience_ns) {
      receive(1e-9 * static_cast<double>(std::max<std::int64_t>(sent + resend - now, 0)));
      now = monotonic_ns();
      if (source_.command_ready() || now - sent < resend) continue;
      publish_state();
      sent = now;
    }
    if (!source_.command_ready()) receive(0.0);  // the process itself may have slept
    gave_up_ = !source_.command_ready();
    clock_.end_stand();
    now = monotonic_ns();
    count_wait(now - begin, now);
    return now - begin;
  }

  void count_wait(std::int64_t waited_ns, std::int64_t now) {
    if (const char* sentence = waits_.add(waited_ns, now)) tell(1, sentence);
  }

  // Ticks lie on absolute multiples of the period; a process that slept goes on and does not catch
  // up in a burst.
  std::int64_t next_due(std::int64_t due) {
    std::int64_t next = due + period_ns_;
    if (options_.rate == 1.0) next = source_.next_tick_due_ns(due);
    const std::int64_t now = clock_.now();
    if (next < now - period_ns_) {
      if (patient_now()) {  // no tick is missed: the clock stood still with the process
        clock_.lose(now - next);
        count_wait(now - next, monotonic_ns());
        return next;
      }
      if (source_.publishes_on_state() && !options_.lockstep && !clock_.changed()) {
        missed_.add((now - next) / period_ns_, now - next - period_ns_, clock_.real_of(due - period_ns_), clock_.real_of(now));
      }
      next += (now - next) / period_ns_ * period_ns_;
    }
    return next;
  }

  template <class T>
  void send(const Channel<T>& name, const T& value) {
    node_.send(name, value);
  }

  void tell(int severity, const char* text) { node_.tell(severity, text, run_id_, source_.state().tick); }

  void send_event(Event& event) {
    event.run_id = run_id_;
    event.tick = source_.state().tick;
    node_.tell(event);
  }

  void report() {
    const std::int64_t now = monotonic_ns();
    SourceStatus status = source_.status();
    status.ticks_missed = missed_.count();
    if (options_.patient && !options_.lockstep) status.pace = static_cast<std::int8_t>(Pace::kPatient);
    if (clock_.changed()) status.pace = static_cast<std::int8_t>(clock_.paused() ? Pace::kPaused : Pace::kSlowed);
    const bool changed = status.role != told_.role || status.stop_kind != told_.stop_kind ||
                         status.refusal != told_.refusal || status.term != told_term_ ||
                         status.refusal_sequence != told_.refusal_sequence ||
                         status.stop_nonce != told_nonce_ || status.pace != told_.pace ||
                         status.controller_id != told_.controller_id ||
                         (status.faded_in < 1.0f) != told_fading_;
    Event event;
    if (std::array<char, 200> cause; source_.take_fall(cause)) tell(2, cause.data());
    while (next_sentence(told_, status, event) || device_.next(static_cast<Status>(status.adaptor_status), now, event) ||
           cuts_.next(source_.first_cut(), source_.first_catch_up(), model_, event) ||
           refusals_.next(source_.refused(), model_, now, event))
      send_event(event);
    if (changed || now - status_ns_ >= kStatusEvery_ns) {
      told_term_ = status.term;
      told_nonce_ = status.stop_nonce;
      told_.pace = status.pace;
      told_fading_ = status.faded_in < 1.0f;
      status_ns_ = now;
      status.utime = wall_us();
      send(channel::kSourceStatus, status);
    }
    StopRequest stop = source_.take_stop_to_publish(clock_.now());
    if (stop.kind != StopKind::kNone) {
      stop.utime = wall_us();
      send(channel::kStop, stop);
    }
    if (pulse_.due(now)) send_heartbeat();
    scene_.repeat(now, tell_scene_);
    send_script();
  }

  void send_heartbeat() {
    Heartbeat& beat = node_.beat();
    const SourceStatus& status = source_.status();
    beat.messages_rejected += status.commands_rejected + status.terms_ignored;
    missed_.tell(beat);
    beat.allocations = allocations_counted() ? allocations_ : -1;
    beat.wake_p99_us = static_cast<float>(1e-3 * wake_.p99_ns());
    beat.state = source_.publishes_on_state() ? std::int8_t{2} : std::int8_t{1};
    node_.send_heartbeat(beat);
  }

  void send_script() {
    if (first_tick_ == 0 || !source_.publishes_on_state()) return;
    script_.after(source_.state().tick, first_tick_, [this](auto& request) {
      request.utime = wall_us();
      send(channel_of(request), request);
    });
  }

  // A robot is held for a moment, so that whoever watches sees the stop; then STATE is left.
  void leave(std::int64_t due) {
    if (bus_gone_) return;
    if (source_.publishes_on_state() && adaptor_.is_hardware()) {
      StopRequest stop;
      stop.sender_id = run_id_;
      stop.kind = StopKind::kHold;
      stop.reason = StopReason::kLauncher;
      source_.on_stop(stop, clock_.now());
      for (int i = 0; i < kLastTicks; ++i) {
        sleep_until_ns(clock_.real_of(due));
        tick(due);
        due += period_ns_;
      }
    }
    RobotState last = source_.state();
    last.role = Role::kParked;
    last.grant_run_id = 0;
    send(own_channel(options_.kind), last);
    SourceStatus status = source_.status();
    status.role = Role::kParked;
    status.utime = wall_us();
    send(channel::kSourceStatus, status);
    tell(0, "source ended");
  }

  struct TellScene {
    Shell* s;
    void text(ModelTextPiece& piece) const noexcept { stamped(channel::kModelText, piece); }
    void obstacles(ObstaclesPiece& piece) const noexcept { stamped(channel::kObstacles, piece); }
    void terrain(ObstaclesPiece& piece) const noexcept { stamped(channel::kTerrain, piece); }
    void loose(ObstaclesPiece& piece) const noexcept { stamped(channel::kLoose, piece); }
    void held(ObstaclesPiece& piece) const noexcept { stamped(channel::kHeld, piece); }
    template <class T>
    void stamped(const Channel<T>& name, T& piece) const noexcept {
      piece.utime = wall_us();
      s->send(name, piece);
    }
  };

  const SourceMainOptions& options_;
  const Model& model_;
  RobotAdaptor& adaptor_;
  Node node_;
  Pulse& pulse_ = node_.pulse();
  std::int64_t run_id_;
  Source source_;
  EstimateTeller estimate_;
  SceneTeller scene_;
  SceneScript script_;
  SimTruth truth_;
  SourceStatus told_;
  CutTeller cuts_;
  RefusalTeller refusals_;
  DeviceTeller device_;
  MissedTicks missed_;
  SimPace clock_;
  RateStats wake_;
  WaitCount waits_;
  bool gave_up_ = false;  // of waiting, until a command comes
  std::int64_t period_ns_ = 0, first_tick_ = 0, allocations_ = 0, status_ns_ = 0;
  std::int64_t sim_sender_ = 0;
  std::int32_t sim_sequence_ = 0, told_term_ = 0, told_nonce_ = 0;
  bool told_fading_ = true, bus_gone_ = false;

  TellScene tell_scene_{this};
};

}  // namespace

void add_source_options(Options& parser, SourceMainOptions& options, bool simulator) {
  parser.number("--for", "S", options.duration, 0.0, 1e7,
                "ends after S seconds of being active; 0: never");
  parser.flag("--guard-required", options.guard_required,
              "brakes the arms while no guard is heard");
  if (!simulator) return;
  parser.flag("--lockstep", options.lockstep,
              "waits for the answer to every STATE instead of the clock");
  parser.flag("--patient", options.patient,
              "the clock stands still for up to 200 ms while a command is late");
  parser.number("--rate", "X", options.rate, 0.01, 100.0, "runs X times as fast as real time");
  parser.integer("--seed", "N", options.seed, 0, INT64_MAX, "of everything random");
}

int run_source_main(const SourceMainOptions& options, const Model& model, RobotAdaptor& adaptor) {
  catch_quit_signals();
  const RealTime real_time = enter_real_time(options.priority, options.program.c_str());
  Shell shell(options, model, adaptor, real_time);
  std::printf("%s ready: %s, %d joints, run %lld, %s, %s\n", options.program.c_str(),
              model.name.c_str(), model.bus_count(), static_cast<long long>(shell.run_id()),
              options.lockstep  ? "lock-step"
              : options.patient ? "real time, but waits for late commands"
                                : "real time",
              to_text(real_time));
  return shell.run();
}

}  // namespace twinbus::bridge
