// What stop plans cost: in the controller that makes them and in the source, while it keeps them ready and while it follows one.
//
//   stop_plan_bench [SCENE] [RUNS]      e.g. stop_plan_bench walk_rough 8
//
// A controller is killed at another instant of each run.  The controller's legs, the planner and the gate are computed again
// beside the run, from its states, so that each can be timed alone.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "bridge/gate/command_gate.h"
#include "control/loop/modes.h"
#include "launcher/run/local_stack.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"

using namespace twinbus;

namespace {

constexpr double kFirstKill = 4.0, kBetween = 0.17, kLed = 1.9;  // [s]

// Of this thread: what else the machine does does not count.
double cpu_us() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}
// What looking at that clock costs.
double clock_us() {
  static const double cost = [] {
    std::vector<double> all(2001);
    for (double& x : all) {
      const double begin = cpu_us();
      x = cpu_us() - begin;
    }
    std::nth_element(all.begin(), all.begin() + 1000, all.end());
    return all[1000];
  }();
  return cost;
}

struct Times {
  std::vector<double> us;
  template <class Work>
  void measure(Work&& work) {
    const double begin = cpu_us();
    work();
    us.push_back(cpu_us() - begin - clock_us());
  }
  double part(double share) {
    if (us.empty()) return 0.0;
    const auto nth = us.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(us.size() - 1));
    std::nth_element(us.begin(), nth, us.end());
    return *nth;
  }
  double mean() const {
    double sum = 0.0;
    for (const double x : us) sum += x;
    return us.empty() ? 0.0 : sum / static_cast<double>(us.size());
  }
};

struct Costs {
  Times plan, piece, accept, obeys, estimate, follows;
};

// The walk of a scene computed beside its run.
class Beside {
 public:
  explicit Beside(const Model& model)
      : model_(model),
        estimator_(model),
        modes_(model, BalanceGains{}, WalkGains{}),
        planner_(model, modes_.any_walk(), 1),
        limits_(model),
        gate_(limits_, false, 1) {}

  // Of the state that has just been answered.
  void tick(const OneProcess& run, double time, double speed, Costs& costs) {
    const RobotState& state = run.state();
    const std::int64_t now_ns = state.time_ns + 1;
    const bool first = !begun_;
    if (first) {
      begun_ = true;
      gate_.hold_measured(state);
      gate_.open(state.run_id, state.term, true, 0.0, now_ns);
    }
    costs.estimate.measure([&] { estimator_.update(state); });
    const bool led = state.plan_number != 0;
    if (!led) {
      const Moment moment{state, estimator_, first ? nullptr : &last_};
      if (first) modes_.start(Mode::kBalance, moment);
      if (time > 0.5 && modes_.mode() == Mode::kBalance) {
        ModeRequest walk;
        walk.mode = Mode::kWalk;
        modes_.obey(walk, moment);
      }
      modes_.walk({time > 1.0 ? speed : 0.0, 0.0, 0.0});
      modes_.want(moment, 0, model_.period(), last_);
      fill(state);
      const bool walks = modes_.walk() != nullptr && time > 2.0;
      Times unused;
      (walks ? costs.plan : unused).measure([&] { planner_.advance(modes_.motion(command_)); });
      costs.accept.measure([&] { (void)gate_.accept(command_, state.tick, false, now_ns); });
      for (StopPlanPiece piece; planner_.take(piece);) costs.piece.measure([&] { gate_.add_plan(piece, state.tick); });
    }
    (led ? costs.follows : costs.obeys).measure([&] { (void)gate_.output(state.tick, true, now_ns, &estimator_); });
  }
  bool follows() const { return gate_.counters().plans_followed > 0; }
  const char* refusal() const { return to_text(gate_.plan_refusal()); }

 private:
  void fill(const RobotState& state) {
    command_.tick = state.tick;
    command_.run_id = state.run_id;
    command_.model_hash = state.model_hash;
    command_.controller_id = 5;
    command_.term = state.term;
    command_.joint_count = state.joint_count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(state.joint_count); ++k) {
      command_.q[k] = last_.q[k];
      command_.qd[k] = static_cast<float>(last_.qd[k]);
      command_.tau[k] = static_cast<float>(last_.tau[k]);
      command_.kp[k] = static_cast<float>(last_.kp[k]);
      command_.kd[k] = static_cast<float>(last_.kd[k]);
    }
  }

  const Model& model_;
  Estimator estimator_;
  Modes modes_;
  StopPlanner planner_;
  GateLimits limits_;
  CommandGate gate_;
  SetPoint last_;
  JointCommand command_;
  bool begun_ = false;
};

void print(const char* what, Times& times) {
  std::printf("%-46s %8zu ticks, median %6.2f us, mean %6.2f, p99 %6.2f\n", what, times.us.size(), times.part(0.5), times.mean(),
              times.part(0.99));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "walk_forward";
  const int runs = argc > 2 ? std::atoi(argv[2]) : 6;
  Costs costs;
  int followed = 0;
  for (int r = 0; r < runs; ++r) {
    Scene scene = load_scene(name);
    const Model model = load_robot("hrp1s");
    resolve_poses(scene, model);
    const double speed = scene.walks.empty() ? 0.3 : static_cast<double>(scene.walks.front().request.vx);
    OneProcess run(model, scene, {});
    Beside beside(model);
    const double kill = kFirstKill + kBetween * r;
    bool killed = false;
    for (double t = 0.0; t < kill + kLed && run.tick(); t += model.period()) {
      beside.tick(run, t, speed, costs);
      if (t > kill && !killed) {
        run.stall_controller(-1.0);
        killed = true;
      }
    }
    followed += beside.follows();
    if (!beside.follows()) std::printf("not followed, the last refused: %s\n", beside.refusal());
  }
  std::printf("%s, %d controllers killed, %d plans followed beside\n", name.c_str(), runs, followed);
  print("controller: making of plans, a tick of walking", costs.plan);
  print("source: a piece that comes", costs.piece);
  print("gate: a command that comes", costs.accept);
  print("gate: output while commands come", costs.obeys);
  print("gate: output while a plan is followed", costs.follows);
  print("source: estimate for the plan", costs.estimate);
  std::printf("source while it follows, more than otherwise: %.2f us in the median\n",
              costs.estimate.part(0.5) + costs.follows.part(0.5) - costs.obeys.part(0.5) - costs.accept.part(0.5));
  return followed == runs ? 0 : 1;
}
