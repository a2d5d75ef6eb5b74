// Scenes whose end is known: each passes by its own criteria, and would not if its reference were
// another one.  The references that need more than a formula are computed here.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "launcher/run/judge_scene.h"
#include "launcher/run/local_stack.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

RunVerdict run(const Scene& from, const Criteria* asked = nullptr) {
  Scene scene = from;
  if (asked != nullptr) scene.criteria = *asked;
  const Model model = load_robot(scene.robot);
  resolve_poses(scene, model);
  apply_seed(scene, model, 1);
  OneProcess process(model, scene, {});
  const auto ticks = static_cast<std::int64_t>(std::llround(scene.duration / model.period()));
  while (process.ticks() < ticks && process.tick()) {
  }
  return judge_scene(process, scene.criteria, ticks);
}

std::string text_of(const RunVerdict& verdict) {
  std::string text;
  for (const std::string& failure : verdict.failures) text += failure + "\n";
  return text;
}

// Complete elliptic integral of the first kind, modulus k, by the arithmetic-geometric mean.
double elliptic_k(double k) {
  double a = 1.0, b = std::sqrt(1.0 - k * k);
  for (int i = 0; i < 40; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 0.5 * std::numbers::pi / a;
}

class KnownScene : public ::testing::TestWithParam<const char*> {};

TEST_P(KnownScene, PassesAndWouldNotWithAnotherReference) {
  const Scene scene = load_scene(GetParam());
  const RunVerdict verdict = run(scene);
  EXPECT_TRUE(verdict.passed) << text_of(verdict);
  // Three times what is allowed away.
  Criteria wrong = scene.criteria;
  for (LooseEnd& end : wrong.loose) end.position.x() += 3.0 * end.within;
  wrong.touch.force *= 1.0 + 3.0 * wrong.touch.within;
  EXPECT_FALSE(run(scene, &wrong).passed);
}

// Those that take under a second; the others are run by test/process/walk_scenes_test.py.
INSTANTIATE_TEST_SUITE_P(Scenes, KnownScene,
                         ::testing::Values("table", "top", "cradle", "painleve"));

TEST(StandardScenes, ThePendulumOfTheSceneTakesTwoSeconds) {
  const Scene scene = load_scene("pendulum");
  const LooseBody& ball = scene.loose.at(0);
  const double c = scene.loops.at(0).at.norm();
  const double about = inertia_of(ball.solid, ball.mass)(1, 1) + ball.mass * c * c;
  const double length = about / (ball.mass * c);
  const double period = 4.0 * std::sqrt(length / 9.81) * elliptic_k(std::sin(std::numbers::pi / 4));
  EXPECT_NEAR(period, 2.0, 2e-6);
}

// The middle component of the spin is proportional to Jacobi's sn or cn: it changes its sign every
// 2 K(k) / p.
TEST(StandardScenes, TheBoxThrownHighFlipsAsOftenAsJacobisFunctionsSay) {
  const Scene scene = load_scene("dzhanibekov");
  const LooseBody& box = scene.loose.at(0);
  const Eigen::Vector3d inertia = inertia_of(box.solid, box.mass).diagonal();
  const Eigen::Vector3d spin = box.start.angular_velocity;
  const double a = inertia[0], b = inertia[1], c = inertia[2];
  const double twice_energy = spin.dot(inertia.cwiseProduct(spin));
  const double momentum = inertia.cwiseProduct(spin).squaredNorm();
  // Rates and modulus of the motion about the axis of the smallest (a) or largest (c) inertia.
  const double upper = (c * twice_energy - momentum) * (b - a);
  const double lower = (momentum - a * twice_energy) * (c - b);
  const double rate = std::sqrt(
      std::max((c - b) * (momentum - a * twice_energy), (b - a) * (c * twice_energy - momentum)) /
      (a * b * c));
  const double modulus = std::sqrt(std::min(upper, lower) / std::max(upper, lower));
  const double half = 2.0 * elliptic_k(modulus) / rate;  // from one change of sign to the next
  // It begins at its largest value: the first change is after a quarter.
  EXPECT_EQ(static_cast<int>(scene.duration / half + 0.5), scene.criteria.spins.at(0).flips);
}

TEST(StandardScenes, ATopThatTurnsTooSlowlyDoesNotSleep) {
  Scene scene = load_scene("top");
  scene.loose.at(1).start.angular_velocity *= 0.8 / 1.2;
  EXPECT_FALSE(run(scene).passed);
}

// The criterion of painleve: what stiffness does to the outcome, shortly after the rods jam.
TEST(StandardScenes, StiffRodsOfPainlevesParadoxJamAlike) {
  Scene scene = load_scene("painleve");
  scene.duration = 0.2;
  const Model model = load_robot(scene.robot);
  resolve_poses(scene, model);
  OneProcess process(model, scene, {});
  while (process.ticks() < 100 && process.tick()) {
  }
  const Eigen::Vector3d firm = process.world().loose(1).pose.translation();
  const Eigen::Vector3d hard = process.world().loose(2).pose.translation();
  EXPECT_NEAR(firm.x(), hard.x(), 0.02);
  EXPECT_NEAR(firm.z(), hard.z(), 0.02);
}

}  // namespace
}  // namespace twinbus
