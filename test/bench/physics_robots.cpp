// Several robots in one world of the articulated engine: physics_robots SCENE ORDER STEP
// [STIFFNESS [DURATION]] prints
//
//     fastest m/s  tilt degrees  gap m  touched steps  unconverged N  step us
//
// SCENE: bump: one walks into another's back at 0.3 m/s; hands: they face each other, tied hand
// to hand; fold: one robot alone presses its left hand into its thigh; crowdN: N robots that
// stand apart.  STIFFNESS: of what touches or ties [N/m].  fastest: of all links at the end; tilt:
// the largest of a base at any time; touched: steps in which links of robots touched.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "common/time/cpu_time.h"
#include "robot/description/load.h"
#include "sim/engine/articulated_world.h"
#include "sim/world/other_robot.h"

namespace {

using namespace twinbus;

constexpr double kBump = 0.30;     // from one middle of the soles to the other's [m]
constexpr double kFacing = 0.80;   // [m]
constexpr double kSpacing = 2.0;   // [m]
constexpr double kBumpSpeed = 0.3; // [m/s]

struct RobotsScene {
  std::shared_ptr<const Model> model;
  OtherRobot own;  // the first, as it begins
  WorldConfig config;
};

Eigen::Isometry3d place(double x, double y, double yaw) {
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = Eigen::Vector3d(x, y, 0.0);
  at.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return at;
}

// Three points of the first robot's right hand, held where they are in the second's left hand.
void tie_hands(RobotsScene& scene, double stiffness) {
  Kinematics first(*scene.model), second(*scene.model);
  first.update(scene.own.start);
  second.update(scene.config.robots[0].start);
  const Hand &right = scene.model->hands[1], &left = scene.model->hands[0];
  for (int axis = 0; axis < 3; ++axis) {
    Tie tie;
    tie.a.link = right.link;
    tie.a.point = right.frame * Eigen::Vector3d(0.05 * Eigen::Vector3d::Unit(axis));
    tie.b.link = left.link;
    tie.b.robot = 0;
    tie.b.point = second.link_in_world(left.link).inverse() *
                  (first.link_in_world(right.link) * tie.a.point);
    tie.stiffness = stiffness;
    tie.damping = 1e-3 * stiffness;
    scene.config.ties.push_back(tie);
  }
}

RobotsScene robots_scene(const std::string& name, double stiffness) {
  RobotsScene scene;
  scene.model = std::make_shared<const Model>(load_robot("hrp1s"));
  const int pose = scene.model->find_pose("half_sitting");
  Eigen::VectorXd q(scene.model->joint_count());
  for (int j = 0; j < q.size(); ++j) q[j] = scene.model->poses[at(pose)].q[at(j)];
  const auto standing = [&](const std::string& who, const Eigen::Isometry3d& where) {
    return standing_robot(who, scene.model, q, where);
  };
  scene.own = standing("first", place(0, 0, 0));
  scene.config.shell_stiffness = stiffness;
  if (name == "bump") {
    scene.config.robots = {standing("second", place(kBump, 0, 0))};
    scene.own.start.base_velocity.x() = kBumpSpeed;
  } else if (name == "hands") {
    scene.config.robots = {standing("second", place(kFacing, 0, M_PI))};
    scene.own.start.base_velocity = {0.05, 0.05, 0.0};
    tie_hands(scene, stiffness);
  } else if (name == "fold") {
    scene.config.self_contact = true;
    // The whole arm turns inwards: its hand meets the thigh or the trunk.
    const int shoulder = scene.model->hands[0].joints[1];
    scene.own.servos[at(shoulder)].q -= 0.5;
  } else if (name.rfind("crowd", 0) == 0) {
    const int count = std::atoi(name.c_str() + 5);
    if (count < 1 || count > 100) throw std::runtime_error("crowdN: N is 1 to 100");
    for (int i = 1; i < count; ++i) {
      scene.config.robots.push_back(
          standing(std::to_string(i), place(kSpacing * (i % 4), kSpacing * (i / 4), 0)));
    }
  } else {
    throw std::runtime_error("no scene '" + name + "': there are bump, hands, fold, crowdN");
  }
  return scene;
}

double tilt_degrees(const Eigen::Isometry3d& base) {
  return 180.0 / M_PI * std::acos(std::clamp(base.linear()(2, 2), -1.0, 1.0));
}

bool among_robots(const Contact& c) {
  return c.other_system >= 0 && c.tie == TieKind::kNone && c.now.mode != ContactMode::kOpen;
}

int run(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: physics_robots SCENE ORDER STEP [STIFFNESS [DURATION]]\n");
    return 2;
  }
  RobotsScene scene = robots_scene(argv[1], argc > 4 ? std::atof(argv[4]) : kLinkStiffness);
  scene.config.order = std::atoi(argv[2]);
  scene.config.step = std::atof(argv[3]);
  const double duration = argc > 5 ? std::atof(argv[5]) : 1.5;
  ArticulatedWorld world(*scene.model, scene.config);
  if (world.set(scene.own.start) != Status::kOk) throw std::runtime_error("bad start");
  for (std::size_t j = 0; j < scene.own.servos.size(); ++j) {
    (void)world.set_servo(static_cast<int>(j), scene.own.servos[j]);
  }
  const int links = scene.model->link_count();
  const int others = static_cast<int>(scene.config.robots.size());
  const auto link = [&](int robot, int i) {
    return robot < 0 ? world.link_in_world(i) : world.robot_link(robot, i);
  };
  double tilt = 0.0, gap = 0.0, fastest = 0.0, cost = 0.0;
  long touched = 0;
  const long steps = std::lround(duration / scene.config.step);
  std::vector<Eigen::Vector3d> before;
  for (long i = 0; i < steps; ++i) {
    before.clear();
    for (int r = -1; i + 1 == steps && r < others; ++r) {
      for (int k = 0; k < links; ++k) before.push_back(link(r, k).translation());
    }
    const double begin = thread_cpu_seconds();
    if (world.step() != Status::kOk) {
      std::printf("diverged at %g s\n", scene.config.step * static_cast<double>(i));
      return 1;
    }
    cost += thread_cpu_seconds() - begin;
    touched += std::any_of(world.solved().begin(), world.solved().end(), among_robots) ? 1 : 0;
    for (int r = -1; r < others; ++r) tilt = std::max(tilt, tilt_degrees(link(r, 0)));
    for (const Tie& tie : scene.config.ties) {
      gap = std::max(gap, (link(-1, tie.a.link) * tie.a.point -
                           link(tie.b.robot, tie.b.link) * tie.b.point)
                              .norm());
    }
  }
  for (int r = -1; r < others; ++r) {
    for (int k = 0; k < links; ++k) {
      const Eigen::Vector3d moved = link(r, k).translation() - before[at((r + 1) * links + k)];
      fastest = std::max(fastest, moved.norm() / scene.config.step);
    }
  }
  std::printf("fastest %.4e tilt %.4f gap %.3e touched %ld unconverged %ld step_us %.3f\n", fastest,
              tilt, gap, touched, world.unconverged(), 1e6 * cost / static_cast<double>(steps));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  return run(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "physics_robots: %s\n", error.what());
  return 1;
}
