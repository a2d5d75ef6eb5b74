#include "test/bench/walk_switch_engines.h"

#include <cstdio>
#include <limits>

#include "control/point_feet/step_gait.h"
#include "control/walk/walk.h"
#include "test/bench/tilt.h"
#include "test/bench/two_sources.h"

namespace twinbus {
namespace {

constexpr double kMostShare = 1.5;  // of the accelerations of normal walking
constexpr double kSettle = 1.2;     // [s] of walking between two switches
constexpr double kNormal = 3.0;     // [s] of walking that is the measure
constexpr double kFallen = 20.0;    // [degrees]
constexpr int kWatchTicks = 6;       // after a switch in which torques and forces are watched
constexpr double kMostTorque = 0.05, kMostForce = 0.10;  // that a switch of a robot that stands may make, of a joint's limit, of the weight

// What comes late when the new source takes over, and by how many ticks.
struct Lateness {
  const char* name;
  enum { kNothing, kSlow, kStandbySleeps, kHolderSleeps } what;
  int ticks;
};
constexpr std::array<Lateness, 7> kLatenesses{
    {{"in time", Lateness::kNothing, 0},
     {"new source slow, after a STATE of the old", Lateness::kSlow, 1},
     {"new source slow, after two", Lateness::kSlow, 2},
     {"new source sleeps a tick", Lateness::kStandbySleeps, 1},
     {"new source sleeps two ticks", Lateness::kStandbySleeps, 2},
     {"old source sleeps a tick", Lateness::kHolderSleeps, 1},
     {"old source sleeps two ticks", Lateness::kHolderSleeps, 2}}};

AdaptorConfig other_engine() {
  return {{{"engine", "ode"}, {"model.mass_scale", "1.03"}, {"contact.stiffness_scale", "0.8"}}};
}

// Largest differences between the state that the new source publishes first and the one before.
struct Step {
  double q = 0.0, qd = 0.0, force = 0.0, gyro = 0.0, tilt = 0.0;
};

class EngineWalk {
 public:
  EngineWalk(const Model& model, const EngineSwitches& how)
      : model_(model),
        how_(how),
        rig_(model, Scene{}, ControlConfig{}, std::make_unique<SimAdaptor>(Scene{}),
             other_engine()) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(model.bus_count()); ++k) {
      for (int leg : model.leg_joints) is_leg_[k] |= model.bus_joints[k] == leg;
    }
    run(1.5, false);
    if (how.stands) return;
    rig_.ask(Mode::kWalk);
    run(3.0, true);
  }
  bool fell() const { return fell_; }
  std::int64_t unanswered() const { return rig_.unanswered(); }
  int active() const { return rig_.active(); }

  // Largest commanded acceleration of a leg joint in normal walking [rad/s^2].
  double normal() {
    fastest_ = 0.0;
    run(kNormal, true);
    return fastest_;
  }
  // Largest steps of torque and foot force of the body that took over, about the switch.
  double torque_step() const { return torque_step_; }
  double force_step() const { return force_step_; }
  // The largest one from the switch to 1.2 s after it; negative: no switch.
  double switch_at(double phase, const Lateness& late) {
    run(phase, true);
    torque_step_ = force_step_ = 0.0;
    const int from = rig_.active();
    rig_.request(SourceAction::kSwitch, TwoSources::run_of(1 - from), SwitchPolicy::kNow);
    fastest_ = 0.0;
    bool waits = true;
    std::int64_t last_tick = 0;
    for (int i = 0; i < 30 && !fell_; ++i) {
      const RobotState& old = rig_.source(from).state();
      if (waits && old.grant_tick != 0 && old.tick + 1 == old.grant_tick) {
        if (late.what == Lateness::kSlow) rig_.slow(1 - from, late.ticks);
        if (late.what == Lateness::kStandbySleeps) rig_.sleep(1 - from, late.ticks);
        if (late.what == Lateness::kHolderSleeps) rig_.sleep(from, late.ticks);
        waits = false;
      }
      before_ = rig_.source(1 - from).state();
      step(true);
      if (rig_.active() == 1 - from && last_tick == 0) last_tick = remember_step(from);
      if (last_tick != 0 && rig_.source(1 - from).state().tick < last_tick + kWatchTicks) watch_body(rig_.source(1 - from).state());
    }
    if (rig_.active() != 1 - from) return -1.0;
    run(kSettle, true);
    if (how_.trace) {
      std::printf(
          "%s, to %s after %.3f s: %8.0f rad/s^2 (joint %d, %.0f ms on), joints %.5f rad, %.3f "
          "rad/s, "
          "force %.0f N, gyro %.3f rad/s\n",
          late.name, from == 0 ? "ode" : "articulated", phase, fastest_, where_, when_, step_.q,
          step_.qd, step_.force, step_.gyro);
    }
    return fastest_;
  }

