// The order and step that a ladder chooses hold the error asked for, on scenes that nothing was tuned on, against a
// reference of twice as fine a step that a second method confirms; and they are no dearer than they need be.

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "common/math/index.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/ladder.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

struct Asked {
  const char* scene;
  double seconds;
  double error;  // [m]
  bool cheaper;  // than the scene's own step of order 1, in solves
};

void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.scene; }

class HeldError : public ::testing::TestWithParam<Asked> {};

int solves_of(int order) { return order * (order + 1) / 2; }

TEST_P(HeldError, ByTheChoiceOfTheLadder) {
  const Asked& asked = GetParam();
  Scene scene = load_scene(asked.scene);
  const Model model = load_robot(scene.robot);
  fit_scene(scene, model);
  apply_seed(scene, model, 1);
  LadderRequest request;
  request.duration = asked.seconds;
  request.error = asked.error;
  const Ladder ladder = climb(model, scene, {}, request);
  const int chosen = ladder.choose(asked.error);
  ASSERT_GE(chosen, 0) << ladder_table(ladder, chosen);
  const Rung& rung = ladder.rungs[at(chosen)];

  const auto run = [&](int order, double step) {
    return follow(model, at_rung(scene, order, step), {}, asked.seconds);
  };
  const Track reference = run(3, model.period() / 40);
  ASSERT_LT(distance(run(2, model.period() / 40), reference).most, 0.1 * asked.error)
      << "the references disagree";
  const double truth = distance(run(rung.order, rung.step), reference).most;
  EXPECT_LE(truth, asked.error) << ladder_table(ladder, chosen);
  const double estimate = ladder.estimate(at(chosen));
  EXPECT_LT(truth, 3.0 * estimate);
  EXPECT_LT(estimate, 3.0 * truth);
  if (asked.cheaper) {
    EXPECT_LT(solves_of(rung.order) / rung.step, 1.0 / scene.step) << ladder_table(ladder, chosen);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Untuned, HeldError,
    ::testing::Values(Asked{"stick_slip", 0.3, 1e-2, true}, Asked{"stick_slip", 0.3, 1e-3, false},
                      Asked{"brick_stop", 0.3, 1e-2, true}, Asked{"brick_stop", 0.3, 1e-4, false},
                      Asked{"governor", 0.5, 1e-4, false}, Asked{"pendulum", 1.0, 1e-3, false},
                      Asked{"arm_reach", 0.6, 1e-4, false}),
    [](const auto& each) {
      return std::string(each.param.scene) + "_" +
             std::to_string(std::lround(1e6 * each.param.error)) + "um";
    });

}  // namespace
}  // namespace twinbus
