// A client with soft or stiff gains of its own that swings an arm into the body or the other arm, in the simulator and
// behind the real gate: what the guard is tried with beside motions of our own controller.
//
// The number of a swing and the seed say all about it: arm, posture in which the robot hits itself, gains from 5 to 3500, the
// way there (a step, a ramp, a swing to and fro), whether the robot stands or hangs, whether the client is faded in, and how
// late guard and gate hear of things.  A swing counts when the same without a guard touches, before the robot that stands falls
// by it: what the ground does to an arm is not what servos do.

#pragma once

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/gate/command_gate.h"
#include "common/math/index.h"
#include "control/guard/guard_watch.h"
#include "robot/collision/exact/self_collision.h"
#include "robot/collision/links/link_geometry.h"
#include "robot/dynamics/joint_inertia.h"
#include "sim/sim_adaptor.h"
#include "test/collision/postures.h"

namespace twinbus {

struct SoftSwing {
  bool stands = false, no_fade = false, late_command = false;
  int way = 0;  // 0 step, 1 ramp, 2 to and fro
  int guard_delay = 1;          // ticks until a mask reaches the gate
  double begins = 0.0;          // [s]
  double speed = 0.0;           // of a ramp [rad/s], of the swing to and fro [1/s]
  std::vector<std::size_t> moved;  // of the bus
  PerJoint<double> target{};
  PerJoint<float> kp{}, kd{};
};

struct SwingResult {
  bool touched = false, held = false;
  bool fell = false;         // which ended the swing
  double nearest = 1.0;      // that the guard saw [m]
  double touched_at = 0.0;   // [s]
  double stays = 0.0;        // speed of the fastest joint at the end [rad/s]
};

class SoftSwings {
 public:
  static constexpr double kLasts = 2.5;  // [s]
  static constexpr double kUpright = 0.8;  // cosine of the tilt

  SoftSwings(const Model& model, std::int64_t seed)
      : model_(model),
        exact_(model, build_geometry(model)),
        limits_(model),
        home_(named_posture(model, "half_sitting")),
        seed_(seed) {
    Kinematics kinematics(model);
    kinematics.update(home_);
    JointInertia inertia(model);
    for (std::size_t k = 0; k < at(model.bus_count()); ++k) {
      const int j = model.bus_joints[k];
      inertia.update(kinematics, std::span(&j, 1));
      inertia_[k] = inertia(0, 0);
    }
    exact_.place(home_.q);
    if (exact_.any_touching()) throw std::runtime_error("the robot touches itself where it starts");
  }

  // Draws until one hits without a guard.
  SoftSwing draw(std::int64_t number) {
    std::seed_seq seeds{seed_, number};
    std::mt19937_64 random(seeds);
    for (;;) {
      const SoftSwing swing = draw(random);
      ++drawn;
      if (run(swing, nullptr).touched) return swing;
    }
  }

  // guard: null for none.
  SwingResult run(const SoftSwing& swing, const GuardConfig* config) {
    Scene scene;
    scene.robot = model_.name;
    scene.fixed_base = !swing.stands;
    SimAdaptor sim(scene);
    if (sim.open(model_, {}) != Status::kOk) throw std::runtime_error("the simulator does not open");
    std::unique_ptr<GuardWatch> watch = config != nullptr ? std::make_unique<GuardWatch>(model_, *config) : nullptr;
    CommandGate gate(limits_, false, 1);
    std::array<GuardReport, 4> reports{};
    RobotState state;
    JointCommand command = client(swing);
    JointCommand before = command;
    SwingResult result;
    Configuration then(model_), now(model_);
    const auto ticks = static_cast<std::int64_t>(kLasts / model_.period());
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      if (sim.read(state, 0.0) != Status::kOk) throw std::runtime_error("the simulator stopped");
      state.tick = tick;
      state.run_id = 1;
      state.term = 1;
      state.model_hash = model_.hash;
      state.time_ns = tick * model_.period_ns;
      state.period_ns = model_.period_ns;
      state.joint_count = static_cast<std::int16_t>(model_.bus_count());
      const std::int64_t now_ns = tick * model_.period_ns;
      if (tick == 1) {
        gate.hold_measured(state);
        gate.open(1, 1, true, limits_.blend_s, now_ns);
      }
      gate.measured(state);
      say(swing, tick, command);
      now.q = sim.world()->configuration().q;
      if (swing.stands && sim.world()->configuration().base.linear()(2, 2) < kUpright) {
        result.fell = true;
        break;
      }
      if (watch != nullptr) {
        watch->on_command(swing.late_command && tick > 1 ? before : command);
        const std::int64_t begin = cpu_ns();
        const GuardReport report = watch->judge(state);
        costs.push_back(cpu_ns() - begin);
        reports[at(static_cast<int>(tick % 4))] = report;
        result.held = result.held || report.hold_mask != 0;
        if (report.pairs_near > 0) result.nearest = std::min(result.nearest, static_cast<double>(report.distance[0]));
        const GuardReport& heard = reports[at(static_cast<int>((tick + 4 - swing.guard_delay) % 4))];
        if (heard.tick > 0) gate.guard(heard, now_ns);
        if (tell) tell(tick, state, command, gate.effective(), report, watch->cause());
      }
      if (tick > 1 && touches_between(then.q, now.q)) {
        result.touched = true;
        result.touched_at = static_cast<double>(tick) * model_.period();
        break;
      }
      then.q = now.q;
      before = command;
      if (gate.accept(command, tick, false, now_ns) != GateVerdict::kAccepted) throw std::runtime_error("a command is refused");
      if (sim.write(gate.output(tick, false, now_ns)) != Status::kOk) throw std::runtime_error("the simulator refuses");
    }
    for (const std::size_t k : swing.moved) result.stays = std::max(result.stays, std::abs(static_cast<double>(state.qd[k])));
    return result;
  }

