// One engine on one scene: cost and result, as lines that test/bench/bench_physics.py reads.
//
//     physics_cases mjcf  SCENE                        the scene for MuJoCo
//     physics_cases step  SCENE METHOD H [SECONDS]     us a step, median of batches
//     physics_cases alone SCENE METHOD H [SECONDS]     the same of steps that had the core to themselves, and their share
//     physics_cases run   SCENE METHOD H [REPEATS]     CPU ms per simulated s, where all links end
//     physics_cases brick METHOD H STIFFNESS DEGREES   stopping distance
//     physics_cases map   METHOD --gain G --stiffness K --step H   how a stand ends; K of a corner [N/m], H in seconds
//     physics_cases effort METHOD H                    worst excess over limits and stops, thrown
//     physics_cases hash  SCENE METHOD H [RESTORED]    of the whole trajectory; after that share
//                                                      of it a new world resumes it
//     physics_cases tumble METHOD H STIFFNESS FRICTION [THROWS]  boxes thrown, friction 0.3 to that
//     physics_cases boxes SHAPE METHOD H COUNT [SECONDS]  us a step of boxes lying apart or in a stack
//
// METHOD: articulated, articulated2 and articulated3 (orders 2, 3), ode, or articulated-ab4, -rk4, -rkf78, -gauss8 in flight;
// -gauss8-1e-7: in parts that are right to 1e-7 rad/s.  With +patch or +hunt_crossley behind it: with that contact law; with +tiles
// on tiles.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/process/process.h"
#include "sim/engine/make_world.h"
#include "sim/engine/articulated_world.h"
#include "common/math/random.h"
#include "sim/world/static_equilibrium.h"
#include "test/bench/core_alone.h"
#include "test/measure.h"
#include "test/bench/physics_scenes.h"