 private:
  void run(double seconds, bool walking) {
    const auto n = static_cast<int>(std::lround(seconds / model_.period()));
    for (int i = 0; i < n && !fell_; ++i) step(walking);
  }
  void step(bool walking) {
    if (walking && !how_.stands && ++said_ % 10 == 0) rig_.want(how_.speed, 0.0, 0.0);
    rig_.tick();
    const int active = rig_.active();
    if (active < 0) return;
    fell_ = fell_ || tilt_of(rig_.source(active).state()) > kFallen ||
            rig_.source(active).state().stop_kind > StopKind::kNone;
    const JointCommand& now = rig_.command();
    if (now.tick == last_.tick + 1) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(now.joint_count); ++k) {
        const double change =
            static_cast<double>(std::abs(now.qd[k] - last_.qd[k])) / model_.period();
        if (is_leg_[k] && change > fastest_) {
          fastest_ = change;
          where_ = static_cast<int>(k);
          when_ = 1e-6 * static_cast<double>(rig_.now_ns() - switched_ns_);
        }
      }
    }
    last_ = now;
  }
  // The old source goes on for a tick, so both bodies say what comes next.
  std::int64_t remember_step(int from) {
    switched_ns_ = rig_.now_ns();
    const RobotState &a = rig_.source(from).state(), &b = rig_.source(1 - from).state();
    step_ = {};
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.joint_count); ++k) {
      step_.q = std::max(step_.q, std::abs(a.q[k] - b.q[k]));
      step_.qd = std::max(step_.qd, static_cast<double>(std::abs(a.qd[k] - b.qd[k])));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      step_.gyro = std::max(step_.gyro, static_cast<double>(std::abs(a.gyro[i] - b.gyro[i])));
      for (std::size_t f = 0; f < 2; ++f)
        step_.force =
            std::max(step_.force, static_cast<double>(std::abs(a.wrench[f][i] - b.wrench[f][i])));
    }
    return b.tick;
  }

  // From one tick to the next.
  void watch_body(const RobotState& now) {
    if (now.tick != before_.tick + 1) return;
    for (std::size_t k = 0; k < static_cast<std::size_t>(now.joint_count); ++k) {
      const double limit = model_.joints[static_cast<std::size_t>(model_.bus_joints[k])].effort;
      torque_step_ = std::max(torque_step_, static_cast<double>(std::abs(now.tau[k] - before_.tau[k])) / limit);
    }
    for (std::size_t f = 0; f < kLimbs; ++f) {
      const double step = (Eigen::Vector3f(now.wrench[f].data()) - Eigen::Vector3f(before_.wrench[f].data())).cast<double>().norm();
      force_step_ = std::max(force_step_, step / (kGravity * model_.total_mass()));
    }
  }

  const Model& model_;
  const EngineSwitches& how_;
  TwoSources rig_;
  std::array<bool, kMaxJoints> is_leg_{};
  JointCommand last_;
  RobotState before_;
  Step step_;
  double torque_step_ = 0.0, force_step_ = 0.0;
  bool fell_ = false;
  int said_ = 0, where_ = 0;
  double fastest_ = 0.0, when_ = 0.0;
  std::int64_t switched_ns_ = 0;
};

}  // namespace

double step_time_of(const Model& model) {
  if (why_no_point_feet(model) == nullptr) return step_gait_of(model).step_time();
  return gait_of(model, model.walking, 0.01).period();
}

int switch_engines(const Model& model, const EngineSwitches& how) {
  const double step_time = step_time_of(model);
  int bad = 0;
  double normal = 0.0;
  {
    EngineWalk walk(model, how);
    if (!how.stands) normal = walk.normal();
  }
  if (!how.stands)
    std::printf("normal walking at %.2f m/s changes commanded velocities by up to %.0f rad/s^2\n",
                how.speed, normal);
  for (const Lateness& late : kLatenesses) {
    std::array<double, 2> most{};
    std::array<int, 2> done{};
    double torque = 0.0, force = 0.0;
    int falls = 0, over = 0, refused = 0;
    std::int64_t unanswered = 0;
    auto walk = std::make_unique<EngineWalk>(model, how);
    for (int i = 0; i < how.count; ++i) {
      const double phase = 2.0 * step_time * i / how.count;
      const int from = walk->active();
      const double change = walk->switch_at(phase, late);
      const auto way = static_cast<std::size_t>(from == 1 ? 1 : 0);
      ++done[way];
      most[way] = std::max(most[way], change);
      refused += change < 0.0 ? 1 : 0;
      torque = std::max(torque, walk->torque_step());
      force = std::max(force, walk->force_step());
      const bool jumps = walk->torque_step() > kMostTorque || walk->force_step() > kMostForce;
      over += (how.stands ? jumps : change > kMostShare * normal) ? 1 : 0;
      if (!walk->fell()) continue;
      ++falls;
      unanswered += walk->unanswered();
      walk = std::make_unique<EngineWalk>(model, how);
    }
    unanswered += walk->unanswered();
    if (how.stands)
      std::printf("%s: %d switches to ode, %d to articulated, steps of torque up to %.2f %% of the limit, of foot force %.2f %% of the weight; %d "
                  "over %.0f and %.0f %%, ",
                  late.name, done[0], done[1], 1e2 * torque, 1e2 * force, over, 1e2 * kMostTorque, 1e2 * kMostForce);
    else
      std::printf("%s: %d switches to ode, %.2f of normal walking at most; %d to articulated, %.2f at most; %d over %.1f, ",
                  late.name, done[0], most[0] / normal, done[1], most[1] / normal, over, kMostShare);
    std::printf("%d without a switch, %d falls, %lld states without an answer\n", refused, falls, static_cast<long long>(unanswered));
    bad += falls + over + refused + (unanswered > 0 ? 1 : 0);
  }
  return bad > 0 ? 1 : 0;
}

}  // namespace twinbus
