// Which joints and robots are proposed to be left out of a run.

#include "launcher/run/less.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "launcher/run/clearance.h"
#include "launcher/run/ladder.h"
#include "robot/description/load.h"
#include "sim/engine/make_world.h"

namespace twinbus {
namespace {

Moved all_at_rest(const Model& model) {
  Moved moved;
  moved.joints.assign(model.joints.size(), 0.0);
  return moved;
}

TEST(Less, WhatDoesNotMoveIsProposedAsOneSet) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  moved.robots = {"second"};
  moved.robot_ways = {0.0};
  const std::vector<Less> sets = proposals(model, moved, 1e-3);
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0].held.size(), model.joints.size());
  EXPECT_EQ(sets[0].still, std::vector<std::string>{"second"});
  EXPECT_EQ(words_of(sets[0]), "robot second still, " + std::to_string(model.joints.size()) + " joints held");
  // Where that does not hold the error, it may give way as one body.
  EXPECT_EQ(sets[1].held, sets[0].held);
  EXPECT_TRUE(sets[1].still.empty());
  EXPECT_EQ(sets[1].rigid, std::vector<std::string>{"second"});
}

// A robot of which no link moves stands still with all that it has; one that leans a little is one body.
TEST(Less, ARobotThatDoesNotMoveStandsStill) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  moved.joints[3] = 1e-2;
  moved.links = 5e-4;
  moved.robots = {"second"};
  moved.robot_ways = {2e-3};
  const std::vector<Less> sets = proposals(model, moved, 1e-3, true);
  ASSERT_EQ(sets.size(), 6U);
  EXPECT_EQ(sets[0].held.size(), model.joints.size());
  EXPECT_EQ(sets[0].still, std::vector<std::string>{"base"});
  EXPECT_EQ(sets[0].rigid, std::vector<std::string>{"second"});
  EXPECT_TRUE(sets[0].apart);
  EXPECT_EQ(words_of(sets[0]), "the robot still, robot second rigid, no contact within a robot");
  for (std::size_t i = 0; i < sets.size(); ++i) {
    EXPECT_EQ(sets[i].apart, i % 2 == 0) << i;
    EXPECT_EQ(sets[i].still.size(), i < 2 ? 1U : 0U) << i;
    EXPECT_EQ(sets[i].rigid.size(), i < 4 ? 1U : 0U) << i;
    EXPECT_EQ(sets[i].held.size(), model.joints.size() - (i < 2 ? 0 : 1)) << i;
  }
  Scene scene;
  scene.self_contact = true;
  const Scene changed = without(scene, sets[0]);
  EXPECT_EQ(changed.held.back(), "base");
  EXPECT_FALSE(changed.self_contact);
}

// A joint of the hip moves the foot by its angle times the length of the leg.
TEST(Less, AJointIsHeldByTheWayOfWhatIsBehindIt) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  for (const int leg : model.leg_joints) moved.joints[static_cast<std::size_t>(leg)] = 0.2;
  const int hip = model.leg_joints.front();
  EXPECT_GT(ways(model, moved)[static_cast<std::size_t>(hip)], 0.2 * 0.5);
  for (std::size_t j = 0; j < moved.joints.size(); ++j) {
    const bool leg = std::find(model.leg_joints.begin(), model.leg_joints.end(), static_cast<int>(j)) != model.leg_joints.end();
    if (!leg) moved.joints[j] = 1e-4;
  }
  const std::vector<Less> sets = proposals(model, moved, 1e-3);
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().held.size(), model.joints.size() - model.leg_joints.size());
  for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_LT(sets[i].held.size(), sets[i - 1].held.size());
  EXPECT_TRUE(proposals(model, moved, 1e-6).empty());
}

// A run in which nothing moved, off by so much [m].
Track at_rest(const Model& model, double off) {
  Track track;
  track.names = {"link foot"};
  track.at = {{Eigen::Vector3d(off, 0.0, 0.0)}};
  track.moved = all_at_rest(model);
  return track;
}

