// Two sources and one controller tick by tick in one process: a simulator, and a stand-in robot that cannot be set or
// another simulator.
//
// Everything of the product but the bus and the clock: Source, gate, handover, admission, control loop.  The clock is
// counted, so a run is the same on any machine.  The standby's tick comes a little before STATE, as in real time; a
// source can be made to wake late, and the whole machine to stand still.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bridge/source/source.h"
#include "control/loop/control_loop.h"
#include "lcmtypes/msg/state_admission.h"
#include "sim/emulated_robot.h"
#include "sim/sim_adaptor.h"

namespace twinbus {

// A simulated body behind the contract of a real one: nobody can set it.
class StandInBody final : public RobotAdaptor {
 public:
  explicit StandInBody(const Scene& scene) : body_(scene) {}
  Status open(const Model& model, const AdaptorConfig& config) override {
    AdaptorConfig all{EmulatedRobot::differences()};
    all.settings.insert(all.settings.end(), config.settings.begin(), config.settings.end());
    return body_.open(model, all);
  }
  Status read(RobotState& state, double timeout_s) override {
    if (missed_ == 0 && again_ > 0) {  // the newest there is
      --again_;
      state = newest_;
      return Status::kOk;
    }
    for (; missed_ > 0; --missed_) {
      if (written_) (void)body_.write(last_);
      (void)body_.read(state, timeout_s);
    }
    const Status status = body_.read(state, timeout_s);
    newest_ = state;
    return status;
  }
  Status write(const JointCommand& command) override {
    last_ = command;
    written_ = true;
    return body_.write(command);
  }
  // Its clock went on while nobody read: so many cycles with the last command come before the next read, and the one
  // after finds nothing newer.
  void miss(int cycles) {
    missed_ = cycles;
    again_ = 1;
  }
  void close() override { body_.close(); }
  const SimTruth* truth() const override { return body_.truth(); }

 private:
  SimAdaptor body_;
  JointCommand last_;
  RobotState newest_;
  bool written_ = false;
  int missed_ = 0, again_ = 0;
};

class TwoSources {
 public:
  static constexpr std::int64_t kSimulator = 1, kRobot = 2, kOperator = 11;

