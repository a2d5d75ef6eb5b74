// `twinbus bench guard_drive`: the guard against random jerk-limited motions into self-collision.
//
// Each motion drives arms and waist of hrp1s at their rated speeds from half_sitting to a posture in
// which the robot hits itself, and back; servos, command gate and the way of a mask to it are those of
// the guard's tests.  Contacts are looked for every tenth of a millisecond by the exact check, which
// shares no code of distance with the guard.  A motion that does not come back was blocked on its way
// out of danger, unless the straight way from where it is held to half_sitting leads through what the
// guard must prevent: such a way is measured and counted apart.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "robot/collision/links/link_geometry.h"
#include "common/math/index.h"
#include "common/process/options.h"
#include "common/time/latency_histogram.h"
#include "robot/collision/exact/self_collision.h"
#include "test/bench/core_alone.h"
#include "test/collision/guard_rig.h"
#include "test/collision/rated_drive.h"
#include "common/allocation/no_alloc.h"

using namespace twinbus;

namespace {

constexpr int kParts = 20;         // looks per tick of 2 ms
constexpr double kFar = 0.05;      // nothing comes this far in a tick [m]
constexpr double kArrived = 0.02;  // [rad]
constexpr double kThrough =
    0.012;  // a way that leads nearer than this leads through the margin [m]
constexpr int kWayParts = 400;
constexpr std::int64_t kSlow_ns =
    40'000;  // a tick that is looked at again until the core is its own

class Driver {
 public:
  Driver(const Model& model, std::int64_t seed, int ticks)
      : model_(model),
        exact_(model, build_geometry(model)),
        distances_(model),
        kinematics_(model),
        drive_(model),
        seed_(seed),
        ticks_(ticks) {}

  // The number of a motion and the seed say all about it.
  // most: repeats while a slow tick never had the core alone.
  void motion(Guard& guard, std::int64_t number, int repeats, int most, bool tell) {
    const Configuration home = named_posture(model_, "half_sitting");
    const Configuration target = drive_.draw_target(exact_, home, seed_, number);
    std::vector<std::int64_t> least(at(2 * ticks_), INT64_MAX), alone = least;
    ++motions;
    const auto wants_more = [&] {
      for (std::size_t i = 0; i < least.size(); ++i) {
        if (least[i] > kSlow_ns && alone[i] == INT64_MAX) return true;
      }
      return false;
    };
    for (int repeat = 0; repeat < repeats || (repeat < most && wants_more()); ++repeat) {
      const bool first = repeat == 0;  // the others only time the same ticks again
      guard.reset();
      GuardRig rig(model_, home);
      drive_.start();
      bool masked = false, hit = false;
      Eigen::VectorXd before = home.q;
      for (int i = 0; i < 2 * ticks_; ++i) {
        const Configuration& aim = i < ticks_ ? target : home;
        drive_.follow(rig, aim);
        const bool alone_before = core_.alone();
        const NoAlloc no_alloc;
        masked = rig.tick(guard).hold_mask != 0 || masked;
        if (i > 0) allocations += no_alloc.count();
        if (alone_before && core_.alone()) alone[at(i)] = std::min(alone[at(i)], rig.check_ns);
        every.add(rig.check_ns);
        least[at(i)] = std::min(least[at(i)], rig.check_ns);
        if (!first) continue;
        const Eigen::VectorXd after = rig.configuration().q;
        const bool touched = look_between(guard, before, after);
        if (touched && !hit) std::printf("motion %lld touches in tick %d\n", as_long(number), i);
        hit = hit || touched;
        if (tell) story(rig, guard, i);
        before = after;
      }
      if (!first) continue;
      contacts += hit ? 1 : 0;
      held += masked ? 1 : 0;
      count_way_back(rig, guard, home, number);
    }
    for (std::size_t i = 0; i < least.size(); ++i) {
      tick.add(least[i]);
      if (alone[i] != INT64_MAX) {
        core_alone.add(alone[i]);
      } else if (least[i] > kSlow_ns) {
        ++never_alone;
      }
    }
  }

  RateStats every, tick;  // every look of the guard; the least of its repeats
  RateStats core_alone;   // the least of those repeats that had the core alone
  long never_alone = 0;   // slow ticks that had not
  long motions = 0, contacts = 0, held = 0, refused = 0, stuck = 0, looks = 0, allocations = 0;
  double nearest = 1.0;  // [m]

 private:
  static long long as_long(std::int64_t x) { return static_cast<long long>(x); }

  // Does anything touch between two ticks?
  bool look_between(const Guard& guard, const Eigen::VectorXd& before,
                    const Eigen::VectorXd& after) {
    nearest = std::min(nearest, guard.pair_count() > 0 ? guard.pairs()[0].distance : kFar);
    if (guard.pair_count() == 0 || guard.pairs()[0].distance > kFar || before == after)
      return false;
    bool touched = false;
    for (int part = 1; part <= kParts; ++part) {
      exact_.place(before + (after - before) * (static_cast<double>(part) / kParts));
      ++looks;
      touched = exact_.any_touching() || touched;
    }
    return touched;
  }

