// A walking robot is brought to rest, another source takes its place, and it walks on: simulator to robot and back.
//
//     walk_switch_bench [--engines] [--count N] [--speed V] [--robot R] [--seed N] [--guard] [--stand]
//         [--stall TICKS | --late TICKS] [--trace]
//
// N times each way with policy when-safe, asked at a random phase of the step.  Exit status 1 when a body fell, a switch
// was refused, a stop took more than 1.5 steps, a torque jumped by more than 5 % of its limit or a STATE had no answer.
// --stall: the machine stands still for so long, in every round at another tick about the switch; --late: only the new
// source does.  --engines: instead, from one simulator to
// another engine in mid-step and back (walk_switch_engines.h); with --stand it stands.  Robots on soles, or on four point feet.

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "control/walk/walk.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "lcmtypes/msg/refusal_text.h"
#include "test/bench/tilt.h"
#include "test/bench/two_sources.h"
#include "test/bench/walk_switch_engines.h"

namespace twinbus {
namespace {

constexpr float kOffGround = 0.003F;          // of a sole that stands no more [m]
constexpr double kStands = 0.25;              // [s] on both soles: no double support lasts so long
constexpr int kStallFrom = -5, kStallTo = 6;  // after the tick of the grant
constexpr int kStepTicks = 6;                 // after a switch in which torques are watched
constexpr double kTorqueStep = 0.05;          // that a switch may make, of the limit
constexpr std::int64_t kGiveUp_ns = 9'000'000'000;

struct Bench {
  Model model;
  int count = 50;
  double speed = 0.3;  // [m/s]
  unsigned seed = 1;
  int stall = 0;      // of the whole machine, at every tick about the switch in turn [ticks]
  bool late = false;  // only the new source is, so that the old one's next ticks come first
  bool guard = false, trace = false, engines = false, stand = false;
};

struct Tally {
  int switched = 0, late = 0, jumped = 0, walked_on = 0;
  double worst_steps = 0.0, sum_steps = 0.0, worst_wait = 0.0, worst_gap = 0.0, worst_torque = 0.0;
};

class Round {
 public:
  Round(const Bench& bench, std::mt19937& random)
      : bench_(bench), random_(random), step_time_(step_time_of(bench.model)) {
    ControlConfig control;
    control.guard_in_loop = bench.guard;
    Scene scene;
    rig_ = std::make_unique<TwoSources>(bench.model, scene, control,
                                        std::make_unique<StandInBody>(scene), AdaptorConfig{});
    run(1.5, false);
  }

  bool fallen() const { return fell_; }
  std::int64_t unanswered() const { return rig_->unanswered(); }
  double tilt() const { return tilt_; }
  double standby_tilt() const { return standby_tilt_; }

  // False: the walk, the stop or the switch failed.
  bool walk_and_switch(Tally& tally) {
    const int from = rig_->active();
    rig_->ask(Mode::kWalk);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * step_time_);
    const double begin = rig_->truth(from).base_position[0];
    const double begin_y = rig_->truth(from).base_position[1];
    run(2.5 + phase(random_), true);
    const double way = std::hypot(rig_->truth(from).base_position[0] - begin,
                                  rig_->truth(from).base_position[1] - begin_y);
    const bool walked = way > 0.4 * 2.5 * bench_.speed;
    if (fell_ || !walked) return say(from, "does not walk");
    ++tally.walked_on;
    const std::int64_t asked = rig_->now_ns();
    last_in_air_ = stood_ = asked;
    stands_since_ = 0;
    rig_->request(SourceAction::kSwitch, TwoSources::run_of(1 - from), SwitchPolicy::kWhenSafe);
    stall_at_ = kStallFrom + rounds_++ % (kStallTo - kStallFrom);
    stalls_left_ = bench_.stall;
    grant_tick_ = 0;
    torque_ = 0.0;
    while (rig_->active() == from && rig_->now_ns() - asked < kGiveUp_ns && !fell_) {
      stall_about_grant(from);
      last_ = rig_->source(1 - from).state();
      step(true);
      if (rig_->source(from).status().refusal != Refusal::kNone)
        return say(from, refusal_text(rig_->source(from).status().refusal));
    }
    if (fell_ || rig_->active() != 1 - from) return say(from, "no switch");
    const double steps = 1e-9 * static_cast<double>(stood_ - asked) / step_time_;
    const double all = 1e-9 * static_cast<double>(last_in_air_ - asked) / step_time_;
    const double wait = 1e-9 * static_cast<double>(rig_->now_ns() - asked);
    switched_ = rig_->source(1 - from).state().tick;
    watch_torque(1 - from);
    for (int i = 0; i < kStepTicks; ++i) {
      stall_about_grant(1 - from);
      step(true);
      watch_torque(1 - from);
    }
    tally.worst_torque = std::max(tally.worst_torque, torque_);
    tally.jumped += torque_ > kTorqueStep ? 1 : 0;
    if (bench_.trace) {
      std::printf(
          "%s: %.2f steps until it stands, %.2f until its feet are side by side, %.2f s to the "
          "switch, joint %d %.3f rad apart, stall at %d, torque step %.1f %% of joint %d at %d\n",
          from == 0 ? "simulator to robot" : "robot to simulator", steps, all, wait, widest_, gap_,
          stall_at_, 1e2 * torque_, torque_joint_, torque_at_);
    }
    ++tally.switched;
    tally.late += steps > 1.5 ? 1 : 0;
    tally.sum_steps += steps;
    tally.worst_steps = std::max(tally.worst_steps, steps);
    tally.worst_wait = std::max(tally.worst_wait, wait);
    tally.worst_gap = std::max(tally.worst_gap, gap_);
    run(1.0, false);
    return !fell_;
  }

