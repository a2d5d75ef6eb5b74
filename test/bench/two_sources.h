// Two sources and one controller tick by tick in one process: a simulator, and a stand-in robot that cannot be set.
//
// Everything of the product but the bus and the clock: Source, gate, handover, admission, control loop.  The clock is
// counted, so a run is the same on any machine.  The standby's tick comes a little before STATE, as in real time.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "bridge/source.h"
#include "control/control_loop.h"
#include "robot/state_admission.h"
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
  Status read(RobotState& state, double timeout_s) override { return body_.read(state, timeout_s); }
  Status write(const JointCommand& command) override { return body_.write(command); }
  void close() override { body_.close(); }
  const SimTruth* truth() const override { return body_.truth(); }

 private:
  SimAdaptor body_;
};

class TwoSources {
 public:
  static constexpr std::int64_t kSimulator = 1, kRobot = 2, kOperator = 11;

  TwoSources(const Model& model, const Scene& scene, const ControlConfig& control,
             const AdaptorConfig& robot_settings)
      : model_(model), simulated_(scene), stand_in_(scene), loop_(model, control) {
    if (simulated_.open(model, {}) != Status::kOk ||
        stand_in_.open(model, robot_settings) != Status::kOk)
      throw std::runtime_error("a body does not open");
    source_[0] = std::make_unique<Source>(
        model, simulated_, SourceConfig{.run_id = kSimulator, .kind = SourceKind::kSimulator});
    source_[1] = std::make_unique<Source>(
        model, stand_in_, SourceConfig{.run_id = kRobot, .kind = SourceKind::kBridge});
    while (now_ < 1'100'000'000) tick();
    request(SourceAction::kActivate, kSimulator, SwitchPolicy::kNow);
    for (int i = 0; i < 5; ++i) tick();
    request(SourceAction::kStandbyShadow, kRobot, SwitchPolicy::kNow);
  }

  void tick() {
    now_ += model_.period_ns;
    const std::size_t first = source_[0]->publishes_on_state() ? 1 : 0;  // the standby
    begin(first, now_ - 300'000);
    begin(1 - first, now_);
    for (std::size_t s : {first, 1 - first}) source_[s]->end_tick(now_ + 400'000);
    say_stops();
  }

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
    return index == 0 ? *simulated_.truth() : *stand_in_.truth();
  }
  const ControlLoop& loop() const { return loop_; }
  std::int64_t now_ns() const { return now_; }
  std::int64_t unanswered() const { return unanswered_; }  // STATEs without a COMMAND

 private:
  void begin(std::size_t s, std::int64_t now) {
    Source& own = *source_[s];
    Source& other = *source_[1 - s];
    own.begin_tick(now);
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
    JointCommand command;
    if (!loop_.step(now, command)) {
      ++unanswered_;
      return;
    }
    const std::int64_t answered = now + 200'000;
    for (auto& source : source_) {
      source->on_command(command, answered);
      source->on_controller_status(loop_.status(), answered);
    }
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
  SimAdaptor simulated_;
  StandInBody stand_in_;
  ControlLoop loop_;
  StateAdmission admission_;
  std::array<std::unique_ptr<Source>, 2> source_;
  std::int64_t now_ = 0, unanswered_ = 0;
  std::int32_t sequence_ = 0;
};

}  // namespace twinbus
