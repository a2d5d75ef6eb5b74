// `twinbus bench guard_drive`: the guard against random jerk-limited motions into self-collision.
//
// Each motion drives arms and waist of hrp1s at their rated speeds from half_sitting to a posture in
// which the robot hits itself, and back; servos, command gate and the way of a mask to it are those of
// the guard's tests.  Contacts are looked for every tenth of a millisecond by the exact check, which
// shares no code of distance with the guard.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "robot/geometry.h"
#include "robot/index.h"
#include "robot/options.h"
#include "robot/process.h"
#include "robot/rate_stats.h"
#include "robot/self_collision.h"
#include "test/collision/guard_rig.h"
#include "test/no_alloc.h"

using namespace twinbus;

namespace {

constexpr int kParts = 20;         // looks per tick of 2 ms
constexpr double kFar = 0.05;      // nothing comes this far in a tick [m]
constexpr double kPace = 30.0;     // of the follower: as fast as ratings allow [rad/s]
constexpr double kRamp = 0.05;     // to the rated speed [s]
constexpr double kArrived = 0.02;  // [rad]

class Driver {
 public:
  explicit Driver(const Model& model)
      : model_(model), exact_(model, build_geometry(model, {.balls = false})) {
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const std::string& name = model.joints[at(model.bus_joints[k])].name;
      if (name.find("ARM") != std::string::npos || name.find("WAIST") != std::string::npos ||
          name.find("CHEST") != std::string::npos)
        moved_.push_back(k);
    }
  }

  void motion(Guard& guard, std::mt19937_64& random, int ticks) {
    const Configuration home = named_posture(model_, "half_sitting");
    guard.reset();
    GuardRig rig(model_, home);
    Configuration target = home;
    do {
      for (const std::size_t k : moved_) {
        const Joint& joint = model_.joints[at(model_.bus_joints[k])];
        target.q[model_.bus_joints[k]] =
            std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
      }
      exact_.place(target.q);
    } while (!exact_.any_touching());
    PerJoint<double> v{}, a{};
    ++motions;
    bool masked_once = false, hit = false;
    Eigen::VectorXd before = home.q;
    for (int i = 0; i < 2 * ticks; ++i) {
      const Configuration& aim = i < ticks ? target : home;
      for (const std::size_t k : moved_) follow(rig, k, aim.q[model_.bus_joints[k]], v, a);
      const NoAlloc no_alloc;
      const bool masked = look(rig, guard);
      if (i > 0) allocations += no_alloc.count();
      masked_once = masked_once || masked;
      const Eigen::VectorXd after = rig.configuration().q;
      const bool near = guard.pair_count() > 0 && guard.pairs()[0].distance < kFar;
      nearest = std::min(nearest, guard.pair_count() > 0 ? guard.pairs()[0].distance : kFar);
      for (int part = 1; near && part <= kParts; ++part) {
        exact_.place(before + (after - before) * (static_cast<double>(part) / kParts));
        ++looks;
        hit = exact_.any_touching() || hit;
      }
      before = after;
    }
    contacts += hit ? 1 : 0;
    held += masked_once ? 1 : 0;
    double left = 0.0;
    for (const std::size_t k : moved_)
      left = std::max(left, std::abs(rig.state.q[k] - home.q[model_.bus_joints[k]]));
    stuck += left > kArrived ? 1 : 0;
  }

  RateStats tick;
  long motions = 0, contacts = 0, held = 0, stuck = 0, looks = 0, allocations = 0;
  double nearest = 1.0;  // [m]

 private:
  bool look(GuardRig& rig, Guard& guard) {
    const std::int64_t begin = monotonic_ns();
    const bool masked = rig.tick(guard).hold_mask != 0;
    tick.add(monotonic_ns() - begin);
    return masked;
  }
  // Third order, towards the aim, within the rated speed and what reaches it in kRamp.
  void follow(GuardRig& rig, std::size_t k, double aim, PerJoint<double>& v,
              PerJoint<double>& a) const {
    const Joint& joint = model_.joints[at(model_.bus_joints[k])];
    const double dt = model_.period(), most = joint.velocity / kRamp;
    const double jerk = kPace * kPace * kPace * (aim - rig.command.q[k]) -
                        3.0 * kPace * kPace * v[k] - 3.0 * kPace * a[k];
    const double limit = most / kRamp;
    a[k] = std::clamp(a[k] + std::clamp(jerk, -limit, limit) * dt, -most, most);
    v[k] = std::clamp(v[k] + a[k] * dt, -joint.velocity, joint.velocity);
    rig.command.q[k] = std::clamp(rig.command.q[k] + v[k] * dt, joint.lower, joint.upper);
  }

  const Model& model_;
  SelfCollision exact_;
  std::vector<std::size_t> moved_;
};

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_drive_bench", "The guard against random motions into self-collision.");
  std::int64_t motions = 200, ticks = 500, seed = 1;
  options.integer("--motions", "N", motions, 1, 10'000'000, "into collision and back");
  options.integer("--ticks", "N", ticks, 50, 100'000, "there, and as many back");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the targets");
  options.parse(argc, argv);

  const Model& model = hrp1s();
  Driver driver(model);
  Guard guard(model, {});
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  for (std::int64_t m = 0; m < motions; ++m) driver.motion(guard, random, static_cast<int>(ticks));
  std::printf(
      "%ld motions: %ld with a contact in %ld looks, nearest %.2f mm; the guard held joints in "
      "%ld; "
      "%ld did not come back; %ld allocations%s\n",
      driver.motions, driver.contacts, driver.looks, 1e3 * driver.nearest, driver.held,
      driver.stuck, driver.allocations, allocations_counted() ? "" : " (not counted)");
  std::printf("guard, gate and servos per tick: median %.1f us, p99 %.1f us, worst %.1f us\n",
              1e-3 * driver.tick.median_ns(), 1e-3 * driver.tick.p99_ns(),
              1e-3 * static_cast<double>(driver.tick.max_ns()));
  return driver.contacts == 0 && driver.stuck == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_drive_bench: %s\n", error.what());
  return 1;
}