  std::vector<std::int64_t> costs;  // of every look of a guard, CPU [ns]
  long drawn = 0;
  void (*tell)(std::int64_t tick, const RobotState&, const JointCommand&, const JointCommand& effective, const GuardReport&,
               const GuardCause&) = nullptr;

 private:
  static constexpr int kParts = 4;  // looks of a tick

  static std::int64_t cpu_ns() {  // that this thread has had
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1'000'000'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
  }

  SoftSwing draw(std::mt19937_64& random) {
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto chance = [&](double share) { return between(0.0, 1.0) < share; };
    SoftSwing swing;
    swing.stands = chance(0.5);
    swing.no_fade = chance(0.5);
    swing.late_command = chance(0.5);
    swing.guard_delay = swing.late_command ? 1 : chance(0.5) ? 1 : 2;
    swing.way = static_cast<int>(between(0.0, 3.0));
    swing.begins = chance(0.3) ? 0.0 : between(0.0, 0.8);
    swing.speed = swing.way == 1 ? std::exp(between(std::log(0.2), std::log(12.0))) : between(0.3, 2.0);
    const bool both = chance(0.3);
    const std::size_t arm = chance(0.5) ? 0 : 1;
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
      for (std::size_t hand = 0; hand < 2; ++hand) {
        const std::vector<int>& joints = model_.hands[hand].joints;
        if ((both || hand == arm) && std::find(joints.begin(), joints.end(), model_.bus_joints[k]) != joints.end() &&
            std::find(model_.leg_joints.begin(), model_.leg_joints.end(), model_.bus_joints[k]) == model_.leg_joints.end())
          swing.moved.push_back(k);
      }
    }
    if (swing.moved.empty()) throw std::runtime_error("the robot has no arms");
    Configuration aim = home_;
    do {
      for (const std::size_t k : swing.moved) {
        const Joint& joint = model_.joints[at(model_.bus_joints[k])];
        aim.q[model_.bus_joints[k]] = between(std::max(joint.lower, -3.0), std::min(joint.upper, 3.0));
      }
      exact_.place(aim.q);
    } while (!exact_.any_touching());
    const double kp = std::exp(between(std::log(5.0), std::log(3500.0))), ratio = between(0.05, 1.2);
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
      const Joint& joint = model_.joints[at(model_.bus_joints[k])];
      swing.target[k] = aim.q[model_.bus_joints[k]];
      swing.kp[k] = static_cast<float>(joint.kp);
      swing.kd[k] = static_cast<float>(joint.kd);
    }
    for (const std::size_t k : swing.moved) {
      const double own = kp * between(0.5, 1.0);
      swing.kp[k] = static_cast<float>(own);
      swing.kd[k] = static_cast<float>(2.0 * ratio * std::sqrt(own * inertia_[k]));
    }
    return swing;
  }

  JointCommand client(const SoftSwing& swing) const {
    JointCommand command;
    command.run_id = command.term = 1;
    command.controller_id = 7;
    command.model_hash = model_.hash;
    command.joint_count = static_cast<std::int16_t>(model_.bus_count());
    command.flags = swing.no_fade ? kCommandNoFade : std::int16_t{0};
    command.kp = swing.kp;
    command.kd = swing.kd;
    return command;
  }

  void say(const SoftSwing& swing, std::int64_t tick, JointCommand& command) const {
    command.tick = tick;
    const double t = static_cast<double>(tick) * model_.period() - swing.begins;
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) command.q[k] = home_.q[model_.bus_joints[k]];
    for (const std::size_t k : swing.moved) {
      const double from = home_.q[model_.bus_joints[k]], way = swing.target[k] - from;
      double share = t > 0.0 ? 1.0 : 0.0;
      if (swing.way == 1) share = std::clamp(swing.speed * t / std::max(std::abs(way), 1e-6), 0.0, 1.0);
      if (swing.way == 2) share = t > 0.0 ? 0.5 * (1.0 - std::cos(2.0 * M_PI * swing.speed * t)) : 0.0;
      command.q[k] = from + share * way;
    }
  }

  bool touches_between(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    for (int part = 1; part <= kParts; ++part) {
      exact_.place(from + (to - from) * (static_cast<double>(part) / kParts));
      if (exact_.any_touching()) return true;
    }
    return false;
  }

  const Model& model_;
  SelfCollision exact_;
  GateLimits limits_;
  Configuration home_;
  PerJoint<double> inertia_{};
  std::int64_t seed_;
};

}  // namespace twinbus