// What is chosen where nothing moves and runs are off by so much [m]; work: of theirs, in solves.
int chosen_where(const std::function<double(const Scene&)>& off, Ladder& ladder, const std::function<double(const Scene&)>& work = {}) {
  const Model model = load_robot("hrp1s");
  Scene scene;
  scene.self_contact = true;
  LadderRequest request;
  request.duration = 0.1;
  request.error = 1e-3;
  request.less = true;
  request.follow = [&](const Scene& asked) {
    Track track = at_rest(model, off(asked));
    track.moved.links = 0.0;
    track.cost = asked.held.empty() ? 1.0 : 0.5;
    if (work) track.work = work(asked);
    return track;
  };
  ladder = climb(model, scene, {}, request);
  return ladder.choose(request.error);
}

TEST(Less, WhereLinksOfARobotTouchTheRestIsLeftOutAllTheSame) {
  Ladder ladder;
  const int chosen = chosen_where([](const Scene& asked) { return asked.self_contact ? 0.0 : 0.1; }, ladder);
  ASSERT_GE(chosen, 0);
  const Less& less = ladder.rungs[static_cast<std::size_t>(chosen)].less;
  EXPECT_FALSE(less.apart);
  EXPECT_EQ(less.still, std::vector<std::string>{"base"});
}

// Only order 3 holds the error, and its finest run is the least work: the yardstick is chosen until something is left out.
TEST(Less, WhereTheYardstickIsChosenASmallerSetIsTriedAfterOneThatFails) {
  const std::pair<std::string, std::string> third("solver.order", "3");
  const auto off = [&](const Scene& asked) {
    const bool best = std::find(asked.settings.begin(), asked.settings.end(), third) != asked.settings.end();
    return !asked.self_contact ? 0.1 : best ? 0.0 : 1.5e-3;
  };
  Ladder ladder;
  const int chosen = chosen_where(off, ladder, [](const Scene& asked) { return asked.step; });  // the finer the less
  ASSERT_GE(chosen, 0);
  const Less& less = ladder.rungs[static_cast<std::size_t>(chosen)].less;
  EXPECT_FALSE(less.none());
  EXPECT_FALSE(less.apart);
}

TEST(Less, WhereStandingStillIsTooMuchJointsAreHeld) {
  Ladder ladder;
  const auto still = [](const Scene& asked) {
    return std::find(asked.held.begin(), asked.held.end(), "base") != asked.held.end() ? 0.1 : 0.0;
  };
  const int chosen = chosen_where(still, ladder);
  ASSERT_GE(chosen, 0);
  const Less& less = ladder.rungs[static_cast<std::size_t>(chosen)].less;
  EXPECT_TRUE(less.apart);
  EXPECT_TRUE(less.still.empty());
  EXPECT_FALSE(less.held.empty());
}

// Links that nothing loose came near in the yardstick are not asked; where links of a robot touch one another, they are.
TEST(Less, LinksThatNothingComesNearAreNotAsked) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  moved.links = 0.3;
  moved.clear.assign(model.links.size(), 1.0);
  moved.clear[3] = 0.01;
  const std::vector<Less> sets = proposals(model, moved, 1e-3);
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().untouched.size(), model.links.size() - 1);
  for (const Less& less : proposals(model, moved, 1e-3, true)) EXPECT_EQ(less.untouched.empty(), !less.apart);
}

TEST(Less, LinksThatNothingFixedComesNearAreNotAsked) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  for (double& joint : moved.joints) joint = 0.3;
  moved.above.assign(model.links.size(), 0.3);
  moved.above[3] = 1e-3;
  moved.above[4] = std::numeric_limits<double>::infinity();  // it has no shape
  const std::vector<Less> sets = proposals(model, moved, 1e-3, true);
  ASSERT_EQ(sets.size(), 2U);  // without contact within the robot and with it
  for (const Less& less : sets) EXPECT_EQ(less.aloft.size(), model.links.size() - 2);
  EXPECT_EQ(std::count(sets[0].aloft.begin(), sets[0].aloft.end(), model.links[3].name), 0);
  EXPECT_EQ(without(Scene{}, sets[0]).aloft, sets[0].aloft);
}

