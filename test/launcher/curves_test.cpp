// Walking in curves with the guard on: the legs never come so near each other that it has to stop the robot.

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "launcher/run/local_stack.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"
#include "test/rounds.h"

namespace twinbus {
namespace {

// A pad whose sticks go anywhere every 1 to 4 s: fast forward, to the side and turning at once.
TEST(Curves, APadThatTurnsAsFastAsItCanIsNeverStoppedByTheGuard) {
  std::int64_t turned = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(std::uint64_t{3}); ++seed) {
    Scene scene = load_scene("walk_pad");
    ASSERT_FALSE(scene.pads.empty());
    const TimedPad held = scene.pads.front();
    scene.pads.clear();
    std::mt19937_64 random(seed);
    const auto draw = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
    for (double at = 1.5; at < 40.0; at += scene.pads.back().duration) {
      TimedPad pad = held;
      pad.at = at;
      pad.duration = draw(1.0, 4.0);
      pad.request.left_y = static_cast<float>(draw(-0.2, 0.8));
      pad.request.left_x = draw(0.0, 1.0) < 0.5 ? 0.0F : static_cast<float>(draw(-0.4, 0.4));
      pad.request.right_x = draw(0.0, 1.0) < 0.4 ? 0.0F : static_cast<float>(draw(-1.0, 1.0));
      turned += pad.request.right_x != 0.0F ? 1 : 0;
      scene.pads.push_back(pad);
    }
    const Model model = load_robot("hrp1s");
    resolve_poses(scene, model);
    apply_seed(scene, model, seed);
    OneProcessConfig config;
    config.seed = seed;
    OneProcess run(model, scene, config);
    while (static_cast<double>(run.ticks()) * model.period() < 40.0 && run.tick()) {
      ASSERT_FALSE(run.truth().fell) << seed;
      ASSERT_EQ(run.state().stop_kind, StopKind::kNone) << seed << ", tick " << run.ticks() << ": " << run.stop_cause();
    }
    EXPECT_EQ(run.loop().status().mode, Mode::kWalk);
  }
  EXPECT_GT(turned, static_cast<std::int64_t>(4 * test::rounds(std::uint64_t{3})));
}

}  // namespace
}  // namespace twinbus