 private:
  bool say(int from, const char* what) {
    std::printf("%s: %s%s (tilts %.1f and %.1f degrees, joints %.3f rad apart)\n",
                from == 0 ? "simulator to robot" : "robot to simulator", what,
                fell_ ? ", fell" : "", tilt_of(rig_->source(0).state()),
                tilt_of(rig_->source(1).state()), gap_);
    return false;
  }
  void run(double seconds, bool walking) {
    const auto n = static_cast<int>(std::lround(seconds / bench_.model.period()));
    for (int i = 0; i < n && !fell_; ++i) step(walking);
  }
  void step(bool walking) {
    if (walking && ++said_ % 10 == 0) rig_->want(bench_.speed, 0.0, 0.0);
    rig_->tick();
    const int active = rig_->active();
    if (active < 0) return;
    bool in_air = false;
    for (const auto& foot : rig_->truth(active).foot_position) in_air |= foot[2] > kOffGround;
    if (in_air) {
      if (stands_since_ == 0) stood_ = rig_->now_ns();
      last_in_air_ = rig_->now_ns();
    } else if (1e-9 * static_cast<double>(rig_->now_ns() - last_in_air_) > kStands) {
      stands_since_ = 1;
    }
    gap_ = 0.0;
    const RobotState &a = rig_->source(0).state(), &b = rig_->source(1).state();
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.joint_count); ++k) {
      if (std::abs(a.q[k] - b.q[k]) > gap_) widest_ = static_cast<int>(k);
      gap_ = std::max(gap_, std::abs(a.q[k] - b.q[k]));
    }
    for (int s = 0; s < 2; ++s) {
      const double tilt = tilt_of(rig_->source(s).state());
      double& most = s == active ? tilt_ : standby_tilt_;
      most = std::max(most, tilt);
      fell_ = fell_ || tilt > 20.0 || rig_->source(s).state().stop_kind > StopKind::kNone;
    }
  }

  // The machine stands still at another tick about the switch in every round.
  void stall_about_grant(int source) {
    const RobotState& state = rig_->source(source).state();
    if (state.grant_run_id != 0) grant_tick_ = state.grant_tick;
    if (stalls_left_ == 0 || grant_tick_ == 0 || state.tick - grant_tick_ != stall_at_) return;
    if (bench_.late) {
      rig_->slow(1 - source, stalls_left_);
    } else {
      rig_->stall(stalls_left_);
    }
    stalls_left_ = 0;
  }
  // Of one body, from tick to tick, as a share of the joint's limit.
  void watch_torque(int source) {
    const RobotState& state = rig_->source(source).state();
    if (state.tick == last_.tick) return;
    const Model& model = bench_.model;
    for (std::size_t k = 0; last_.tick > 0 && k < static_cast<std::size_t>(state.joint_count);
         ++k) {
      const double limit = model.joints[static_cast<std::size_t>(model.bus_joints[k])].effort;
      const double share = static_cast<double>(std::abs(state.tau[k] - last_.tau[k])) / limit;
      if (!(share > torque_)) continue;
      torque_ = share;
      torque_joint_ = static_cast<int>(k);
      torque_at_ = static_cast<int>(state.tick - switched_);
    }
    last_ = state;
  }

  const Bench& bench_;
  std::mt19937& random_;
  double step_time_;  // [s]
  std::unique_ptr<TwoSources> rig_;
  bool fell_ = false;
  int said_ = 0, stands_since_ = 0, widest_ = 0;
  std::int64_t last_in_air_ = 0, stood_ = 0;
  double gap_ = 0.0, tilt_ = 0.0, standby_tilt_ = 0.0;  // [rad], [degrees], [degrees]
  int rounds_ = 0, stall_at_ = 0, stalls_left_ = 0, torque_joint_ = 0, torque_at_ = 0;
  std::int64_t grant_tick_ = 0, switched_ = 0;
  double torque_ = 0.0;
  RobotState last_;
};

