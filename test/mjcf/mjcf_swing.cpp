// Lets a robot fall and swing without servos, and prints where its links are at the end.
//
//     mjcf_swing ROBOT SECONDS STEP [limits] [friction] [ground]
//
// ROBOT: a folder with robot.yaml, or an MJCF file, read as `twinbus check` reads it.
// The words switch on what is otherwise left out: joint limits, the joints' Coulomb friction, the ground (the base is else 100 m
// above it, with ground a free one begins at 1 m).  It begins in the zero posture, joint k at 0.4 sin(k + 1) rad/s (or m/s),
// each number within the limits.  A line a link of the URDF: name, origin, and the point (0.1, 0.1, 0.1) of its frame [m].  A line a joint first:
// name, position and speed at the start.  mujoco_compare.py does the same in MuJoCo.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "robot/description/load.h"
#include "robot/description/srdf.h"
#include "robot/mjcf/mjcf_document.h"
#include "robot/mjcf/mjcf_to_urdf.h"
#include "robot/onboarding/proposal.h"
#include "sim/engine/make_world.h"

using namespace twinbus;

namespace {

constexpr double kHigh = 100.0;  // [m]

struct Wish {
  std::string robot;
  double seconds = 0.0, step = 0.0;
  bool limits = false, friction = false, ground = false;
};

Model load(const std::string& name) {
  if (!is_mjcf_name(name)) return load_robot(name);
  const MjcfRobot robot = import_mjcf(name);
  std::vector<std::pair<std::string, std::string>> packages;
  UrdfRepairs repairs;
  Model model = load_repaired_urdf(with_packages(robot.urdf, name, packages), name, packages, repairs);
  model.floating_base = robot.floating;
  for (const SrdfRotor& rotor : parse_srdf(robot.srdf, name).rotors)
    model.joints[at(model.find_joint(rotor.joint))].rotor_inertia = rotor.reflected_inertia;
  return model;
}

void leave_out(const Wish& wish, Model& model) {
  for (Joint& joint : model.joints) {
    if (!wish.limits) {
      joint.lower = -std::numeric_limits<double>::infinity();
      joint.upper = std::numeric_limits<double>::infinity();
    }
    if (!wish.friction) joint.friction = 0.0;
  }
}

Configuration start_of(const Model& model, const Wish& wish) {
  Configuration start(model);
  if (!wish.ground) start.base.translation().z() = kHigh;
  else if (model.floating_base) start.base.translation().z() = 1.0;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    start.q[j] = std::clamp(0.0, joint.lower, joint.upper);
    start.qd[j] = 0.4 * std::sin(j + 1.0);
    if (joint.mimic >= 0)
      throw std::runtime_error("joint " + joint.name + " follows another one; such robots are not compared");
    std::printf("joint %s %.17g %.17g\n", joint.name.c_str(), start.q[j], start.qd[j]);
  }
  return start;
}

int swing(const Wish& wish) {
  Model model = load(wish.robot);
  const Configuration start = start_of(model, wish);
  leave_out(wish, model);
  WorldConfig config;
  config.step = wish.step;
  config.order = 2;
  config.flight = Flight::kRk4;
  config.fixed_base = !model.floating_base;
  const auto world = make_world(model, config);
  if (world->set(start) != Status::kOk) throw std::runtime_error("the start is refused");
  for (int j = 0; j < model.joint_count(); ++j) (void)world->set_servo(j, ServoTarget());
  const long steps = std::lround(wish.seconds / wish.step);
  for (long i = 0; i < steps; ++i) {
    if (world->step() != Status::kOk) throw std::runtime_error("the world diverged");
  }
  Eigen::Vector3d below = Eigen::Vector3d::Zero();  // MuJoCo has a fixed base where its file puts it
  if (config.fixed_base) below = start.base.translation();
  for (const Frame& frame : model.frames) {
    const Eigen::Isometry3d place = world->link_in_world(frame.link) * frame.in_link;
    const Eigen::Vector3d origin = place.translation() - below;
    const Eigen::Vector3d point = place * Eigen::Vector3d(0.1, 0.1, 0.1) - below;
    std::printf("link %s %.12f %.12f %.12f %.12f %.12f %.12f\n", frame.name.c_str(), origin.x(), origin.y(), origin.z(),
                point.x(), point.y(), point.z());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: mjcf_swing ROBOT SECONDS STEP [limits] [friction] [ground]\n");
    return 2;
  }
  Wish wish{.robot = argv[1], .seconds = std::atof(argv[2]), .step = std::atof(argv[3])};
  for (int i = 4; i < argc; ++i) {
    const std::string word = argv[i];
    wish.limits = wish.limits || word == "limits";
    wish.friction = wish.friction || word == "friction";
    wish.ground = wish.ground || word == "ground";
  }
  try {
    return swing(wish);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mjcf_swing: %s\n", error.what());
    return 1;
  }
}
