#include "launcher/up/robot_script.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <type_traits>

#include "sim/scene/scene.h"
#include "sim/scene/scene_requests.h"

namespace twinbus {
namespace {

// Requests said while the launcher hears every tenth STATE of a robot, by type.
struct Said {
  std::multiset<std::int64_t> modes, goals, walks, pads, steps;  // ticks at which they were heard
  std::set<std::int32_t> sequences;
  std::set<std::int64_t> runs;
  std::int64_t at_tick = 0;
};

Said play(const SceneRequests& requests, double seconds, RobotScript& script, std::int64_t run_id = 7) {
  constexpr std::int64_t kFirst = 1000;
  script.begin(requests, 0.002, kFirst);
  Said said;
  RobotState state;
  state.run_id = run_id;
  for (state.tick = kFirst; state.tick < kFirst + static_cast<std::int64_t>(500 * seconds); state.tick += 10) {
    script.hear(state, [&](const auto& request) {
      using T = std::decay_t<decltype(request)>;
      said.sequences.insert(request.sequence);
      said.runs.insert(request.run_id);
      if constexpr (std::is_same_v<T, ModeRequest>) said.modes.insert(state.tick), said.at_tick = request.at_tick;
      if constexpr (std::is_same_v<T, ArmGoal>) said.goals.insert(state.tick);
      if constexpr (std::is_same_v<T, WalkCommand>) said.walks.insert(state.tick);
      if constexpr (std::is_same_v<T, Gamepad>) said.pads.insert(state.tick);
      if constexpr (std::is_same_v<T, StepList>) said.steps.insert(state.tick);
    });
  }
  return said;
}

TEST(RobotScript, EverythingThatASceneAsksIsSaidToARobot) {
  SceneRequests all;
  all.modes = {{.at = 0.5, .request = {}}};
  all.goals = {{.at = 1.0, .request = {}}};
  all.walks = {{.at = 1.0, .duration = 2.0, .request = {}}};
  all.pads = {{.at = 1.0, .duration = 1.0, .request = {}}};
  all.steps = {{.at = 2.0, .request = {}}};
  RobotScript script;
  const Said said = play(all, 5.0, script);
  EXPECT_EQ(said.at_tick, 1000 - 1 + 250);
  ASSERT_FALSE(said.modes.empty());
  EXPECT_LT(*said.modes.begin(), said.at_tick);  // ahead, and again in case one is lost
  EXPECT_GE(said.modes.size(), 3U);
  EXPECT_GE(said.goals.size(), 3U);
  EXPECT_GE(said.steps.size(), 3U);
  // 50 times a second while it lasts: silence would end a walk.
  EXPECT_NEAR(static_cast<double>(said.walks.size()), 100.0, 1.0);
  EXPECT_NEAR(static_cast<double>(said.pads.size()), 50.0, 1.0);
  EXPECT_NEAR(static_cast<double>(*said.walks.begin()), 1500.0, 10.0);
  EXPECT_EQ(said.runs, std::set<std::int64_t>{7});
}

TEST(RobotScript, WalksPadsAndFootstepsOfScenesAreThere) {
  for (const char* name : {"walk_forward", "walk_pad", "walk_steps"}) {
    RobotScript script;
    const Scene scene = load_scene(name);
    const Said said = play(requests_of(scene), 10.0, script);
    EXPECT_EQ(said.walks.empty(), scene.walks.empty()) << name;
    EXPECT_EQ(said.pads.empty(), scene.pads.empty()) << name;
    EXPECT_EQ(said.steps.empty(), scene.steps.empty()) << name;
    EXPECT_GT(said.walks.size() + said.pads.size() + said.steps.size(), 0U) << name;
  }
}

TEST(RobotScript, ASecondSceneCountsOnAndSpeaksToTheSourceOfNow) {
  SceneRequests walk;
  walk.walks = {{.at = 0.0, .duration = 1.0, .request = {}}};
  RobotScript script;
  const Said first = play(walk, 1.0, script), second = play(walk, 1.0, script, 8);
  EXPECT_GT(*second.sequences.begin(), *first.sequences.rbegin());
  EXPECT_EQ(second.runs, std::set<std::int64_t>{8});
}

}  // namespace
}  // namespace twinbus