namespace twinbus {
namespace {

const std::string kGauss8 = "articulated-gauss8";

// Level ground of tiles with a seam between the soles and one across them.
void lay_tiles(WorldConfig& config) {
  constexpr double kEdge = 0.3, kThick = 0.1;  // [m]
  for (int i = -4; i < 4; ++i) {
    for (int k = -4; k < 4; ++k) {
      Obstacle tile;
      tile.shape = ObstacleShape::kBox;
      tile.size << kEdge, kEdge, kThick;
      tile.pose.translation() << kEdge * (i + 0.5), kEdge * (k + 0.5), -0.5 * kThick;
      config.tiles.push_back(tile);
    }
  }
}

WorldConfig config_of(const PhysicsScene& scene, const std::string& asked, double h) {
  WorldConfig config;
  std::istringstream words(asked);
  std::string method;
  std::getline(words, method, '+');
  for (std::string word; std::getline(words, word, '+');) {
    if (word == "tiles") {
      lay_tiles(config);
    } else if (!contact_of(word, config.contact)) {
      throw std::runtime_error("no contact law '" + word + "'");
    }
  }
  config.step = h;
  config.fixed_base = scene.fixed_base;
  if (method == "ode") {
    config.engine = Engine::kOde;
  } else if (method == "articulated2") {
    config.order = 2;
  } else if (method == "articulated3") {
    config.order = 3;
  } else if (method == "articulated-ab4") {
    config.flight = Flight::kAb4;
  } else if (method == "articulated-rk4") {
    config.flight = Flight::kRk4;
  } else if (method == "articulated-rkf78") {
    config.flight = Flight::kRkf78;
  } else if (method.rfind(kGauss8, 0) == 0) {
    config.flight = Flight::kGauss8;
    const std::string most = method.substr(kGauss8.size());
    config.flight_error = most.empty() ? 0.0 : std::atof(most.c_str() + 1);
  } else if (method != "articulated") {
    throw std::runtime_error("no method '" + method + "'");
  }
  return config;
}

void begin(World& world, const PhysicsScene& scene) {
  if (world.set(scene.start, &scene.tau) != Status::kOk) throw std::runtime_error("bad start");
  for (std::size_t j = 0; j < scene.servos.size(); ++j) {
    (void)world.set_servo(static_cast<int>(j), scene.servos[j]);
  }
}

long steps_of(double duration, double h) { return std::lround(duration / h); }

void time_steps(const std::string& name, const std::string& method, double h, double seconds) {
  const PhysicsScene scene = physics_scene(name);
  const auto world = make_world(scene.model, config_of(scene, method, h));
  begin(*world, scene);
  const double begun = thread_cpu_seconds();
  std::vector<double> batches;
  const long most = steps_of(scene.duration, h);
  long done = 0;
  while (thread_cpu_seconds() - begun < seconds) {
    constexpr int kBatch = 32;
    const double t = thread_cpu_seconds();
    for (int i = 0; i < kBatch; ++i) {
      if (world->step() != Status::kOk) throw std::runtime_error("diverged");
    }
    batches.push_back(1e6 * (thread_cpu_seconds() - t) / kBatch);
    done += kBatch;
    if (done + kBatch > most) {
      begin(*world, scene);
      done = 0;
    }
  }
  std::printf("step %s %s %g us %.4f\n", name.c_str(), method.c_str(), h, median(batches));
}

void time_steps_alone(const std::string& name, const std::string& method, double h,
                      double seconds) {
  const PhysicsScene scene = physics_scene(name);
  const auto world = make_world(scene.model, config_of(scene, method, h));
  test::CoreAlone core;
  test::SharedTimes times;
  const long most = steps_of(scene.duration, h);
  const double begun = thread_cpu_seconds();
  while (thread_cpu_seconds() - begun < seconds) {
    begin(*world, scene);
    bool before = core.alone();
    for (long i = 0; i < most; ++i) {
      const std::int64_t then = monotonic_ns();
      if (world->step() != Status::kOk) throw std::runtime_error("diverged");
      const double us = 1e-3 * static_cast<double>(monotonic_ns() - then);
      const bool after = core.alone();
      times.add(us, before && after);
      before = after;
    }
  }
  std::printf("alone %s %s %g share %.3f us %.4f\n", name.c_str(), method.c_str(), h,
              times.share_alone(), times.alone(0.5));
}

void run(const std::string& name, const std::string& method, double h, int repeats) {
  const PhysicsScene scene = physics_scene(name);
  const auto world = make_world(scene.model, config_of(scene, method, h));
  const long steps = steps_of(scene.duration, h);
  std::vector<double> costs;
  double total = 0.0;
  for (int r = 0; r < repeats || (total < 0.02 && r < 50 * repeats); ++r) {
    begin(*world, scene);
    const double t = thread_cpu_seconds();
    for (long i = 0; i < steps; ++i) {
      if (world->step() != Status::kOk) {
        std::printf("run %s %s %g failed %g\n", name.c_str(), method.c_str(), h,
                    static_cast<double>(i) * h);
        return;
      }
    }
    costs.push_back(1e3 * (thread_cpu_seconds() - t) / scene.duration);
    total += thread_cpu_seconds() - t;
  }
  std::printf("run %s %s %g ms_per_s %.6f at", name.c_str(), method.c_str(), h, median(costs));
  for (int i = 0; i < scene.model.link_count(); ++i) {
    const Eigen::Vector3d com =
        world->link_in_world(i) * scene.model.links[static_cast<std::size_t>(i)].com;
    std::printf(" %.17g %.17g %.17g", com.x(), com.y(), com.z());
  }
  if (const auto* ours = dynamic_cast<const ArticulatedWorld*>(world.get())) {
    const SolveCounters& c = ours->counters();
    std::printf(" counters %ld %ld %ld %ld %ld", c.steps, c.newton, ours->unconverged(),
                ours->joint_passes(), ours->unsettled());
  }
  std::printf("\n");
}

void brick(const std::string& method, double h, double stiffness, double degrees) {
  PhysicsScene scene = physics_scene("slide");
  WorldConfig config = config_of(scene, method, h);
  config.ground_friction = 0.8;
  for (Sole& sole : scene.model.soles) {  // four corners a sole
    sole.stiffness = kSoleCorners * stiffness;
    sole.damping = kSoleCorners * std::sqrt(stiffness * scene.model.total_mass() / 8.0);
  }
  const double weight = scene.model.total_mass() * kGravity;
  scene.start.base.translation().z() = -weight / (8.0 * stiffness);
  const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, Eigen::Vector3d::UnitZ());
  // The brick is turned with its way: it pitches on its springs, and along a diagonal less so.
  scene.start.base.linear() = turn.toRotationMatrix();
  scene.start.base_velocity = turn * Eigen::Vector3d(1.0, 0.0, 0.0);
  const auto world = make_world(scene.model, config);
  begin(*world, scene);
  for (long i = 0; i < steps_of(0.4, h); ++i) {
    if (world->step() != Status::kOk) throw std::runtime_error("diverged");
  }
  const double way = world->configuration().base.translation().head<2>().norm();
  const double exact = 1.0 / (2.0 * 0.8 * kGravity);
  std::printf("brick %s %g %g %g way %.9g off %.9g\n", method.c_str(), h, stiffness, degrees, way,
              way / exact - 1.0);
}

// Whether a stand that begins with a shove of 20 mm/s is quiet and upright in its last part.
const char* stands(const PhysicsScene& scene, const WorldConfig& config) {
  const auto world = make_world(scene.model, config);
  PhysicsScene shoved = scene;
  shoved.start.base_velocity = {0.02, 0.02, 0.0};
  begin(*world, shoved);
  const double height = scene.start.base.translation().z();
  const long steps = steps_of(1.2, config.step);
  for (long i = 0; i < steps; ++i) {
    if (world->step() != Status::kOk) return "diverged";
    if (i < 2 * steps / 3) continue;
    const Configuration& c = world->configuration();
    if (!(c.base.linear()(2, 2) > 0.98) || !(std::abs(c.base.translation().z() - height) < 0.03)) {
      return "fell";
    }
    for (const ContactPoint& contact : world->contacts()) {
      if (!(contact.depth < 5e-3)) return "sank";
    }
    for (int k = 0; k < scene.model.link_count(); ++k) {
      if (!(world->point_velocity(k, world->link_in_world(k).translation()).norm() < 0.5)) {
        return "shakes";
      }
    }
  }
  return "stable";
}

// In balance on ground of that stiffness: what soft ground is pressed in would throw the robot off hard one.
void stand_on(double stiffness, PhysicsScene& scene) {
  const Standing standing =
      stand(scene.model, scene.start.q, 1.0, {stiffness, stiffness}, {0.0, 0.0}, false);
  scene.start = standing.configuration;
  scene.tau = standing.tau;
  for (std::size_t j = 0; j < scene.servos.size(); ++j)
    scene.servos[j].tau = standing.tau[static_cast<Eigen::Index>(j)];
}

// One cell of the map; prints {"result": WORD}.
void map(const std::string& method, double gain, double stiffness, double h) {
  PhysicsScene scene = physics_scene("stand", gain);
  for (Sole& sole : scene.model.soles) {
    sole.stiffness = kSoleCorners * stiffness;
    sole.damping = kSoleCorners * std::sqrt(stiffness * 15.0);
  }
  stand_on(stiffness, scene);
  std::printf("{\"result\": \"%s\"}\n", stands(scene, config_of(scene, method, h)));
}

void effort(const std::string& method, double h) {
  PhysicsScene scene = physics_scene("throw", 100.0);
  const auto world = make_world(scene.model, config_of(scene, method, h));
  for (std::size_t j = 0; j < scene.servos.size(); ++j) scene.servos[j].q += 2.0;
  begin(*world, scene);
  double over = 0.0, beyond = 0.0;
  for (long i = 0; i < steps_of(scene.duration, h); ++i) {
    if (world->step() != Status::kOk) throw std::runtime_error("diverged");
    for (int j = 0; j < scene.model.joint_count(); ++j) {
      const Joint& joint = scene.model.joints[static_cast<std::size_t>(j)];
      const double q = world->configuration().q[j];
      over = std::max(over, std::abs(world->tau(j)) / joint.effort - 1.0);
      beyond = std::max({beyond, q - joint.upper, joint.lower - q});
    }
  }
  std::printf("effort %s %g over %.3g beyond %.3g\n", method.c_str(), h, over, beyond);
}

std::unique_ptr<World> restored(const World& world, const PhysicsScene& scene,
                                const WorldConfig& config) {
  auto copy = std::make_unique<ArticulatedWorld>(scene.model, config);
  const auto* ours = dynamic_cast<const ArticulatedWorld*>(&world);
  if (ours == nullptr || !copy->resume(*ours)) throw std::runtime_error("cannot be restored");
  return copy;
}

// restored_at: a share of the time, 1: never.
void hash(const std::string& name, const std::string& method, double h, double restored_at) {
  const PhysicsScene scene = physics_scene(name);
  const WorldConfig config = config_of(scene, method, h);
  auto world = make_world(scene.model, config);
  begin(*world, scene);
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  const auto mix = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    sum = (sum ^ bits) * 0x100000001b3ULL;
  };
  const long steps = steps_of(scene.duration, h),
             pause = std::lround(restored_at * static_cast<double>(steps));
  for (long i = 0; i < steps; ++i) {
    if (i == pause) world = restored(*world, scene, config);
    if (world->step() != Status::kOk) throw std::runtime_error("diverged");
    const Configuration& c = world->configuration();
    for (int j = 0; j < scene.model.joint_count(); ++j) mix(c.q[j]);
    for (int k = 0; k < 3; ++k) mix(c.base.translation()[k]);
  }
  std::printf("hash %s %s %g %016llx\n", name.c_str(), method.c_str(), h,
              static_cast<unsigned long long>(sum));
}

