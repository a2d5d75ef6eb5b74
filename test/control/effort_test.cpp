// No joint ever exceeds its effort limit, whatever pushes and whatever is commanded, and a robot in either can still
// be stopped.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "bridge/source/source.h"
#include "control/loop/control_loop.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"
#include "test/activate.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kRounding = 1e-4;  // of the limit: torques travel as float
constexpr std::int64_t kRun = 1, kController = 2;

// The simulator behind source and gate, as in the product.
class Stack {
 public:
  explicit Stack(const Scene& scene)
      : sim_(scene), source_(model_, opened(), {.run_id = kRun, .pace = Pace::kFreeRun}) {
    test::activate(source_, kRun, model_.period_ns, now_ns_);
    watch();
  }
  const RobotState& state() const { return source_.state(); }
  const SourceStatus& status() const { return source_.status(); }
  void finish(const JointCommand& command) {
    source_.on_command(command, now_ns_);
    next();
  }
  void next() {
    source_.end_tick(now_ns_);
    now_ns_ += model_.period_ns;
    source_.begin_tick(now_ns_);
    watch();
  }
  void stop(StopKind kind) {
    StopRequest stop;
    stop.sender_id = 77;
    stop.sequence = ++sequence_;
    stop.kind = kind;
    source_.on_stop(stop, now_ns_);
  }
  double effort_share() const { return effort_share_; }
  int joints_at_their_limit() const { return saturated_; }
  double fastest() const {
    double most = 0.0;
    for (int k = 0; k < model_.bus_count(); ++k)
      most = std::max(most, std::abs(static_cast<double>(state().qd[static_cast<std::size_t>(k)])));
    return most;
  }

 private:
  SimAdaptor& opened() {
    if (sim_.open(model_, {}) != Status::kOk) throw std::runtime_error("not open");
    return sim_;
  }
  void watch() {
    for (std::size_t k = 0; k < static_cast<std::size_t>(model_.bus_count()); ++k) {
      const double effort = model_.joints[static_cast<std::size_t>(model_.bus_joints[k])].effort;
      const double share = std::abs(static_cast<double>(state().tau[k])) / effort;
      ASSERT_FALSE(std::isnan(share));
      effort_share_ = std::max(effort_share_, share);
      saturated_ += share > 0.99 ? 1 : 0;
    }
  }

  const Model& model_ = test::hrp1s();
  SimAdaptor sim_;
  Source source_;
  std::int64_t now_ns_ = 0;
  std::int32_t sequence_ = 0;
  double effort_share_ = 0.0;
  int saturated_ = 0;
};

JointCommand addressed(const RobotState& state) {
  JointCommand c;
  c.tick = state.tick;
  c.run_id = kRun;
  c.term = state.term;
  c.model_hash = state.model_hash;
  c.controller_id = kController;
  c.joint_count = state.joint_count;
  return c;
}

Scene pushed(double x, double y) {
  Scene scene;
  scene.name = "pushed";
  Push push;
  push.link = "CHEST";
  push.impulse = {x, y, 0.0};
  push.at = 0.2;
  push.duration = 0.1;
  scene.pushes.push_back(push);
  return scene;
}

// Far more than a robot can stand: it falls on its face, on its back and on its side.
TEST(Effort, APushedRobotStaysWithinItsTorquesFallingOrNot) {
  for (const auto& [x, y] : {std::pair(40.0, 0.0), std::pair(150.0, 0.0), std::pair(-150.0, 40.0),
                             std::pair(0.0, 150.0)}) {
    Stack stack(pushed(x, y));
    ControlConfig config;
    config.controller_id = kController;
    ControlLoop loop(test::hrp1s(), config);
    JointCommand command;
    for (int n = 0; n < 700; ++n) {
      loop.on_state(stack.state(), stack.state().time_ns);
      if (loop.step(stack.state().time_ns, command)) {
        stack.finish(command);
      } else {
        stack.next();
      }
    }
    EXPECT_LE(stack.effort_share(), 1.0 + kRounding) << x << " " << y;
  }
}

class Wild : public ::testing::TestWithParam<int> {};

// A client that means harm: any position, velocity, torque and gain, a new one every tick or held for a while.
TEST_P(Wild, CommandsNeverGetMoreThanTheLimitAndAStopStillStops) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Stack stack(pushed(20.0, 0.0));
  JointCommand command = addressed(stack.state());
  const int hold = GetParam() % 2 == 0 ? 1 : 25;  // ticks
  for (int n = 0; n < 300; ++n) {
    if (n % hold == 0) {
      for (std::size_t k = 0; k < 29; ++k) {
        command.q[k] = 10.0 * any(random);
        command.qd[k] = static_cast<float>(100.0 * any(random));
        command.tau[k] = static_cast<float>(1e5 * any(random));
        command.kp[k] = static_cast<float>(1e6 * std::abs(any(random)));
        command.kd[k] = static_cast<float>(1e5 * std::abs(any(random)));
      }
    }
    command.tick = stack.state().tick;
    stack.finish(command);
  }
  EXPECT_LE(stack.effort_share(), 1.0 + kRounding) << "seed " << GetParam();
  EXPECT_GT(stack.joints_at_their_limit(), 0)
      << "the commands were not wild enough to test anything";
  EXPECT_GT(stack.status().commands_accepted, 250);

  stack.stop(GetParam() % 2 == 0 ? StopKind::kHold : StopKind::kOff);
  const std::int64_t accepted = stack.status().commands_accepted;
  // A robot that lies is let go of, whatever was asked: its limbs swing out.
  for (int n = 0; n < 1250; ++n) {
    command.tick = stack.state().tick;
    stack.finish(command);  // it goes on commanding
  }
  EXPECT_EQ(stack.state().role, Role::kStopped);
  EXPECT_EQ(stack.status().commands_accepted, accepted) << "nothing is obeyed after a stop";
  EXPECT_LT(stack.fastest(), 1.0) << "seed " << GetParam();
  EXPECT_LE(stack.effort_share(), 1.0 + kRounding);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Wild, ::testing::Range(1, 5));

}  // namespace
}  // namespace twinbus
