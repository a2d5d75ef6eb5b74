#include "control/walk/walk_feet.h"

#include <gtest/gtest.h>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/pose_math.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kFeetDt = 0.002;

struct Moved {
  Eigen::Vector2d turned;  // of the left sole, by a measured moment that shifts the load to its edges [rad]
  double lifted = 0.0;     // of it, by a left foot that carries nothing more than the right one [m]
};

// In a tick after a robot with soles of `times` the stiffness stood still.
Moved moved_in_a_tick(double times) {
  Model model = test::hrp1s();
  for (Sole& sole : model.soles) sole.stiffness *= times;
  const double weight = model.total_mass() * kGravity;
  const Sole& sole = model.soles[0];
  WalkPattern pattern(gait_of(model, model.walking, 0.01), SwingGains{});
  std::array<Foothold, 2> places;
  for (int f = 0; f < 2; ++f) places[static_cast<std::size_t>(f)].position << 0.0, side_of(f) * 0.1;
  pattern.start(places);
  std::array<Eigen::Isometry3d, 2> soles{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
  std::array<FootLoad, 2> loads;
  for (FootLoad& load : loads) load.force = 0.5 * weight;
  WalkFeet feet(model, WalkFeetGains{});
  feet.start(pattern, soles, loads);
  const Eigen::Isometry3d before = feet.target()[0];
  auto measured = loads;
  measured[0].moment += weight * Eigen::Vector2d(0.5 * (sole.left + sole.right), 0.5 * (sole.front + sole.back));
  measured[0].force += weight;
  feet.update(pattern, loads, measured, {0.5, 0.5}, BaseError{}, kFeetDt);
  const Eigen::Isometry3d moved = before.inverse() * feet.target()[0];
  return {rotation_vector(moved.linear()).head<2>(), moved.translation().z()};
}

TEST(WalkFeet, ASoleTurnsToTheGroundAsFastHoweverStiffItIs) {
  const WalkFeetGains gains;
  const Moved soft = moved_in_a_tick(1.0), stiff = moved_in_a_tick(8.0);
  for (Eigen::Index k = 0; k < 2; ++k) {
    EXPECT_GT(stiff.turned[k], 0.95 * kFeetDt * gains.ankle * gains.least_bend);
    EXPECT_LE(stiff.turned[k], soft.turned[k] + 1e-6);
  }
  EXPECT_NEAR(stiff.lifted, 0.5 * kFeetDt * gains.force * gains.least_sink, 1e-6);
  EXPECT_NEAR(soft.lifted, stiff.lifted, 1e-5);
}

TEST(WalkFeet, ASofterSoleGivesWayFaster) { EXPECT_GT(moved_in_a_tick(0.25).turned.x(), 2.0 * moved_in_a_tick(8.0).turned.x()); }

}  // namespace
}  // namespace twinbus
