// The scene that `tune` writes is the scene with another step and order.

#include "launcher/run/tuned_text.h"

#include <gtest/gtest.h>

#include "sim/scene/scene.h"
#include "test/temporary_folder.h"

#include <fstream>

namespace twinbus {
namespace {

Scene written(const std::string& text) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path() + "/scene.yaml";
  std::ofstream(file) << text;
  return load_scene(file);
}

std::string order_of(const Scene& scene) {
  std::string order;
  for (const auto& [key, value] : scene.settings) {
    if (key == "solver.order") order += value;
  }
  return order;
}

Rung rung_of(int order, double step) {
  Rung rung;
  rung.order = order;
  rung.step = step;
  return rung;
}

TEST(Tune, StepAndOrderReplaceThoseOfTheSceneAndNothingElseIsLost) {
  const std::string rest = "about: A test.\nduration: 3\nmodes:\n  - {at: 0, mode: balance}\n";
  const std::string texts[] = {rest, rest + "step: 0.001\n",
                               rest + "settings: {solver.order: 3, model.mass_scale: 1.5}\n",
                               rest + "settings: {model.mass_scale: 1.5}\nstep: 0.0001\n",
                               rest + "settings:\n  model.mass_scale: 1.5\n",
                               rest + "settings:\n  solver.order: 3\n  model.mass_scale: 1.5\n"};
  for (const std::string& text : texts) {
    const Scene before = written(text);
    const Scene scene = written(tuned_text(text, rung_of(2, 0.0005), "because"));
    EXPECT_EQ(scene.step, 0.0005) << text;
    EXPECT_EQ(order_of(scene), "2") << text;
    EXPECT_EQ(scene.duration, 3.0) << text;
    EXPECT_EQ(scene.modes.size(), 1U) << text;
    EXPECT_EQ(scene.settings.size(), before.settings.size() + (order_of(before).empty() ? 1 : 0)) << text;
  }
}

TEST(Tune, TheLocalErrorIsWrittenAndTakenAwayAgain) {
  const std::string rest = "about: A test.\nmodes:\n  - {at: 0, mode: balance}\n";
  const std::string texts[] = {rest, rest + "settings: {solver.order: 3, model.mass_scale: 1.5}\n",
                               rest + "settings: {model.mass_scale: 1.5, solver.order: 1, solver.local_error: 7}\n",
                               rest + "settings: {solver.local_error: 7}\n",
                               rest + "settings:\n  solver.local_error: 7  # coarse\n  model.mass_scale: 1.5\n",
                               rest + "settings:\n  solver.order: 3\n  model.mass_scale: 1.5\n"};
  Rung local = rung_of(3, 0.002);
  local.local = 0.3;
  for (const std::string& text : texts) {
    const bool scaled = text.find("mass_scale") != std::string::npos;
    const std::string once = tuned_text(text, local, "because");
    const Scene scene = written(once), back = written(tuned_text(once, rung_of(2, 0.001), "again"));
    const auto count = [](const Scene& of, const std::string& key, const std::string& value) {
      return std::count(of.settings.begin(), of.settings.end(), std::pair(key, value));
    };
    EXPECT_EQ(count(scene, "solver.local_error", "0.3"), 1) << once;
    EXPECT_EQ(count(scene, "solver.order", "3"), 1) << once;
    EXPECT_EQ(scene.settings.size(), scaled ? 3U : 2U) << once;
    EXPECT_EQ(back.settings.size(), scaled ? 2U : 1U) << once;
    EXPECT_EQ(order_of(back), "2") << once;
  }
}

TEST(Tune, WhatWasLeftOutIsListedInPlaceOfTheWordAndOfTheOldList) {
  const std::string rest = "about: A test.\nmodes:\n  - {at: 0, mode: balance}\n";
  const std::string texts[] = {rest + "fidelity: auto\n", "held: [A]\n" + rest + "fidelity: auto\n",
                               "held:\n  - A\nrigid:\n- other\nself_contact: true\n" + rest};
  Rung rung = rung_of(2, 0.0005);
  rung.less = {{"A", "B"}, {"other"}, {}, {"HEAD"}, {"WAIST"}, true, true};
  for (const std::string& text : texts) {
    const Scene scene = written(tuned_text(text, rung, "because"));
    EXPECT_EQ(scene.fidelity, "full") << text;
    EXPECT_EQ(scene.held, rung.less.held) << text;
    EXPECT_EQ(scene.rigid, rung.less.rigid) << text;
    EXPECT_FALSE(scene.self_contact) << text;
    EXPECT_TRUE(scene.asleep) << text;
    EXPECT_EQ(scene.untouched, rung.less.untouched) << text;
    EXPECT_EQ(scene.aloft, rung.less.aloft) << text;
    EXPECT_EQ(scene.modes.size(), 1U) << text;
    const std::string again = tuned_text(tuned_text(text, rung, "because"), rung, "anew");
    const std::size_t said = again.find("# What this run touches");
    ASSERT_NE(said, std::string::npos) << again;
    EXPECT_EQ(again.find("# What this run touches", said + 1), std::string::npos) << again;
  }
}

}  // namespace
}  // namespace twinbus
