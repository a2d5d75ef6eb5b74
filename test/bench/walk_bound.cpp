// How hard a push the pendulum of a robot that walks on the spot could survive, at one phase of its gait.
//
//     walk_bound --phase P [--robot R]      P: share of two steps
//
// Prints a JSON object: when that phase is [s], the robot's mass [kg] and the link that is pushed, and the largest change of velocity
// [m/s] of the linear inverted pendulum (no angular momentum) forward, back, left and right, with the ZMP at the edge of the sole from
// the first instant of a push of D = 0.1 s on, steps as short and as far as this robot takes them, for ever.  With E = e^(omega T) of the
// shortest step T, longest step L, edge e and b the DCM measured from the foot, one axis is viable if, a time t before the foot can land,
//
//     b - e  <=  L E / (E - 1) e^(-omega t)                                           forward and back
//     b - e  <=  (W E - w) E / (E^2 - 1) e^(-omega t)   or   (W - w E) E / (E^2 - 1) e^(-omega t)
//
// sideways, where one foot steps out to W and the other no nearer than w, and the first of the two lands next.  A push that
// takes D moves b by (dv / omega) (1 - e^(-omega D)) / (omega D) as if at once.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "common/process/options.h"
#include "common/process/process.h"
#include "control/walk/walk.h"
#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

constexpr double kPushed = 3.0;  // [s] from the start, and up to two steps later
constexpr double kPush = 0.1;    // how long it lasts [s]
constexpr float kInAir = 0.02F;  // of the weight

class Spot {
 public:
  explicit Spot(const Model& model) : model_(model), rig_(model, Scene{}, {}, quick()) {
    (void)rig_.run(0.5);
    rig_.ask(Mode::kWalk);
    walk_.run_id = rig_.state().run_id;
    walk_.vx = 1e-4F;
    walk_.timeout = 0.1F;
  }
  // False: it fell.
  bool until(double time) {
    while (model_.period() * static_cast<double>(rig_.ticks()) < time) {
      if (rig_.ticks() % 10 == 0) {
        walk_.sequence = ++said_;
        rig_.loop().on_walk_command(walk_, rig_.state().time_ns);
      }
      if (!rig_.tick() || rig_.record().fell) return false;
      const float weight = static_cast<float>(kGravity * model_.total_mass());
      for (std::size_t f = 0; f < 2; ++f) {
        const bool in_air = rig_.truth().foot_force[f][2] < kInAir * weight;
        if (in_air && !in_air_[f]) lifted_ = rig_.ticks();
        if (!in_air && in_air_[f]) landed_ = static_cast<int>(f);
        in_air_[f] = in_air;
      }
    }
    return true;
  }
  // The foot that stands alone now, or will first.
  int support() const { return in_air_[0] ? 1 : in_air_[1] ? 0 : landed_; }
  double in_step() const {  // [s] since the other one lifted; none: both stand
    return in_air_[0] || in_air_[1] ? model_.period() * static_cast<double>(rig_.ticks() - lifted_)
                                    : 0.0;
  }
  const SimTruth& truth() const { return rig_.truth(); }

 private:
  static ControlConfig quick() {
    ControlConfig control;
    control.guard_in_loop = false;
    return control;
  }
  const Model& model_;
  SimRig rig_;
  WalkCommand walk_;
  std::int32_t said_ = 0;
  std::int64_t lifted_ = 0;
  int landed_ = 0;
  std::array<bool, 2> in_air_{};
};

int run(int argc, char** argv) {
  std::string robot = "hrp1s";
  double phase = 0.0;
  Options options("walk_bound", "The push that a walking robot's pendulum could survive.");
  options.text("--robot", "R", robot, "a name of config/robots, or a folder");
  options.number("--phase", "SHARE", phase, 0.0, 1.0, "of two steps");
  options.parse(argc, argv);
  const Model model = load_robot(robot);
  const Gait gait = gait_of(model, model.walking, 0.01);
  const double time = kPushed + 2.0 * gait.period() * phase;
  Spot spot(model);
  if (!spot.until(time)) throw std::runtime_error("the robot falls before the push");
  const double omega = std::sqrt(kGravity / gait.com_height);
  const auto foot = static_cast<std::size_t>(spot.support());
  const Sole& sole = model.soles[foot];
  const SimTruth& t = spot.truth();
  const auto dcm = [&](std::size_t axis) {
    return static_cast<double>(t.com[axis]) + static_cast<double>(t.com_velocity[axis]) / omega -
           static_cast<double>(t.foot_position[foot][axis]);
  };
  const double remains = std::max(0.0, gait.shortest_single - spot.in_step());
  const double late = std::exp(-omega * remains);
  const double e = std::exp(omega * gait.shortest_single);
  const double straight = e / (e - 1.0) * late;
  const double wide = gait.max_width, narrow = gait.min_width;
  const double outer = (wide * e - narrow) * e / (e * e - 1.0) * late;
  const double inner = std::max(0.0, (wide - narrow * e) * e / (e * e - 1.0) * late);
  const bool left_swings = foot == 1;
  const double gain = omega * omega * kPush / (1.0 - std::exp(-omega * kPush));
  std::printf(
      R"({"time_s": %.6f, "mass_kg": %.9g, "link": "%s", "forward": %.9g, "back": %.9g, "left": %.9g, "right": %.9g})"
      "\n",
      time, model.total_mass(), model.links.front().name.c_str(),
      gain * (sole.front + gait.max_forward * straight - dcm(0)),
      gain * (sole.back + gait.max_back * straight + dcm(0)),
      gain * (sole.left + (left_swings ? outer : inner) - dcm(1)),
      gain * (sole.right + (left_swings ? inner : outer) + dcm(1)));
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_bound", twinbus::run, argc, argv);
}
