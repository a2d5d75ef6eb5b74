// How hard a push a robot that walks on the spot survives, by direction and phase, beside what its pendulum could.
//
//     walk_map_bench [--robot R] [--directions N] [--phases N] [--halvings N]
//
// Prints CSV.  survived: largest change of velocity over a push of D = 0.1 s found by halving.  bound: of the linear
// inverted pendulum (no angular momentum) with the ZMP at the edge of the sole from the first instant of the push on, steps
// as short and as far as this robot takes them, for ever.  With E = e^(omega T) of the shortest step T, longest step L, edge
// e and b the DCM measured from the foot, one axis is viable if, a time t before the foot can land,
//
//     b - e  <=  L E / (E - 1) e^(-omega t)                                           forward and back
//     b - e  <=  (W E - w) E / (E^2 - 1) e^(-omega t)   or   (W - w E) E / (E^2 - 1) e^(-omega t)
//
// sideways, where one foot steps out to W and the other no nearer than w, and the first of the two lands next.  A push that
// takes D moves b by (dv / omega) (1 - e^(-omega D)) / (omega D) as if at once.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "control/walk/walk.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "common/process/process.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

constexpr double kPushed = 3.0;   // [s] from the start, and up to two steps later
constexpr double kWatched = 3.5;  // [s] after the push
constexpr double kPush = 0.1;     // how long it lasts [s]
constexpr double kHardest = 1.6;  // [m/s]
constexpr float kInAir = 0.02F;   // of the weight
constexpr double kPi = 3.14159265358979323846;

class Spot {
 public:
  Spot(const Model& model, const Scene& scene) : model_(model), rig_(model, scene, {}, quick()) {
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

// Largest viable change of velocity along +-x and +-y at a moment of walking on the spot [m/s].
struct Bounds {
  double forward, back, left, right;
  double along(double x, double y) const {
    const double of_x = x > 0.0 ? forward : back, of_y = y > 0.0 ? left : right;
    const double by_x = std::abs(x) > 1e-9 ? of_x / std::abs(x) : kHardest * 10.0;
    const double by_y = std::abs(y) > 1e-9 ? of_y / std::abs(y) : kHardest * 10.0;
    return std::min(by_x, by_y);
  }
};

Bounds bounds_at(const Model& model, const Gait& gait, double time) {
  Spot spot(model, Scene{});
  (void)spot.until(time);
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
  const double spread = omega * kPush / (1.0 - std::exp(-omega * kPush));
  const double gain = omega * spread;
  return {.forward = gain * (sole.front + gait.max_forward * straight - dcm(0)),
          .back = gain * (sole.back + gait.max_back * straight + dcm(0)),
          .left = gain * (sole.left + (left_swings ? outer : inner) - dcm(1)),
          .right = gain * (sole.right + (left_swings ? inner : outer) + dcm(1))};
}

bool survives(const Model& model, double time, double dvx, double dvy) {
  Scene scene;
  Push push;
  push.link = model.links.front().name;
  push.impulse = model.total_mass() * Eigen::Vector3d(dvx, dvy, 0.0);
  push.at = time;
  push.duration = kPush;
  scene.pushes.push_back(push);
  return Spot(model, scene).until(time + kWatched);
}

int run(int argc, char** argv) {
  std::string robot = "hrp1s";
  int directions = 8, phases = 6, halvings = 5;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--robot" && has_value) {
      robot = argv[++i];
    } else if (word == "--directions" && has_value) {
      directions = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--phases" && has_value) {
      phases = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--halvings" && has_value) {
      halvings = std::clamp(std::atoi(argv[++i]), 1, 12);
    } else {
      std::fprintf(stderr,
                   "walk_map_bench [--robot R] [--directions N] [--phases N] [--halvings N]\n");
      return word == "--help" ? 0 : 2;
    }
  }
  const Model model = load_robot(robot);
  const Gait gait = gait_of(model, walking_of(model), 0.01);
  std::printf("direction_deg,phase,survived,bound\n");
  for (int p = 0; p < phases; ++p) {
    const double phase = static_cast<double>(p) / phases;
    const double time = kPushed + 2.0 * gait.period() * phase;
    const Bounds bounds = bounds_at(model, gait, time);
    for (int d = 0; d < directions; ++d) {
      const double angle = 2.0 * kPi * d / directions;
      const double x = std::cos(angle), y = std::sin(angle);
      double held = 0.0, fell = kHardest;
      for (int i = 0; i < halvings; ++i) {
        const double dv = 0.5 * (held + fell);
        (survives(model, time, dv * x, dv * y) ? held : fell) = dv;
      }
      std::printf("%.0f,%.3f,%.3f,%.3f\n", 360.0 * d / directions, phase, held, bounds.along(x, y));
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("walk_map_bench", twinbus::run, argc, argv);
}
