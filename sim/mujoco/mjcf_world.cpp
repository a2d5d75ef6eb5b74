#include "sim/mujoco/mjcf_world.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "common/math/index.h"
#include "common/text/xml.h"
#include "robot/mjcf/urdf_text.h"

namespace twinbus::inline sim {

namespace {

// Who touches whom, in MuJoCo's bits: 1 links and soles, 2 the other shapes of feet, 4 loose bodies.  Obstacles and loose bodies
// meet all; ground and tiles meet a foot by its sole alone, as in the other engines: twice as many contacts were half as soft.
// Links of the robot meet one another on request.
constexpr const char* kGroundBits = " contype=\"0\" conaffinity=\"5\"";
constexpr const char* kFixedBits = " contype=\"0\" conaffinity=\"7\"";
constexpr const char* kLooseBits = " contype=\"4\" conaffinity=\"7\"";
constexpr const char* kRobotBits = "contype=\"1\" conaffinity=\"4\"";
constexpr const char* kFootBits = "contype=\"2\" conaffinity=\"4\"";
constexpr const char* kSelfBits = "contype=\"1\" conaffinity=\"7\"";
constexpr const char* kSelfFootBits = "contype=\"2\" conaffinity=\"7\"";

Shape to_shape(const Obstacle& obstacle) {
  Shape shape;
  shape.kind = obstacle.shape == ObstacleShape::kSphere     ? ShapeKind::kSphere
               : obstacle.shape == ObstacleShape::kCylinder ? ShapeKind::kCylinder
                                                            : ShapeKind::kBox;
  shape.size = obstacle.size;
  shape.pose = obstacle.pose;
  return shape;
}

std::string loose_geom(const LooseBody& body) {
  switch (body.solid.shape) {
    case SolidShape::kBox:
      return "type=\"box\" size=\"" + exact_numbers(0.5 * body.solid.size) + "\"";
    case SolidShape::kSphere:
      return "type=\"sphere\" size=\"" + exact_number(body.solid.size[0]) + "\"";
    case SolidShape::kCylinder:
    case SolidShape::kCapsule:
      return std::string("type=\"") + (body.solid.shape == SolidShape::kCapsule ? "capsule" : "cylinder") + "\" size=\"" +
             exact_number(body.solid.size[0]) + " " + exact_number(0.5 * body.solid.size[1]) + "\"";
  }
  return "";
}

std::string free_state(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return exact_numbers(pose.translation()) + " " + exact_number(q.w()) + " " + exact_numbers(q.vec());
}

// Joints in the order of MuJoCo's qpos: the body writer goes depth first, and so do the joints of a Model.
std::string keyframe(const Model& model, const WorldConfig& config, const Configuration& start) {
  std::string qpos, qvel;
  if (model.floating_base) {
    qpos = free_state(start.base);
    qvel = "0 0 0 0 0 0";
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    qpos += " " + exact_number(start.q[j]);
    qvel += " " + exact_number(start.qd[j]);
  }
  for (const LooseBody& body : config.loose) {
    if (body.mesh != nullptr) continue;
    qpos += " " + free_state(body.start.pose);
    // MuJoCo's angular velocities of a free body are in its own axes.
    qvel += " " + exact_numbers(body.start.velocity) + " " +
            exact_numbers(body.start.pose.linear().transpose() * body.start.angular_velocity);
  }
  std::string ctrl;
  for (const int j : model.bus_joints) ctrl += " " + exact_number(model.joints[at(j)].kp > 0.0 ? start.q[j] : 0.0);
  return "    <key name=\"start\" qpos=\"" + qpos + "\" qvel=\"" + qvel + "\" ctrl=\"" + ctrl + "\"/>\n";
}

// Links whose largest moment of inertia is more than the sum of the others: MuJoCo refuses them.
std::string unbalanced_links(const Model& model) {
  std::string names;
  for (const Link& link : model.links) {
    if (!(link.mass > 0.0)) continue;
    const Eigen::Vector3d moments =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia, Eigen::EigenvaluesOnly).eigenvalues();
    if (moments[0] + moments[1] < moments[2]) names += (names.empty() ? "" : ", ") + link.name;
  }
  return names;
}

// yielding: what touches them decides, for robot.yaml has contacts of MuJoCo.
std::string still_things(const WorldConfig& config, bool engine, bool yielding, ExportedMeshes& meshes) {
  const std::string friction = std::string("friction=\"0 ") + (yielding ? "0 0\" condim=\"1\" solmix=\"0\"" : "0.005 0.0001\"");
  std::string out = "    <geom name=\"ground\" type=\"plane\" size=\"20 20 0.1\" " + friction +
                    (engine ? kGroundBits : "") + "/>\n";
  for (const Shape& each : shapes_of(config.obstacles))
    out += "    " + mjcf_geom(each, friction + (engine ? kFixedBits : ""), meshes) + "\n";
  for (const Shape& each : shapes_of(config.tiles))
    out += "    " + mjcf_geom(each, friction + (engine ? kGroundBits : ""), meshes) + "\n";
  return out;
}

// Servos of an export want an implicit integrator, and that one contacts which are solved to the end.  In the engine nothing is left
// for it to do, and Euler goes on with the acceleration of a solver that was stopped early, as MuJoCo does in a training.
std::string solver_options(const MujocoConfig& mujoco, bool engine) {
  const bool early = engine && mujoco.iterations > 0;
  std::string out = std::string(" integrator=\"") + (early ? "Euler" : "implicitfast") + "\"";
  const auto count = [&](const char* key, int value) {
    if (value > 0) out += std::string(" ") + key + "=\"" + std::to_string(value) + "\"";
  };
  if (early) count("iterations", mujoco.iterations);
  if (engine) count("ls_iterations", mujoco.ls_iterations);
  count("noslip_iterations", mujoco.noslip_iterations);
  if (mujoco.elliptic) out += " cone=\"elliptic\"";
  if (mujoco.impratio != 1.0) out += " impratio=\"" + exact_number(mujoco.impratio) + "\"";
  return out;
}

std::string loose_bodies(const WorldConfig& config, bool engine) {
  std::string out;
  for (std::size_t i = 0; i < config.loose.size(); ++i) {
    const LooseBody& body = config.loose[i];
    if (body.mesh != nullptr) continue;
    out += "    <body name=\"" + xml_escaped(body.name) + "\" " + mjcf_place(body.start.pose) + ">\n      <freejoint name=\"" +
           mjcf_loose_joint(i) + "\"/>\n      <geom " + loose_geom(body) + " mass=\"" + exact_number(body.mass) +
           "\" friction=\"" +
           exact_number(std::sqrt(body.friction * config.ground_friction)) + " 0.005 0.0001\"" + (engine ? kLooseBits : "") +
           "/>\n    </body>\n";
  }
  return out;
}

}  // namespace

