// One mechanism with closed loops on one engine: physics_loops SCENE METHOD STEP
// [DURATION [STIFFNESS]] prints
//
//     drift J  first J  gap m  at x y z  q ...  speed m/s  cost ms/s  unconverged N  events N
//
// METHOD is ode, or the order of the articulated engine: 1, 2, 3.  drift: the largest change of
// energy, work of the drive subtracted; gap: the furthest that tied points came apart; speed:
// of the fastest link at the end.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "loop_scenes.h"
#include "robot/dynamics/energy.h"
#include "common/math/index.h"
#include "common/time/cpu_time.h"
#include "sim/engine/make_world.h"
#include "sim/engine/articulated_world.h"

int main(int argc, char** argv) try {
  using namespace twinbus;
  if (argc < 4) {
    std::fprintf(stderr, "usage: physics_loops SCENE ode|1|2|3 STEP [DURATION [STIFFNESS]]\n");
    return 2;
  }
  LoopScene scene = loop_scene(argv[1]);
  const std::string method = argv[2];
  scene.config.step = std::atof(argv[3]);
  if (argc > 4) scene.duration = std::atof(argv[4]);
  if (argc > 5) {  // the damping in proportion
    for (Tie& tie : scene.config.ties) {
      if (tie.length >= 0.0) continue;
      tie.damping *= std::atof(argv[5]) / tie.stiffness;
      tie.stiffness = std::atof(argv[5]);
    }
  }
  if (method == "ode") {
    scene.config.engine = Engine::kOde;
  } else {
    scene.config.order = std::max(1, std::atoi(method.c_str()));
  }
  const auto world = make_world(scene.model, scene.config);
  if (world->set(scene.start) != Status::kOk) return 1;
  for (int j = 0; j < scene.model.joint_count(); ++j) {
    ServoTarget target;
    if (j == scene.driven) target.tau = scene.torque;
    if (scene.tau.size() > 0) {
      const Joint& joint = scene.model.joints[at(j)];
      // The left arm presses its hand against the right.
      const std::vector<int>& arm = scene.model.hands[0].joints;
      const bool pressed = std::count(arm.begin(), arm.end(), j) > 0;
      target = {.q = scene.start.q[j] + (pressed ? 0.05 : 0.0),
                .qd = 0.0,
                .tau = scene.tau[j],
                .kp = joint.kp,
                .kd = joint.kd};
    }
    if (world->set_servo(j, target) != Status::kOk) return 1;
  }
  Kinematics kinematics(scene.model);
  const auto energy = [&] {
    kinematics.update(world->configuration());
    double sum = mechanical_energy(kinematics, world->configuration());
    for (const Tie& tie : scene.config.ties) {
      if (tie.length < 0.0) continue;
      const auto place = [&](const TieEnd& end) {
        return end.link < 0 ? end.point
                            : Eigen::Vector3d(kinematics.link_in_world(end.link) * end.point);
      };
      const double stretch = (place(tie.a) - place(tie.b)).norm() - tie.length;
      sum += 0.5 * tie.stiffness * stretch * stretch;
    }
    if (scene.driven >= 0) {
      sum -= scene.torque * (world->configuration().q[scene.driven] - scene.start.q[scene.driven]);
    }
    return sum;
  };
  const auto gap = [&] {
    double most = 0.0;
    for (const Tie& tie : scene.config.ties) {
      if (tie.length >= 0.0) continue;
      most = std::max(most, (kinematics.link_in_world(tie.a.link) * tie.a.point -
                             kinematics.link_in_world(tie.b.link) * tie.b.point)
                                .norm());
    }
    return most;
  };
  const double first = energy();
  double drift = 0.0, apart = gap();
  const long steps = std::lround(scene.duration / scene.config.step);
  double cost = 0.0;
  const long look = std::max(1L, std::lround(1e-3 * scene.duration / scene.config.step));
  for (long i = 0; i < steps; ++i) {
    const double begin = thread_cpu_seconds();
    if (world->step() != Status::kOk) {
      std::printf("diverged at %g s\n", scene.config.step * static_cast<double>(i));
      return 1;
    }
    cost += thread_cpu_seconds() - begin;
    if (i % look != 0 && i + 1 != steps) continue;
    drift = std::max(drift, std::abs(energy() - first));
    apart = std::max(apart, gap());
  }
  (void)energy();
  double speed = world->configuration().base_velocity.norm();
  for (int i = 0; i < scene.model.link_count(); ++i) {
    const Eigen::Vector3d origin = kinematics.link_in_world(i).translation();
    speed = std::max(speed, kinematics.point_velocity(i, origin).norm());
  }
  const Eigen::Vector3d p = kinematics.link_in_world(scene.link) * scene.point;
  std::printf("drift %.6e first %.6f gap %.3e at %.9f %.9f %.9f q", drift, first, apart, p.x(),
              p.y(), p.z());
  for (int j = 0; j < std::min(7, scene.model.joint_count()); ++j) {
    std::printf(" %.9f", world->configuration().q[j]);
  }
  long unconverged = 0, events = 0;
  if (const auto* own = dynamic_cast<const ArticulatedWorld*>(world.get())) {
    unconverged = own->unconverged();
    events = own->events();
  }
  std::printf(" speed %.3e cost %.4f unconverged %ld events %ld\n", speed,
              1e3 * cost / scene.duration, unconverged, events);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "physics_loops: %s\n", error.what());
  return 1;
}