// Boxes of 0.03 to 30 kg thrown with spin, one at a time, for a second each.
void tumble(const std::string& method, double h, double stiffness, double friction, int throws) {
  PhysicsScene scene = physics_scene("chain1");
  scene.fixed_base = true;
  Random random(3);
  const auto u = [&random] { return 2.0 * random.uniform() - 1.0; };
  long touching = 0, retried = 0, unconverged = 0, newton = 0;
  double excess = 0.0, gain = 0.0;
  for (int thrown = 0; thrown < throws; ++thrown) {
    WorldConfig config = config_of(scene, method, h);
    LooseBody box;
    box.mass = std::pow(10.0, 1.5 * u());
    box.solid.size = {0.2, 0.3, 0.1};
    box.stiffness = stiffness;
    box.damping = std::sqrt(15.0 * stiffness);
    box.friction = config.ground_friction = 0.3 + (friction - 0.3) * std::abs(u());
    const double x = u(), y = u(), z = u(), w = u();
    box.start.pose.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    box.start.pose.translation().z() = 0.2;
    const double vx = 2.0 * u(), vy = 2.0 * u();
    box.start.velocity = {vx, vy, -1.0};
    const double wx = u(), wy = u(), wz = u();
    box.start.angular_velocity = 10.0 * Eigen::Vector3d(wx, wy, wz);
    const Eigen::Vector3d inertia = inertia_of(box.solid, box.mass).diagonal();
    const auto energy = [&](const LooseState& s) {
      const Eigen::Vector3d spin = s.pose.linear().transpose() * s.angular_velocity;
      return 0.5 * box.mass * s.velocity.squaredNorm() +
             0.5 * spin.dot(inertia.cwiseProduct(spin)) +
             box.mass * kGravity * s.pose.translation().z();
    };
    config.loose = {box};
    ArticulatedWorld world(scene.model, config);
    const double start = energy(box.start);
    for (long i = 0; i < steps_of(1.0, h); ++i) {
      if (world.step() != Status::kOk) throw std::runtime_error("diverged");
      bool touches = false;
      for (const Contact& c : world.solved()) {
        touches = touches || c.now.mode != ContactMode::kOpen;
        const double fn = c.normal.dot(c.now.force);
        const double ft = (c.now.force - fn * c.normal).norm();
        if (fn > 0.0) excess = std::max(excess, (ft - c.params.friction * fn) / fn);
      }
      touching += touches ? 1 : 0;
    }
    gain = std::max(gain, energy(world.loose(0)) / start - 1.0);
    unconverged += world.unconverged();
    retried += world.counters().unconverged - world.unconverged();
    newton += world.counters().newton;
  }
  std::printf(
      "tumble %s %g %g %g touching %ld unconverged %ld retried %ld newton %ld excess %.3g gain "
      "%.3g\n",
      method.c_str(), h, stiffness, friction, touching, unconverged, retried, newton, excess, gain);
}

