// A scene once for each of many seeds: every seed ends as it does alone, and what fails is counted by its cause.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "launcher/run/judge_scene.h"
#include "launcher/run/seeds.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

TEST(Seeds, ARangeIsReadAndWhatIsNoneIsRefused) {
  SeedRange seeds;
  EXPECT_TRUE(read_seeds("3..7", seeds));
  EXPECT_EQ(seeds.first, 3u);
  EXPECT_EQ(seeds.last, 7u);
  EXPECT_TRUE(read_seeds("5", seeds));
  EXPECT_EQ(seeds.first, 5u);
  EXPECT_EQ(seeds.last, 5u);
  for (const char* word : {"", "..", "1..", "..4", "7..3", "1-4", "1..2..3", "1..1000001", "-1..4", "1..4x", "99999999999999999999..1"})
    EXPECT_FALSE(read_seeds(word, seeds)) << word;
  EXPECT_EQ(seeds.last, 5u);  // as it was
}

class SeedsOf : public ::testing::Test {
 protected:
  SeedsOf() : scene_(load_scene("walk_noisy")), model_(load_robot(scene_.robot)) { fit_scene(scene_, model_); }

  std::vector<SeedResult> run(SeedRange seeds, int jobs, std::int64_t ticks = 20) {
    return run_seeds(model_, {.seeds = seeds, .ticks = ticks, .jobs = jobs, .part = true, .lanes = lanes_}, [this](std::uint64_t seed) {
      if (seed == bad_) throw std::runtime_error("tile 12 of seed 13 cannot be laid");
      SeededRun ready{scene_, {}};
      ready.config.seed = seed;
      apply_seed(ready.scene, model_, seed);
      return ready;
    });
  }

  Scene scene_;
  Model model_;
  std::uint64_t bad_ = 0;
  bool lanes_ = false;
};

TEST_F(SeedsOf, ManyAtATimeEachEndAsTheyDoAlone) {
  const std::vector<SeedResult> together = run({1, 5}, 3);
  ASSERT_EQ(together.size(), 5u);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<SeedResult> alone = run({seed, seed}, 1);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_EQ(alone[0].seed, seed);
    EXPECT_EQ(together[seed - 1].seed, seed);
    EXPECT_EQ(together[seed - 1].state_hash, alone[0].state_hash);
    EXPECT_EQ(together[seed - 1].ticks, 20);
  }
  EXPECT_NE(together[0].state_hash, together[1].state_hash);  // noise of their own
}

TEST_F(SeedsOf, InLanesEachEndsAsItDoesThereAlone) {
  lanes_ = true;
  bad_ = 2;  // its neighbours go on
  const std::vector<SeedResult> together = run({1, 6}, 1);
  ASSERT_EQ(together.size(), 6u);
  EXPECT_FALSE(together[1].error.empty());
  for (const std::uint64_t seed : {1U, 3U, 6U}) {
    const std::vector<SeedResult> alone = run({seed, seed}, 1);
    EXPECT_EQ(together[seed - 1].error, "");
    EXPECT_EQ(together[seed - 1].ticks, 20);
    EXPECT_EQ(together[seed - 1].state_hash, alone[0].state_hash);
  }
  EXPECT_NE(together[0].state_hash, together[2].state_hash);
  scene_.settings.emplace_back("solver.order", "2");
  EXPECT_EQ(run({1, 1}, 1)[0].error, "lanes: solver.order is not 1");
}

TEST_F(SeedsOf, ASeedThatCannotBeRunIsNamedWithItsCauseAndTheOthersGoOn) {
  bad_ = 13;
  const std::vector<SeedResult> results = run({12, 14}, 2);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_TRUE(results[0].error.empty());
  EXPECT_EQ(results[1].error, "tile 12 of seed 13 cannot be laid");
  SeedsRequest request;
  request.seeds = {12, 14};
  const std::string text = seeds_text(results, request, model_.period(), 1.0);
  EXPECT_NE(text.find("1 of 3: tile # of seed # cannot be laid (seed 13)"), std::string::npos) << text;
  EXPECT_NE(text.find("2 of 3 seeds passed"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(seeds_json(results, request, {}, 1.0));
  EXPECT_EQ(json["passed"], 2);
  EXPECT_EQ(json["seeds"][1]["failures"][0], "tile 12 of seed 13 cannot be laid");
}

TEST_F(SeedsOf, SeedsThatFailAlikeAreCountedTogetherWhateverTheirNumbers) {
  std::vector<SeedResult> results(3);
  for (std::size_t i = 0; i < 3; ++i) {
    results[i].seed = i + 1;
    results[i].verdict.failures = {"hand_2 came " + std::to_string(1.5 + static_cast<double>(i)) + " mm near, 3.0 were asked"};
  }
  SeedsRequest request;
  request.seeds = {1, 4};
  const std::string text = seeds_text(results, request, 0.002, 1.0);
  EXPECT_NE(text.find("3 of 3: hand_# came # mm near, # were asked (seeds 1 2 3)"), std::string::npos) << text;
  EXPECT_NE(text.find("stopped: 1 seeds were not run"), std::string::npos) << text;
}

TEST_F(SeedsOf, WhatOneSeedHasMeasuredIsSaidToBeItsOwnAndWhoLeavesItsBandIsNamed) {
  std::vector<SeedResult> results(4);
  for (std::size_t i = 0; i < 4; ++i) results[i].seed = i + 3;
  results[2].doubted = 7;
  SeedsRequest request;
  request.seeds = {3, 6};
  EXPECT_NE(seeds_text(results, request, 0.002, 1.0).find("1 of 4 had physics steps that are not to be trusted (seed 5)"), std::string::npos);
  request.measured = true;
  request.accuracy = R"({"order": 2, "seed": 3})";
  const std::string text = seeds_text(results, request, 0.002, 1.0);
  EXPECT_NE(text.find("3 of 4 seeds had no worse step than seed 3, with which the error was measured"), std::string::npos) << text;
  EXPECT_NE(text.find("1 of 4 had worse steps than that, so nothing is known of their errors (seed 5)"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(seeds_json(results, request, {}, 1.0));
  EXPECT_EQ(json["accuracy"]["seed"], 3);
  EXPECT_EQ(json["seeds"][2]["doubted_steps"], 7);
}

// What was measured with one bounds the steps of all: worse ones are doubted, and no others.
TEST_F(SeedsOf, EachSeedIsHeldToTheBandOfTheScene) {
  scene_.accuracy = 1e-9;
  for (const SeedResult& result : run({1, 2}, 1, 60)) EXPECT_GT(result.doubted, 0) << result.seed;
  scene_.bands = {1.0, 1e3, 1e3, 1.0};
  for (const SeedResult& result : run({1, 2}, 1, 60)) EXPECT_EQ(result.doubted, 0) << result.seed;
}

}  // namespace
}  // namespace twinbus
