// A robot of servos behind the real command gate, which hears of a mask two ticks late: enough to
// test the guard.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bridge/gate/command_gate.h"
#include "control/guard/guard.h"
#include "common/process/process.h"
#include "test/collision/postures.h"

namespace twinbus {

class GuardRig {
 public:
  static constexpr std::size_t kDelay = 2;  // ticks until a mask reaches the gate
  static constexpr double kServo = 80.0;    // natural frequency of the servos [rad/s]

  GuardRig(const Model& model, const Configuration& start)
      : model_(model), limits_(model), gate_(limits_, false, 1) {
    state.joint_count = command.joint_count = static_cast<std::int16_t>(model.bus_count());
    state.run_id = command.run_id = 1;
    command.term = 1;
    command.controller_id = 1;
    command.model_hash = model.hash;
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      state.q[k] = command.q[k] = last_[k] = start.q[model.bus_joints[k]];
      command.kp[k] = static_cast<float>(joint.kp);
      command.kd[k] = static_cast<float>(joint.kd);
    }
    base = Configuration(model);
    base.base = start.base;
    gate_.hold_measured(state);
    gate_.open(1, 1, true, 0.0, 0);
  }

  // One tick with command.q as it stands: the guard looks, the gate obeys an older look.
  const GuardReport& tick(Guard& guard) {
    const std::int64_t begin = monotonic_ns();
    const GuardReport& report = look(guard);
    check_ns = monotonic_ns() - begin;
    go_on(report);
    return report;
  }
  // Both parts of it by themselves.
  const GuardReport& look(Guard& guard) {
    ++state.tick;
    say_speeds();
    return guard.check(state, &command, base);
  }
  void go_on(const GuardReport& report) { move(report); }

  // The same when the guard looks no more: this is what it said.
  void tick(GuardReport report) {
    report.tick = ++state.tick;
    say_speeds();
    move(report);
  }

  Configuration configuration() const {
    Configuration now = base;
    set_joints(model_, state, now);
    return now;
  }

  const JointCommand& effective() const { return gate_.effective(); }

  RobotState state;
  JointCommand command;
  Configuration base;
  GateVerdict accepted = GateVerdict::kClosed;
  std::int64_t check_ns = 0;  // what the last look of the guard took

 private:
  void say_speeds() {
    const double dt = model_.period();
    for (std::size_t k = 0; k < model_.bus_joints.size(); ++k) {
      const double speed = (command.q[k] - last_[k]) / dt;
      last_[k] = command.q[k];
      // A step has no velocity to speak of.
      const bool step =
          std::abs(speed) >
          1.001 * model_.joints[static_cast<std::size_t>(model_.bus_joints[k])].velocity;
      command.qd[k] = step ? 0.0F : static_cast<float>(speed);
    }
    command.tick = state.tick;
  }

  void move(const GuardReport& report) {
    const std::int64_t now_ns = state.tick * model_.period_ns;
    const double dt = model_.period();
    reports_[static_cast<std::size_t>(state.tick) % reports_.size()] = report;
    const GuardReport& late = reports_[static_cast<std::size_t>(state.tick + 1) % reports_.size()];
    if (late.tick > 0) gate_.guard(late, now_ns);
    gate_.measured(state);
    accepted = gate_.accept(command, state.tick, false, now_ns);
    const JointCommand& effective = gate_.output(state.tick, false, now_ns);
    for (std::size_t k = 0; k < model_.bus_joints.size(); ++k) {
      double qd = static_cast<double>(state.qd[k]);
      for (int i = 0; i < 4; ++i) {  // critically damped
        qd += 0.25 * dt *
              (kServo * kServo * (effective.q[k] - state.q[k]) +
               2.0 * kServo * (static_cast<double>(effective.qd[k]) - qd));
        state.q[k] += 0.25 * dt * qd;
      }
      state.qd[k] = static_cast<float>(qd);
    }
  }

  const Model& model_;
  GateLimits limits_;
  CommandGate gate_;
  PerJoint<double> last_{};
  std::array<GuardReport, kDelay + 1> reports_{};
};

}  // namespace twinbus