// Boxes of 1 kg on the ground, apart or one on another, and nothing else that moves.
void time_boxes(const std::string& shape, const std::string& method, double h, int count,
                double seconds) {
  if (shape != "apart" && shape != "stack")
    throw std::runtime_error("boxes lie apart or in a stack");
  if (count < 1 || count > 10000) throw std::runtime_error("boxes: 1 to 10000 of them");
  PhysicsScene scene = physics_scene("chain1");
  scene.fixed_base = true;
  scene.start = Configuration(scene.model);
  scene.start.q.setZero();
  scene.start.qd.setZero();
  WorldConfig config = config_of(scene, method, h);
  const double edge = 0.2;  // [m]
  const int row = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    LooseBody box;
    box.name = std::string("box") + std::to_string(i);
    box.solid.size.setConstant(edge);
    box.stiffness = 1e6;
    box.damping = 1e3;
    box.friction = 0.8;
    config.ground_friction = 0.8;
    Eigen::Vector3d at(0.5 * (i % row), 0.5 * (i / row), 0.5 * edge);
    if (shape == "stack") at = {0.0, 0.0, (i + 0.5) * edge};
    box.start.pose.translation() = at;
    config.loose.push_back(box);
  }
  const auto world = make_world(scene.model, config);
  begin(*world, scene);
  std::vector<double> costs;
  const double begun = thread_cpu_seconds();
  for (long i = 0; i < 100 || thread_cpu_seconds() - begun < seconds; ++i) {
    const double t = thread_cpu_seconds();
    if (world->step() != Status::kOk) throw std::runtime_error("diverged");
    if (i >= 50 || t - begun > 2.0) costs.push_back(1e6 * (thread_cpu_seconds() - t));
    if (i >= 5 && t - begun > 20.0) break;  // an engine that takes for ever
  }
  const LooseState top = world->loose(count - 1);
  const double off = (top.pose.translation() - config.loose.back().start.pose.translation()).norm();
  std::printf("boxes %s %s %g %d us %.4f off %.6f", shape.c_str(), method.c_str(), h, count,
              median(costs), off);
  if (const auto* ours = dynamic_cast<const ArticulatedWorld*>(world.get())) {
    const SolveCounters& c = ours->counters();
    std::printf(" counters %ld %ld %ld %ld", c.steps, c.one_pass, c.newton, ours->unconverged());
  }
  std::printf("\n");
}