  // A robot shadows the simulator while it is not active; a second simulator tracks it.
  TwoSources(const Model& model, const Scene& scene, const ControlConfig& control,
             std::unique_ptr<RobotAdaptor> second, const AdaptorConfig& settings)
      : model_(model), loop_(model, control) {
    own_clock_ = dynamic_cast<StandInBody*>(second.get());
    body_ = {std::make_unique<SimAdaptor>(scene), std::move(second)};
    if (body_[0]->open(model, {}) != Status::kOk || body_[1]->open(model, settings) != Status::kOk)
      throw std::runtime_error("a body does not open");
    for (std::size_t s : {0U, 1U}) {
      const auto kind = body_[s]->is_hardware() ? SourceKind::kBridge : SourceKind::kSimulator;
      source_[s] = std::make_unique<Source>(
          model, *body_[s], SourceConfig{.run_id = run_of(static_cast<int>(s)), .kind = kind});
    }
    while (now_ < 1'100'000'000) tick();
    request(SourceAction::kActivate, kSimulator, SwitchPolicy::kNow);
    for (int i = 0; i < 5; ++i) tick();
    request(body_[1]->is_hardware() ? SourceAction::kStandbyShadow : SourceAction::kStandbyTrack,
            kRobot, SwitchPolicy::kNow);
  }

  void tick() {
    now_ += model_.period_ns;
    if (stalled_ > 0) {
      --stalled_;
      late_ = true;
      return;
    }
    // Of the ticks that were missed a source catches one up, and its answer finds it at the next.
    if (std::exchange(late_, false)) {
      answers_wait_ = true;
      all_tick();
      answers_wait_ = false;
    }
    all_tick();
  }
  // The machine stands still for so many ticks from now on.
  void stall(int ticks) {
    stalled_ = ticks;
    if (own_clock_ != nullptr) own_clock_->miss(ticks);
  }
  // The source does not wake for so many ticks from now on.
  void sleep(int index, int ticks) { delay_[static_cast<std::size_t>(index)].asleep = ticks; }
  // Its next tick takes so long that so many STATEs of the other one come before its own.
  void slow(int index, int ticks) { delay_[static_cast<std::size_t>(index)].slow = ticks; }

  // Index of the source on STATE: 0 simulator, 1 robot; -1 none.
  int active() const {
    if (source_[0]->publishes_on_state()) return 0;
    return source_[1]->publishes_on_state() ? 1 : -1;
  }
  void request(SourceAction action, std::int64_t target, SwitchPolicy policy) {
    SourceRequest r;
    r.sender_id = kOperator;
    r.sequence = ++sequence_;
    r.action = action;
    r.policy = policy;
    r.target_run_id = target;
    r.run_id = action == SourceAction::kSwitch ? run_of(active()) : target;
    for (auto& source : source_) source->on_source_request(r, now_);
  }
  void ask(Mode mode) {
    ModeRequest r;
    r.run_id = run_of(active());
    r.sender_id = kOperator;
    r.sequence = ++sequence_;
    r.mode = mode;
    loop_.on_mode_request(r);
  }
  void want(double vx, double vy, double wz) {
    WalkCommand w;
    w.run_id = run_of(active());
    w.sequence = ++sequence_;
    w.vx = static_cast<float>(vx);
    w.vy = static_cast<float>(vy);
    w.wz = static_cast<float>(wz);
    w.timeout = 0.1F;
    loop_.on_walk_command(w, now_);
  }

  static std::int64_t run_of(int index) { return index == 1 ? kRobot : kSimulator; }
  const Source& source(int index) const { return *source_[static_cast<std::size_t>(index)]; }
  const SimTruth& truth(int index) const {
    return *body_[static_cast<std::size_t>(index)]->truth();
  }
  const ControlLoop& loop() const { return loop_; }
  std::int64_t now_ns() const { return now_; }
  std::int64_t unanswered() const { return unanswered_; }   // STATEs without a COMMAND
  const JointCommand& command() const { return command_; }  // the last

 private:
  struct Delay {
    int asleep = 0, slow = 0, working = 0;
  };
  struct Answer {
    JointCommand command;
    ControllerStatus status;
  };
  void all_tick() {
    const std::size_t first = source_[0]->publishes_on_state() ? 1 : 0;  // the standby
    std::array<bool, 2> busy{};
    for (const std::size_t s : {first, 1 - first}) {
      Delay& delay = delay_[s];
      busy[s] = delay.asleep > 0 || delay.working > 0;
      if (delay.asleep > 0) {
        --delay.asleep;
      } else if (delay.working == 0) {
        source_[s]->begin_tick(s == first ? now_ - 300'000 : now_);
        delay.working = std::exchange(delay.slow, 0);
        busy[s] = delay.working > 0;
        if (!busy[s]) deliver(s, now_);
      }
    }
    for (const std::size_t s : {first, 1 - first}) {
      if (delay_[s].working > 0 && --delay_[s].working == 0) {
        deliver(s, now_ + 300'000);
        busy[s] = false;
      }
    }
    for (const std::size_t s : {first, 1 - first}) {
      if (!busy[s]) source_[s]->end_tick(now_ + 400'000);
    }
    say_stops();
  }
  void deliver(std::size_t s, std::int64_t now) {
    Source& own = *source_[s];
    Source& other = *source_[1 - s];
    const RobotState& state = own.state();
    if (!own.publishes_on_state()) {
      other.on_standby_state(state, now);
      return;
    }
    other.on_state(state, now);
    if (!admission_.admit(state, now)) {
      ++unanswered_;
      return;
    }
    loop_.on_state(state, now);
    if (!loop_.step(now, command_)) {
      ++unanswered_;
      return;
    }
    answers_.push_back({command_, loop_.status()});
    if (!answers_wait_) answer(now + 200'000);
  }
  void answer(std::int64_t now) {
    for (const Answer& answer : answers_) {
      for (auto& source : source_) {
        source->on_command(answer.command, now);
        source->on_controller_status(answer.status, now);
      }
    }
    answers_.clear();
  }
  void say_stops() {
    for (auto& source : source_) {
      const StopRequest stop = source->take_stop_to_publish(now_ + 400'000);
      if (stop.kind == StopKind::kNone) continue;
      loop_.on_stop(stop);
      for (auto& hearer : source_) hearer->on_stop(stop, now_ + 400'000);
    }
  }

  const Model& model_;
  std::array<std::unique_ptr<RobotAdaptor>, 2> body_;
  ControlLoop loop_;
  StateAdmission admission_;
  std::array<std::unique_ptr<Source>, 2> source_;
  std::array<Delay, 2> delay_{};
  std::vector<Answer> answers_;  // on their way
  StandInBody* own_clock_ = nullptr;
  int stalled_ = 0;
  bool late_ = false, answers_wait_ = false;
  JointCommand command_;
  std::int64_t now_ = 0, unanswered_ = 0;
  std::int32_t sequence_ = 0;
};

}  // namespace twinbus
