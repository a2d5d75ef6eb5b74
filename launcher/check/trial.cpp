#include "launcher/check/trial.h"

#include <algorithm>
#include <cmath>

#include "common/text/formatted.h"
#include "control/balance/balance.h"
#include "control/point_feet/point_feet_body.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/local_stack.h"
#include "common/math/index.h"
#include "common/process/process.h"
#include "robot/dynamics/pair_torque.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"
#include "sim/world/static_equilibrium.h"
#include "sim/engine/make_world.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kSimulated = 2.0;                    // [s]
constexpr double kReserve = 0.9;                      // of the effort limit
constexpr std::int64_t kPatience = 10'000'000'000LL;  // [ns]

std::vector<std::string> weak_joints(const Model& model) {
  std::vector<std::string> weak;
  const int pose = model.find_pose("half_sitting");
  if (pose < 0) return weak;
  const std::vector<double>& q = model.poses[at(pose)].q;
  const Standing standing =
      stand(model, Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())),
            1.0, {model.soles[0].stiffness / kSoleCorners, model.soles[1].stiffness / kSoleCorners},
            {0.0, 0.0}, !model.floating_base);
  const PairTorque torque(model);
  for (const int j : model.bus_joints) {
    const Joint& joint = model.joints[at(j)];
    const double needed = std::abs(standing.needed[j]);
    const double limit = torque.effort_in(j, standing.configuration.q);
    if (needed <= kReserve * limit) continue;
    weak.push_back(formatted("joint %s needs %.1f N m to hold half_sitting; its effort limit is %.1f", joint.name.c_str(),
                             needed, limit));
  }
  return weak;
}

// Joints of arms that nothing moves, though one that points up may stand for a while.
std::string motorless(const Model& model) {
  std::string names;
  int count = 0;
  for (const Hand* hand : hands_of(model)) {
    for (const int j : hand->joints) {
      if (model.joints[at(j)].effort > 0.0) continue;
      if (count++ == 0) names = "joint " + model.joints[at(j)].name;
    }
  }
  if (count > 1) names += formatted(" and %d others", count - 1);
  return count == 0 ? "" : names + (count > 1 ? " have" : " has") + " an effort limit of 0: no motor moves an arm so";
}

}  // namespace

Trial try_to_stand(const Model& model) {
  Trial trial;
  if (const char* why = Balance::why_not(model); why != nullptr && why_no_point_feet(model) != nullptr)
    trial.cannot_balance = stands_on_points(model) ? why_no_point_feet(model) : why;
  trial.free = model.floating_base;
  trial.planar = !model.plane_joints.empty();
  trial.arm = !model.floating_base && hand_of(model, 0) != nullptr;
  try {
    for (const Engine engine : {Engine::kArticulated, Engine::kOde}) {
      WorldConfig world;
      world.engine = engine;
      world.fixed_base = !model.floating_base;
      (void)make_world(model, world);
    }
    trial.weak = weak_joints(model);
    Scene scene = load_scene("stand");
    fit_scene(scene, model);
    apply_seed(scene, model, 1);
    OneProcess run(model, scene, {});
    const auto ticks = static_cast<std::int64_t>(std::llround(kSimulated / model.period()));
    const std::int64_t begin = monotonic_ns();
    while (run.ticks() < ticks && monotonic_ns() - begin < kPatience && run.tick()) {
    }
    trial.wall_s = 1e-9 * static_cast<double>(monotonic_ns() - begin);
    trial.simulated_s = model.period() * static_cast<double>(run.ticks());
    const RunVerdict verdict = judge_scene(run, scene.criteria, run.ticks());
    trial.stood = verdict.passed;
    if (std::string still = motorless(model); trial.arm && !still.empty()) {
      trial.stood = false;
      trial.weak.push_back(std::move(still));
    }
    trial.failures = verdict.failures;
    trial.figures = scene_figures(run, scene.criteria);
    while (!trial.figures.empty() && trial.figures.back() == '\n') trial.figures.pop_back();
  } catch (const std::exception& error) {
    trial.refusal = error.what();
  }
  return trial;
}

}  // namespace twinbus::launcher