int cases(int argc, char** argv) {
  const auto word = [&](int i) -> std::string {
    if (i >= argc) throw std::runtime_error("too few words; see the head of physics_cases.cpp");
    return argv[i];
  };
  const auto number = [&](int i, double otherwise) {
    return i < argc ? std::atof(argv[i]) : otherwise;
  };
  const std::string what = word(1);
  if (what == "mjcf") {
    std::fputs(mjcf(physics_scene(word(2), number(3, 1.0))).c_str(), stdout);
  } else if (what == "step") {
    time_steps(word(2), word(3), number(4, 1e-3), number(5, 0.3));
  } else if (what == "alone") {
    time_steps_alone(word(2), word(3), number(4, 1e-3), number(5, 0.3));
  } else if (what == "run") {
    run(word(2), word(3), number(4, 1e-3), static_cast<int>(number(5, 3)));
  } else if (what == "brick") {
    brick(word(2), number(3, 1e-3), number(4, 1e6), number(5, 0.0));
  } else if (what == "map") {
    double gain = 1.0, stiffness = 1e6, h = 1e-3;
    for (int i = 3; i + 1 < argc; i += 2) {
      const std::string key = argv[i];
      double* value = key == "--gain" ? &gain : key == "--stiffness" ? &stiffness : key == "--step" ? &h : nullptr;
      if (value == nullptr) throw std::runtime_error("map: no option " + key);
      *value = std::atof(argv[i + 1]);
    }
    map(word(2), gain, stiffness, h);
  } else if (what == "effort") {
    effort(word(2), number(3, 1e-3));
  } else if (what == "hash") {
    hash(word(2), word(3), number(4, 1e-3), number(5, 1.0));
  } else if (what == "tumble") {
    tumble(word(2), number(3, 1e-3), number(4, 1e6), number(5, 0.8),
           static_cast<int>(number(6, 40)));
  } else if (what == "boxes") {
    time_boxes(word(2), word(3), number(4, 1e-3), static_cast<int>(number(5, 20)), number(6, 0.5));
  } else {
    throw std::runtime_error("no case '" + what + "'");
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("physics_cases", &twinbus::cases, argc, argv);
}
