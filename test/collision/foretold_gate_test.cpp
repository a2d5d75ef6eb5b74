// The guard foretells the set-points that the gate writes: while a client is faded in, while joints are held, and while the
// gate gives them back with the speed that they have.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bridge/gate/command_gate.h"
#include "common/math/index.h"
#include "control/guard/servo_predictor.h"
#include "robot/description/load.h"
#include "test/collision/postures.h"

namespace twinbus {
namespace {

constexpr int kDelay = 2;  // from a look of the guard to the gate, as GuardConfig has it [ticks]

// A robot whose joints are where the gate puts them, and a client that moves all of its left arm.
class ForetoldGate : public testing::Test {
 protected:
  ForetoldGate() : model_(load_robot("hrp1s")), limits_(model_), home_(named_posture(model_, "half_sitting")) {}

  // The largest difference of a set-point [rad].  way: of the arm from where it began, at a time; held: whether the guard
  // wants it held then; late: the guard hears a command this many ticks after the gate.
  double apart(double seconds, const std::function<double(double)>& way, const std::function<bool(double)>& held,
               std::int16_t flags, std::size_t late = 0) {
    ServoPredictor predictor(model_, kDelay, 0.005);
    CommandGate gate(limits_, false, 1);
    Kinematics kinematics(model_);
    Configuration now = home_;
    RobotState state;
    state.run_id = state.term = 1;
    state.model_hash = model_.hash;
    state.period_ns = model_.period_ns;
    state.joint_count = static_cast<std::int16_t>(model_.bus_count());
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) state.q[k] = home_.q[model_.bus_joints[k]];
    JointCommand command;
    command.run_id = command.term = 1;
    command.controller_id = 7;
    command.model_hash = model_.hash;
    command.joint_count = state.joint_count;
    command.flags = flags;
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
      command.kp[k] = static_cast<float>(model_.joints[at(model_.bus_joints[k])].kp);
      command.kd[k] = static_cast<float>(model_.joints[at(model_.bus_joints[k])].kd);
    }
    gate.hold_measured(state);
    gate.open(1, 1, true, limits_.blend_s, 0);
    std::int64_t arm = 0;
    for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
      const std::vector<int>& joints = model_.hands[0].joints;
      if (std::find(joints.begin(), joints.end(), model_.bus_joints[k]) != joints.end()) arm |= std::int64_t{1} << k;
    }
    EXPECT_NE(arm, 0);
    std::vector<std::int64_t> looks(kDelay, 0);  // on their way, the newest first
    std::vector<JointCommand> said;
    double most = 0.0;
    const auto ticks = static_cast<std::int64_t>(seconds / model_.period());
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      const double t = static_cast<double>(tick) * model_.period();
      state.tick = command.tick = tick;
      state.time_ns = tick * model_.period_ns;
      for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
        command.q[k] = home_.q[model_.bus_joints[k]] + ((arm >> k & 1) != 0 ? way(t) : 0.0);
        command.qd[k] = static_cast<float>((arm >> k & 1) != 0 ? (way(t + 1e-5) - way(t - 1e-5)) / 2e-5 : 0.0);
        now.q[model_.bus_joints[k]] = state.q[k];
      }
      kinematics.update(now);
      said.push_back(command);
      predictor.follow(state, said[said.size() - 1 - std::min(late, said.size() - 1)], looks.front(), kinematics, now);
      GuardReport report;
      report.guard_id = report.run_id = 1;
      report.tick = tick;
      report.hold_mask = looks.back();
      gate.measured(state);
      gate.guard(report, state.time_ns);
      EXPECT_EQ(gate.accept(command, tick, false, state.time_ns), GateVerdict::kAccepted);
      const JointCommand& written = gate.output(tick, false, state.time_ns);
      for (std::size_t k = 0; k < at(model_.bus_count()); ++k) {
        most = std::max(most, std::abs(predictor.set_point(k) - written.q[k]));
        state.qd[k] = static_cast<float>((written.q[k] - state.q[k]) / model_.period());
        state.q[k] = written.q[k];
      }
      masked_ = masked_ || gate.masked() != 0;
      looks.insert(looks.begin(), held(t) ? arm : 0);
      looks.pop_back();
    }
    return most;
  }

  Model model_;
  GateLimits limits_;
  Configuration home_;
  bool masked_ = false;
};

double swing(double t) { return 0.25 * (1.0 - std::cos(2.0 * t)); }  // at most 0.5 rad/s

TEST_F(ForetoldGate, AClientThatMovesIsFadedIn) {
  EXPECT_LT(apart(1.0, [](double t) { return 0.2 + swing(t); }, [](double) { return false; }, 0), 1e-3);
}

TEST_F(ForetoldGate, ACommandThatTheGuardHearsLaterIsTakenToGoOn) {
  EXPECT_LT(apart(1.0, swing, [](double) { return false; }, kCommandNoFade, 1), 1e-4);
}

TEST_F(ForetoldGate, AJointThatIsHeldIsBraked) {
  EXPECT_LT(apart(1.0, swing, [](double t) { return t > 0.6; }, kCommandNoFade), 1e-3);
  EXPECT_TRUE(masked_);
}

TEST_F(ForetoldGate, AJointThatIsReleasedInItsBrakeFadesWithTheSpeedThatItHas) {
  EXPECT_LT(apart(1.2, swing, [](double t) { return t > 0.6 && t < 0.7; }, kCommandNoFade), 2e-3);
  EXPECT_TRUE(masked_);
}

}  // namespace
}  // namespace twinbus
