#include "launcher/export/export.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "common/math/index.h"
#include "common/process/arguments.h"
#include "launcher/run/judge_scene.h"
#include "robot/description/load.h"
#include "robot/mjcf/model_writer.h"
#include "robot/mjcf/urdf_text.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"
#include "sim/world/static_equilibrium.h"

namespace twinbus {

namespace {

namespace fs = std::filesystem;

struct Exported {
  Model model;
  Scene scene;
  Configuration start;
};

Exported load(const Arguments& arguments) {
  Exported all;
  all.scene = load_scene(arguments.word(0));
  const Model model = load_robot(arguments.text("--robot", all.scene.robot));
  fit_scene(all.scene, model);
  start_in(arguments.text("--start-pose", all.scene.start_pose), model, all.scene);
  apply_seed(all.scene, model, static_cast<std::uint64_t>(arguments.number("--seed", 1.0, 0.0, 1e9)));
  all.model = changed_model(model, all.scene);
  if (all.scene.fixed_base) all.model.floating_base = false;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.joint_count());
  if (const int pose = model.find_pose(all.scene.start_pose); pose >= 0) {
    const std::vector<double>& from = model.poses[at(pose)].q;
    q = Eigen::Map<const Eigen::VectorXd>(from.data(), static_cast<Eigen::Index>(from.size()));
  }
  const std::array<double, 2> stiffness = {0.25 * model.soles[0].stiffness, 0.25 * model.soles[1].stiffness};
  all.start = stand(all.model, q, 1.0, stiffness, {0.0, 0.0}, !all.model.floating_base).configuration;
  for (const auto& [name, speed] : all.scene.start_velocity) {
    const int joint = model.find_joint(name);
    if (joint < 0) throw std::runtime_error(all.scene.name + ": start_velocity: there is no joint " + name);
    all.start.qd[joint] = speed;
  }
  return all;
}

Shape to_shape(const Obstacle& obstacle) {
  Shape shape;
  shape.kind = obstacle.shape == ObstacleShape::kSphere     ? ShapeKind::kSphere
               : obstacle.shape == ObstacleShape::kCylinder ? ShapeKind::kCylinder
                                                            : ShapeKind::kBox;
  shape.size = obstacle.size;
  shape.pose = obstacle.pose;
  return shape;
}

std::vector<Shape> still_things(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const auto* list : {&scene.obstacles, &scene.tiles}) {
    for (const Obstacle& each : *list) {
      if (each.shape != ObstacleShape::kNone) shapes.push_back(to_shape(each));
    }
  }
  return shapes;
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
std::string keyframe(const Exported& all) {
  std::string qpos, qvel;
  if (all.model.floating_base) {
    qpos = free_state(all.start.base);
    qvel = "0 0 0 0 0 0";
  }
  for (int j = 0; j < all.model.joint_count(); ++j) {
    qpos += " " + exact_number(all.start.q[j]);
    qvel += " " + exact_number(all.start.qd[j]);
  }
  for (const LooseBody& body : all.scene.loose) {
    if (body.mesh != nullptr) continue;
    qpos += " " + free_state(body.start.pose);
    // MuJoCo's angular velocities of a free body are in its own axes.
    qvel += " " + exact_numbers(body.start.velocity) + " " +
            exact_numbers(body.start.pose.linear().transpose() * body.start.angular_velocity);
  }
  std::string ctrl;
  for (const int j : all.model.bus_joints)
    ctrl += " " + exact_number(all.model.joints[at(j)].kp > 0.0 ? all.start.q[j] : 0.0);
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

std::string mjcf_of(const Exported& all, ExportedMeshes& meshes) {
  const MjcfContact contact{.ground_friction = all.scene.ground_friction};
  const MjcfText robot = mjcf_of_model(all.model, all.start.base, contact, meshes);
  std::string world = "    <geom name=\"ground\" type=\"plane\" size=\"20 20 0.1\" friction=\"0 0.005 0.0001\"/>\n";
  for (const Shape& shape : still_things(all.scene))
    world += "    " + mjcf_geom(shape, "friction=\"0 0.005 0.0001\"", meshes) + "\n";
  std::string loose;
  for (const LooseBody& body : all.scene.loose) {
    if (body.mesh != nullptr) continue;
    loose += "    <body name=\"" + xml_escaped(body.name) + "\" " + mjcf_place(body.start.pose) +
             ">\n      <freejoint/>\n      <geom " + loose_geom(body) + " mass=\"" + exact_number(body.mass) +
             "\" friction=\"" + exact_number(std::sqrt(body.friction * all.scene.ground_friction)) +
             " 0.005 0.0001\"/>\n    </body>\n";
  }
  std::string assets;
  for (const auto& [name, shape] : meshes.all())
    assets += "    <mesh name=\"" + xml_escaped(name) + "\" file=\"" + xml_escaped(name) + ".obj\"/>\n";
  const std::string unbalanced = unbalanced_links(all.model);
  if (!unbalanced.empty())
    std::printf("no body has the inertia of %s; balanceinertia lets MuJoCo take the mean of its moments\n", unbalanced.c_str());
  std::string out = "<mujoco model=\"" + xml_escaped(all.scene.name) +
                    "\">\n  <!-- Written by `twinbus export`.  Friction of bodies is put together with the ground's, whose own is "
                    "0. -->\n  <compiler angle=\"radian\" meshdir=\"meshes\"" +
                    std::string(unbalanced.empty() ? "" : " balanceinertia=\"true\"") + "/>\n  <option timestep=\"" +
                    exact_number(all.model.period()) +
                    "\" integrator=\"implicitfast\" gravity=\"0 0 -9.81\"/>\n  <default>\n    <default class=\"visual\">\n"
                    "      <geom contype=\"0\" conaffinity=\"0\" group=\"2\" density=\"0\"/>\n    </default>\n"
                    "    <default class=\"collision\">\n      <geom group=\"3\"/>\n    </default>\n  </default>\n";
  const auto section = [&](const char* name, const std::string& inside) {
    if (!inside.empty()) out += std::string("  <") + name + ">\n" + inside + "  </" + name + ">\n";
  };
  section("asset", assets);
  section("worldbody", world + robot.body + loose);
  section("contact", robot.contact);
  section("equality", robot.equality);
  section("actuator", robot.actuator);
  section("sensor", robot.sensor);
  section("keyframe", keyframe(all));
  return out + "</mujoco>\n";
}

// Ground and obstacles as a URDF to be welded to the world.
std::string world_urdf(const Scene& scene) {
  std::string out = "<?xml version=\"1.0\"?>\n<!-- Written by `twinbus export`: weld it to the world. -->\n<robot name=\"world\">\n"
                    "  <link name=\"ground\">\n";
  std::vector<Shape> shapes = still_things(scene);
  Shape ground;
  ground.kind = ShapeKind::kBox;
  ground.size << 40.0, 40.0, 1.0;
  ground.pose.translation().z() = -0.5;
  shapes.insert(shapes.begin(), ground);
  for (const Shape& shape : shapes) {
    const std::string geometry =
        shape.kind == ShapeKind::kSphere ? "<sphere radius=\"" + exact_number(shape.size[0]) + "\"/>"
        : shape.kind == ShapeKind::kCylinder
            ? "<cylinder radius=\"" + exact_number(shape.size[0]) + "\" length=\"" + exact_number(shape.size[1]) + "\"/>"
            : "<box size=\"" + exact_numbers(shape.size) + "\"/>";
    for (const char* kind : {"collision", "visual"})
      out += std::string("    <") + kind + ">" + urdf_origin(shape.pose) + "<geometry>" + geometry + "</geometry></" + kind + ">\n";
  }
  return out + "  </link>\n</robot>\n";
}

void write_file(const fs::path& path, const std::string& text) {
  if (fs::exists(path)) throw std::runtime_error(path.string() + ": exists; name a new folder");
  fs::create_directories(path.parent_path());
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(path.string() + ": cannot be written");
}

// What other simulators are not told.
void tell_left_out(const Scene& scene) {
  const auto tell = [](std::size_t count, const char* what) {
    if (count > 0) std::printf("left out: %zu %s\n", count, what);
  };
  std::size_t meshes = 0;
  for (const LooseBody& body : scene.loose) meshes += body.mesh != nullptr ? 1 : 0;
  tell(meshes, "loose bodies that are meshes");
  tell(scene.robots.size(), "further robots");
  tell(scene.loops.size(), "loops");
  tell(scene.grasps.size(), "grasps");
  tell(scene.pushes.size(), "pushes");
  tell(scene.modes.size() + scene.goals.size() + scene.walks.size(), "commands to the controller");
}

}  // namespace

int export_command(const std::vector<std::string>& words) {
  const Arguments arguments(
      {"export",
       "SCENE",
       "Writes the robot of a scene in its start posture, with ground, tiles, obstacles and loose bodies, for another simulator.\n"
       "mjcf: FOLDER/scene.xml for MuJoCo, with servos by the gains of robot.yaml, an IMU and the keyframe `start`.\n"
       "urdf: FOLDER/robot.urdf and FOLDER/world.urdf, for Drake and others: rotors as drake:rotor_inertia.\n"
       "Contacts are another simulator's own: stiffness and damping of soles are not handed over.",
       {robot_option(),
        {"--to", "FORMAT", "mjcf or urdf"},
        {"--out", "FOLDER", "where to write; default SCENE_mjcf or SCENE_urdf"},
        {"--start-pose", "POSE", "of the robot's SRDF; default the scene's"},
        {"--seed", "N", "of what the scene draws (tiles); default 1"}},
       1,
       1},
      words);
  const std::string format = arguments.text("--to", "mjcf");
  if (format != "mjcf" && format != "urdf") throw UsageError("export: --to is '" + format + "'; use mjcf or urdf");
  const Exported all = load(arguments);
  const fs::path folder = arguments.text("--out", all.scene.name + "_" + format);
  ExportedMeshes meshes;
  std::string main_file;
  if (format == "mjcf") {
    main_file = (folder / "scene.xml").string();
    write_file(main_file, mjcf_of(all, meshes));
  } else {
    main_file = (folder / "robot.urdf").string();
    write_file(main_file, urdf_of_model(all.model, meshes));
    write_file(folder / "world.urdf", world_urdf(all.scene));
  }
  for (const auto& [name, shape] : meshes.all()) write_file(folder / "meshes" / (name + ".obj"), obj_of(shape));
  tell_left_out(all.scene);
  std::printf("written: %s\n", main_file.c_str());
  return 0;
}

}  // namespace twinbus
