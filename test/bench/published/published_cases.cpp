// The tests of SimBenchmark in our engines: published_cases TEST METHOD STEP [ROBOT_FOLDER] prints
//
//     us_per_step C error E contacts N at X Y Z ...
//
// TEST: stand, drop, momentum (of a quadruped), atlas, balls, rolling, bouncing; METHOD: articulated, articulated2, articulated3 (orders),
// ode; gains instead prints of every joint its name, where it begins, kp and kd.  error, mean over the steps of its run: drop: of the energy, squared [J^2]; momentum: of the total momentum, squared
// [(kg m/s)^2]; balls: sum of squared depths [m^2]; rolling: of the velocities of box and first ball, squared [(m/s)^2]; bouncing: of the
// energy, squared [J^2]; stand and atlas: none, the places of all links after 2 s are printed.  C: median CPU time of equal runs in
// which nothing is measured.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "common/math/random.h"
#include "common/process/process.h"
#include "common/time/cpu_time.h"
#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "test/measure.h"
#include "test/sim/body_energy.h"
#include "test/sim/test_models.h"

namespace twinbus {
namespace {

struct Case {
  Model model;
  WorldConfig config;
  Configuration start;
  double seconds = 2.0;
  double force = 0.0;                                  // up on link 0, for the first second [N]
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();      // on the middle of link 0 [N]
  double kp = 0.0, kd = 0.0;                           // of every joint, to where it begins
  std::vector<double> gains, dampings;                 // instead, one for each joint
  std::function<double(const World&, double)> error;   // of the world at a time of the run
};

// A body of one link, with a wheel that weighs next to nothing: engines want a joint.
Model lone_box(const Eigen::Vector3d& size, double mass) {
  Model model = test::slider();
  model.name = "box";
  model.floating_base = true;
  const Eigen::Vector3d s = size.cwiseProduct(size);
  model.links[0] = test::make_link("box", -1, mass, {0, 0, 0}, mass / 12.0 * Eigen::Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()));
  Shape shape;
  shape.size = size;
  model.links[0].collision = {shape};
  model.links[1] = test::make_link("wheel", 0, 1e-6, {0, 0, 0}, {1e-9, 1e-9, 1e-9});
  model.joints[0] = test::make_joint("axle", 0, 1, {0, 0, 0}, {0, 0, 1}, 1.0);
  return model;
}

LooseBody ball(int number, double radius, double mass, const Eigen::Vector3d& at, double stiffness, double damping, double friction) {
  LooseBody body;
  body.name = "ball" + std::to_string(number);
  body.solid = {SolidShape::kSphere, {radius, 0, 0}};
  body.mass = mass;
  body.start.pose.translation() = at;
  body.stiffness = stiffness;
  body.damping = damping;
  body.friction = friction;
  return body;
}

// Joints without friction, rotors, stops and limits of effort: the tests have none.
Model bare_robot(const std::string& folder) {
  Model model = load_robot(folder);
  for (Joint& joint : model.joints) {
    joint.friction = joint.damping = joint.rotor_inertia = 0.0;
    joint.lower = -100.0;
    joint.upper = 100.0;
    joint.effort = 1e9;
  }
  return model;
}

Configuration posed(const Model& model, double height, const std::vector<double>& q) {
  Configuration start(model);
  start.base.translation().z() = height;
  for (std::size_t j = 0; j < q.size() && j < model.joints.size(); ++j) start.q[static_cast<Eigen::Index>(j)] = q[j];
  return start;
}

double energy_of(const World& world, const LooseBody& body, int number) {
  const LooseState state = world.loose(number);
  return body.mass * (0.5 * state.velocity.squaredNorm() + kGravity * state.pose.translation().z());
}

Case quadruped(const std::string& test, const std::string& folder) {
  Case c;
  c.model = bare_robot(folder);
  const std::vector<double> legs = {0.03, 0.4, -0.8, -0.03, 0.4, -0.8, 0.03, -0.4, 0.8, -0.03, -0.4, 0.8};
  c.start = posed(c.model, test == "stand" ? 0.54 : 2.0, legs);
  if (test == "stand") {
    c.kp = 40.0;
    c.kd = 1.0;
  } else if (test == "drop") {
    c.start.base.translation().z() = 2.0;
    c.force = 2.0 * c.model.total_mass() * kGravity;
    c.seconds = 3.0;
    auto kinematics = std::make_shared<Kinematics>(c.model);
    auto first = std::make_shared<double>(std::nan(""));
    c.error = [model = &c.model, kinematics, first](const World& world, double t) {
      if (t < 1.0 - 1e-9) return 0.0;
      const double e = test::energy(*model, world, *kinematics);
      if (std::isnan(*first)) *first = e;
      return (e - *first) * (e - *first) * 1.5;  // the mean is of the last two seconds of three
    };
  } else {  // weightless, which a flight far above the ground is: up for half of it, then down
    constexpr double kUp = 5.0 * kGravity;
    c.start.base.translation().z() = 1000.0;
    c.start.base_velocity.z() = kUp;
    c.config.loose = {ball(0, 0.2, 10.0, {0, -5.0, 1000.0}, 1e6, 100.0, 0.8)};
    c.config.loose[0].start.velocity = {0, 5.0, kUp};
    c.seconds = 10.0;
    c.error = [mass = c.model.total_mass()](const World& world, double t) {
      const Eigen::Vector3d p = mass * world.com_velocity() + 10.0 * world.loose(0).velocity;
      return (p - Eigen::Vector3d(0.0, 50.0, (mass + 10.0) * (kUp - kGravity * t))).squaredNorm();
    };
  }
  return c;
}

// Balls without friction, and a robot that is far from them.
Case balls_alone() {
  Case c;
  c.model = test::bystander();
  c.config.fixed_base = true;
  c.config.ground_friction = 0.0;
  c.start = Configuration(c.model);
  return c;
}

Case balls() {
  Case c = balls_alone();
  Random random(42);
  constexpr int kRow = 6;
  for (int i = 0; i < kRow * kRow * kRow; ++i) {
    Eigen::Vector3d at(i / (kRow * kRow), i / kRow % kRow, i % kRow);
    at = 0.21 * at + Eigen::Vector3d(0, 0, 0.101);
    for (int k = 0; k < 3; ++k) at[k] += 1e-3 * random.uniform();
    c.config.loose.push_back(ball(i, 0.1, 10.0, at, 2e6, 9e3, 0.0));
  }
  c.error = [](const World& world, double) {
    double sum = 0.0;
    for (int i = 0; i < world.loose_count(); ++i) {
      const Eigen::Vector3d a = world.loose(i).pose.translation();
      const double sunk = std::max(0.0, 0.1 - a.z());
      sum += sunk * sunk;
      for (int j = 0; j < i; ++j) {
        const double depth = std::max(0.0, 0.2 - (world.loose(j).pose.translation() - a).norm());
        sum += depth * depth;
      }
    }
    return sum;
  };
  return c;
}

// A box of 20 m that is pulled under 25 balls of 1 m; it slides on the ground, they roll on it.
Case rolling() {
  Case c;
  c.model = lone_box({20.0, 20.0, 1.0}, 10.0);
  c.start = posed(c.model, 0.5, {});
  constexpr double kUnder = 0.4, kOnIt = 0.8;  // friction wanted
  c.config.ground_friction = kUnder * kUnder / kLinkFriction;
  c.config.shell_stiffness = 1e7;
  for (int i = 0; i < 25; ++i)
    c.config.loose.push_back(ball(i, 0.5, 1.0, {2.0 * (i / 5) - 4.0, 2.0 * (i % 5) - 4.0, 1.5}, 1e7, 1e3, kOnIt * kOnIt / kLinkFriction));
  constexpr double kForce = 150.0, kBox = 10.0, kBall = 1.0, kBalls = 25.0;
  const Eigen::Vector3d along(0.5, std::sqrt(0.75), 0.0);
  c.pull = kForce * along;
  c.seconds = 4.0;
  const double under = kUnder * (kBox + kBalls * kBall) * kGravity;
  const double on_ball = (kForce - under) / kBox / (3.5 / kBall + kBalls / kBox);
  const double of_box = (kForce - under - kBalls * on_ball) / kBox, of_ball = on_ball / kBall;
  c.error = [=](const World& world, double t) {
    return (world.configuration().base_velocity - of_box * t * along).squaredNorm() +
           (world.loose(0).velocity - of_ball * t * along).squaredNorm();
  };
  return c;
}

Case bouncing() {
  Case c = balls_alone();
  for (int i = 0; i < 49; ++i) c.config.loose.push_back(ball(i, 0.1, 10.0, {2.0 * (i / 7), 2.0 * (i % 7), 5.0}, 1e7, 0.0, 0.0));
  c.seconds = 20.0;
  c.error = [bodies = c.config.loose](const World& world, double) {
    double e = world.elastic_energy();
    for (std::size_t i = 0; i < bodies.size(); ++i) e += energy_of(world, bodies[i], static_cast<int>(i));
    const double off = e - 49.0 * 10.0 * kGravity * 5.0;
    return off * off;
  };
  return c;
}

// PD gains of the test by the joint's part of the body.
Case atlas(const std::string& folder) {
  Case c;
  c.model = bare_robot(folder);
  c.start = posed(c.model, 1.0, {});
  const std::vector<double> back_kp = {10000, 10000, 10000}, back_kd = {50, 50, 50};
  const std::vector<double> arm_kp = {20000, 10000, 1000, 1000, 1000, 100, 0.2}, arm_kd = {30, 10, 10, 5, 3, 0.5, 0.01};
  const std::vector<double> leg_kp = {20000, 50000, 50000, 30000, 10000, 20000}, leg_kd = {40, 40, 40, 5, 2, 10};
  int back = 0, arm[2] = {0, 0}, leg[2] = {0, 0};
  for (const Joint& joint : c.model.joints) {
    const bool right = joint.name.rfind("r_", 0) == 0;
    const auto next = [&](const std::vector<double>& kp, const std::vector<double>& kd, int& n) {
      const auto i = static_cast<std::size_t>(std::min<int>(n++, static_cast<int>(kp.size()) - 1));
      c.gains.push_back(kp[i]);
      c.dampings.push_back(kd[i]);
    };
    if (joint.name.find("_leg_") != std::string::npos) next(leg_kp, leg_kd, leg[right ? 1 : 0]);
    else if (joint.name.find("_arm_") != std::string::npos) next(arm_kp, arm_kd, arm[right ? 1 : 0]);
    else next(back_kp, back_kd, back);
  }
  return c;
}

Case case_of(const std::string& test, const std::string& folder) {
  if (test == "stand" || test == "drop" || test == "momentum") return quadruped(test, folder);
  if (test == "atlas") return atlas(folder);
  if (test == "balls") return balls();
  if (test == "rolling") return rolling();
  if (test == "bouncing") return bouncing();
  throw std::runtime_error("no test '" + test + "'");
}

struct Run {
  double error = 0.0, contacts = 0.0, seconds = 0.0;  // CPU
  long steps = 0;
  std::unique_ptr<World> world;
};

Run run(const Case& c, bool measured) {
  Run done;
  done.world = make_world(c.model, c.config);
  World& world = *done.world;
  if (world.set(c.start) != Status::kOk) throw std::runtime_error("bad start");
  for (int j = 0; j < c.model.joint_count(); ++j) {
    ServoTarget target{.q = c.start.q[j], .qd = 0, .tau = 0, .kp = c.kp, .kd = c.kd};
    if (!c.gains.empty()) target.kp = c.gains[at(j)], target.kd = c.dampings[at(j)];
    (void)world.set_servo(j, target);
  }
  done.steps = std::lround(c.seconds / c.config.step);
  const double begun = thread_cpu_seconds();
  for (long i = 0; i < done.steps; ++i) {
    const double t = static_cast<double>(i) * c.config.step;
    if (measured && c.error) done.error += c.error(world, t);
    if (measured) done.contacts += static_cast<double>(world.contacts().size());
    const Eigen::Vector3d middle = world.link_in_world(0).translation();
    if (t < 1.0 - 1e-9 && c.force != 0.0) (void)world.push(0, middle, {0, 0, c.force});
    if (!c.pull.isZero()) (void)world.push(0, middle, c.pull);
    if (world.step() != Status::kOk) throw std::runtime_error("diverged");
  }
  done.seconds = thread_cpu_seconds() - begun;
  done.error /= static_cast<double>(done.steps);
  done.contacts /= static_cast<double>(done.steps);
  return done;
}

int cases(int argc, char** argv) {
  if (argc < 4) throw std::runtime_error("too few words; see the head of published_cases.cpp");
  const std::string method = argv[2];
  Case c = case_of(argv[1], argc > 4 ? argv[4] : "");
  if (method == "gains") {
    for (std::size_t j = 0; j < c.model.joints.size(); ++j)
      std::printf("%s %g %g %g\n", c.model.joints[j].name.c_str(), c.start.q[static_cast<Eigen::Index>(j)], c.gains.empty() ? c.kp : c.gains[j],
                  c.gains.empty() ? c.kd : c.dampings[j]);
    return 0;
  }
  c.config.step = std::atof(argv[3]);
  if (method == "ode") c.config.engine = Engine::kOde;
  else if (method == "articulated2") c.config.order = 2;
  else if (method == "articulated3") c.config.order = 3;
  else if (method != "articulated") throw std::runtime_error("no method '" + method + "'");
  const Run measured = run(c, true);
  std::vector<double> costs;
  for (double spent = 0.0; costs.empty() || spent < 0.2;) {
    const Run timed = run(c, false);
    spent += timed.seconds;
    costs.push_back(1e6 * timed.seconds / static_cast<double>(timed.steps));
  }
  std::printf("us_per_step %.4f error %.8g contacts %.3f at", median(costs), measured.error, measured.contacts);
  for (int i = 0; i < c.model.link_count(); ++i) {
    const Eigen::Vector3d at = measured.world->link_in_world(i).translation();
    std::printf(" %.9g %.9g %.9g", at.x(), at.y(), at.z());
  }
  std::printf("\n");
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("published_cases", &twinbus::cases, argc, argv); }