int run(int argc, char** argv) {
  Bench bench;
  std::string robot = "hrp1s";
  std::int64_t count = 50, seed = 1, stall = 0, new_only = 0;
  Options options("walk_switch_bench", "Switches of the source under a robot that walks.");
  options.flag("--engines", bench.engines, "between engines");
  options.flag("--stand", bench.stand, "of a robot that stands; with --engines");
  options.integer("--count", "N", count, 1, 1'000'000, "switches");
  options.number("--speed", "V", bench.speed, -2.0, 2.0, "[m/s]");
  options.text("--robot", "R", robot, "name or folder");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of when");
  options.flag("--guard", bench.guard, "with the guard in the loop");
  options.integer("--stall", "TICKS", stall, 0, 1000, "so long the machine stands still");
  options.integer("--late", "TICKS", new_only, 0, 1000, "so long only the new source does");
  options.flag("--trace", bench.trace, "prints each tick about a switch");
  options.parse(argc, argv);
  bench.count = static_cast<int>(count);
  bench.seed = static_cast<unsigned>(seed);
  bench.late = new_only > 0;
  bench.stall = static_cast<int>(std::max(stall, new_only));
  bench.model = load_robot(robot);
  if (bench.engines) return switch_engines(bench.model, {bench.count, bench.speed, bench.stand, bench.trace});
  std::mt19937 random(bench.seed);
  std::array<Tally, 2> tally;
  int failed = 0, falls = 0;
  std::int64_t unanswered = 0;
  double tilt = 0.0, standby_tilt = 0.0;
  std::unique_ptr<Round> round;
  for (int i = 0; i < 2 * bench.count; ++i) {
    if (round == nullptr) {
      round = std::make_unique<Round>(bench, random);
      if (i % 2 == 1) {  // so that both ways are tried as often
        Tally ignored;
        (void)round->walk_and_switch(ignored);
      }
    }
    if (round->walk_and_switch(tally[static_cast<std::size_t>(i % 2)])) {
      continue;
    }
    ++failed;
    falls += round->fallen() ? 1 : 0;
    unanswered += round->unanswered();
    tilt = std::max(tilt, round->tilt());
    standby_tilt = std::max(standby_tilt, round->standby_tilt());
    round.reset();
  }
  if (round != nullptr) {
    unanswered += round->unanswered();
    tilt = std::max(tilt, round->tilt());
    standby_tilt = std::max(standby_tilt, round->standby_tilt());
  }
  int late = 0;
  for (std::size_t way = 0; way < 2; ++way) {
    const Tally& t = tally[way];
    late += t.late + t.jumped;
    std::printf(
        "%s at %.2f m/s: %d of %d walked, stopped and switched; steps until it stands %.2f on "
        "average, %.2f at "
        "most (%d over 1.5), %.2f s to the switch at most, joints then up to %.3f rad apart, "
        "torque step %.1f %% of the "
        "limit at most\n",
        way == 0 ? "walking simulator to robot" : "walking robot to simulator", bench.speed,
        t.switched, bench.count, t.switched > 0 ? t.sum_steps / t.switched : 0.0, t.worst_steps,
        t.late, t.worst_wait, t.worst_gap, 1e2 * t.worst_torque);
  }
  std::printf(
      "%d falls, tilt %.1f degrees at most, of the standby %.1f; %lld states without an answer\n",
      falls, tilt, standby_tilt, static_cast<long long>(unanswered));
  return failed + late > 0 || unanswered > 0 ? 1 : 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_switch_bench", twinbus::run, argc, argv);
}