// What slept in no run is not said to be asleep.
TEST(Less, WhereNoBodySleepsNothingIsSaidToBeAsleep) {
  const Model model = load_robot("hrp1s");
  for (const bool sleeps : {false, true}) {
    LadderRequest request;
    request.duration = 0.1;
    request.error = 1e-3;
    request.less = true;
    request.follow = [&](const Scene& asked) {
      Track track = at_rest(model, 0.0);
      track.moved.lay = 0.5;
      track.slept = sleeps && asked.asleep;
      track.cost = asked.held.empty() ? 1.0 : 0.5;
      return track;
    };
    const Ladder ladder = climb(model, Scene{}, {}, request);
    const int chosen = ladder.choose(request.error);
    ASSERT_GE(chosen, 0);
    EXPECT_FALSE(ladder.rungs[static_cast<std::size_t>(chosen)].less.held.empty());
    EXPECT_EQ(ladder.rungs[static_cast<std::size_t>(chosen)].less.asleep, sleeps);
    EXPECT_EQ(ladder.moved.lay, 0.5);
  }
}

// Where loose bodies lie still for a while, each set lets them sleep, and then come the same sets with them awake.
TEST(Less, LooseBodiesThatLieStillMaySleep) {
  const Model model = load_robot("hrp1s");
  Moved moved = all_at_rest(model);
  for (double& joint : moved.joints) joint = 0.3;
  moved.links = 0.3;
  EXPECT_TRUE(proposals(model, moved, 1e-3).empty());
  moved.lay = 0.5;
  const std::vector<Less> sets = proposals(model, moved, 1e-3);
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(words_of(sets[0]), "loose bodies asleep where they lie still");
  EXPECT_TRUE(without(Scene{}, sets[0]).asleep);
  moved.joints.back() = 0.0;
  const std::vector<Less> more = proposals(model, moved, 1e-3);
  ASSERT_EQ(more.size(), 3U);
  EXPECT_TRUE(more[0].asleep && more[0].held.size() == 1);
  EXPECT_TRUE(more[1].asleep && more[1].held.empty());
  EXPECT_FALSE(more[2].asleep);
}

// A plate is flat: what is above it is as far from it as it is high.
TEST(Less, LinksAboveAPlateAreClearOfIt) {
  const Model model = load_robot("hrp1s");
  WorldConfig config;
  LooseBody plate;
  plate.solid.size = {1.0, 1.0, 0.01};
  plate.start.pose.translation() = Eigen::Vector3d(0.2, 0.1, -0.5);
  plate.start.pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  plate.solid_pose.translation().z() = 0.2;
  config.loose = {plate};
  const auto world = make_world(model, config);
  Clearance clearance(model, config);
  clearance.look(*world);
  bool any = false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const double above = world->link_in_world(static_cast<int>(i)).translation().z() + 0.295;
    if (!std::isfinite(clearance.nearest()[i]) || above < 0.5) continue;
    any = true;
    EXPECT_GT(clearance.nearest()[i], 0.1) << model.links[i].name;  // a ball around the plate is 0.7 m wide
    EXPECT_LE(clearance.nearest()[i], above + 0.3) << model.links[i].name;
  }
  EXPECT_TRUE(any);
}

TEST(Less, WhatASceneLeavesOutItselfStaysOut) {
  Scene scene;
  scene.held = {"A"};
  Less less;
  less.held = {"B"};
  less.rigid = {"second"};
  less.untouched = less.aloft = {"HEAD"};
  const Scene changed = without(scene, less);
  EXPECT_EQ(changed.held, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(changed.rigid, std::vector<std::string>{"second"});
  EXPECT_EQ(changed.untouched, std::vector<std::string>{"HEAD"});
  EXPECT_EQ(changed.aloft, std::vector<std::string>{"HEAD"});
}

}  // namespace
}  // namespace twinbus