std::vector<Shape> shapes_of(const std::vector<Obstacle>& obstacles) {
  std::vector<Shape> shapes;
  for (const Obstacle& each : obstacles) {
    if (each.shape != ObstacleShape::kNone) shapes.push_back(to_shape(each));
  }
  return shapes;
}

std::string mjcf_loose_joint(std::size_t body) { return "loose/" + std::to_string(body); }

MjcfWorld mjcf_of_world(const std::string& name, const Model& model, const WorldConfig& config, const Configuration& start,
                        MjcfUse use, ExportedMeshes& meshes) {
  const bool engine = use == MjcfUse::kEngine;
  const MjcfContact contact{.ground_friction = config.ground_friction,
                            .robot_bits = !engine ? "" : config.self_contact ? kSelfBits : kRobotBits,
                            .foot_bits = !engine ? "" : config.self_contact ? kSelfFootBits : kFootBits};
  const MujocoConfig& mujoco = model.mujoco;
  const MjcfParts parts{.visual = !engine, .placeable = engine, .drives = !engine};
  const MjcfText robot = mjcf_of_model(model, start.base, contact, meshes, parts);
  std::string assets;
  const std::string things = still_things(config, engine, !mujoco.contacts.empty(), meshes);
  for (const auto& [mesh, shape] : meshes.all())
    assets += "    <mesh name=\"" + xml_escaped(mesh) + "\" file=\"" + xml_escaped(mesh) + ".obj\"/>\n";
  MjcfWorld world;
  world.geoms = robot.geoms;
  world.unbalanced = unbalanced_links(model);
  std::string& out = world.xml;
  out = "<mujoco model=\"" + xml_escaped(name) +
        "\">\n  <!-- Written by `twinbus export`.  Friction of bodies is put together with the ground's, whose own is "
        "0. -->\n  <compiler angle=\"radian\" meshdir=\"meshes\"" +
        std::string(world.unbalanced.empty() ? "" : " balanceinertia=\"true\"") + "/>\n  <option timestep=\"" +
        exact_number(config.step) + "\"" + solver_options(mujoco, engine) + " gravity=\"0 0 -9.81\"" +
        (engine ? ">\n    <flag autoreset=\"disable\"/>\n  </option>\n" : "/>\n") +
        "  <default>\n    <default class=\"visual\">\n"
        "      <geom contype=\"0\" conaffinity=\"0\" group=\"2\" density=\"0\"/>\n    </default>\n"
        "    <default class=\"collision\">\n      <geom group=\"3\"/>\n    </default>\n  </default>\n";
  const auto section = [&](const char* of, const std::string& inside) {
    if (!inside.empty()) out += std::string("  <") + of + ">\n" + inside + "  </" + of + ">\n";
  };
  section("asset", assets);
  section("worldbody", things + robot.body + loose_bodies(config, engine));
  section("contact", robot.contact);
  section("equality", robot.equality);
  section("actuator", robot.actuator);
  section("sensor", engine ? "" : robot.sensor);
  section("keyframe", engine ? "" : keyframe(model, config, start));
  out += "</mujoco>\n";
  return world;
}

}  // namespace twinbus::sim