  void count_way_back(const GuardRig& rig, const Guard& guard, const Configuration& home,
                      std::int64_t number) {
    double left = 0.0;
    for (const std::size_t k : drive_.moved())
      left = std::max(left, std::abs(rig.state.q[k] - home.q[model_.bus_joints[k]]));
    if (left <= kArrived) return;
    const Configuration end = rig.configuration();
    Configuration on_way = end;
    double least = kFar;
    for (int part = 1; part <= kWayParts; ++part) {
      on_way.q = end.q + (home.q - end.q) * (static_cast<double>(part) / kWayParts);
      kinematics_.update(on_way);
      PairDistance pair;
      if (distances_.near_pairs(kinematics_, least, &pair, 1) > 0) least = pair.distance;
    }
    if (least < kThrough) {
      ++refused;
      return;
    }
    ++stuck;
    std::printf("motion %lld is stuck, %.3f rad away; the way back stays %.1f mm clear\n",
                as_long(number), left, 1e3 * least);
    story(rig, guard, 2 * ticks_);
  }

  void story(const GuardRig& rig, const Guard& guard, int i) const {
    std::printf("tick %d, held:", i);
    for (int k = 0; k < model_.bus_count(); ++k) {
      if ((guard.report().hold_mask & bit(k)) != 0)
        std::printf(" %s", model_.joints[at(model_.bus_joints[at(k)])].name.c_str());
    }
    std::printf("\n");
    for (int p = 0; p < std::min(guard.pair_count(), 3); ++p) {
      const PairDistance& pair = guard.pairs()[p];
      std::printf("  %s %s %.2f mm\n", model_.links[at(pair.link_a)].name.c_str(),
                  model_.links[at(pair.link_b)].name.c_str(), 1e3 * pair.distance);
    }
    for (const std::size_t k : drive_.moved()) {
      std::printf("  %s %.3f at %.2f, set %.3f at %.2f, asked %.3f\n",
                  model_.joints[at(model_.bus_joints[k])].name.c_str(), rig.state.q[k],
                  static_cast<double>(rig.state.qd[k]), rig.effective().q[k],
                  static_cast<double>(rig.effective().qd[k]), rig.command.q[k]);
    }
  }

  const Model& model_;
  test::CoreAlone core_;
  SelfCollision exact_;
  Collision distances_;
  Kinematics kinematics_;
  RatedDrive drive_;
  std::int64_t seed_;
  int ticks_;
};

void print(const char* name, const RateStats& stats) {
  std::printf("%s: median %.1f us, p99 %.1f us, p99.9 %.1f us, worst %.1f us\n", name,
              1e-3 * stats.median_ns(), 1e-3 * stats.p99_ns(), 1e-3 * stats.p999_ns(),
              1e-3 * static_cast<double>(stats.max_ns()));
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_drive_bench", "The guard against random motions into self-collision.");
  std::int64_t motions = 200, ticks = 500, seed = 1, first = 0, only = -1, repeats = 1, most = 0;
  options.integer("--motions", "N", motions, 1, 10'000'000, "into collision and back");
  options.integer("--first", "N", first, 0, 10'000'000, "number of the first motion");
  options.integer("--only", "N", only, -1, 10'000'000, "this motion alone, tick by tick");
  options.integer("--ticks", "N", ticks, 50, 100'000, "there, and as many back");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the targets");
  options.integer("--repeats", "N", repeats, 1, 100,
                  "of every motion: a tick costs the least of what it took");
  options.integer(
      "--until-alone", "N", most, 0, 10'000,
      "repeats of a motion, at most, until each of its ticks over 40 us had the core alone");
  options.parse(argc, argv);

  const Model& model = hrp1s();
  Driver driver(model, seed, static_cast<int>(ticks));
  Guard guard(model, {});
  const std::int64_t begin = only >= 0 ? only : first, end = only >= 0 ? only + 1 : first + motions;
  for (std::int64_t m = begin; m < end; ++m)
    driver.motion(guard, m, static_cast<int>(repeats), static_cast<int>(most), only >= 0);
  std::printf(
      "%ld motions: %ld with a contact in %ld looks, nearest %.2f mm; the guard held joints in "
      "%ld; %ld did not come back, %ld more have no way back; %lld stretches not proved; %ld "
      "allocations%s\n",
      driver.motions, driver.contacts, driver.looks, 1e3 * driver.nearest, driver.held,
      driver.stuck, driver.refused, static_cast<long long>(guard.unproved()), driver.allocations,
      allocations_counted() ? "" : " (not counted)");
  print("guard per tick", driver.every);
  if (repeats > 1 || most > 0) print("  least of the repeats of each tick", driver.tick);
  print("  least of those with the core alone", driver.core_alone);
  std::printf("  %ld ticks over 40 us never had the core alone\n", driver.never_alone);
  return driver.contacts == 0 && driver.stuck == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_drive_bench: %s\n", error.what());
  return 1;
}
