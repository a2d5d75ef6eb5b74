// `./twinbus export`: a scene for MuJoCo (MJCF) or Drake (URDF).

#include "launcher/commands/commands.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/process/arguments.h"
#include "launcher/run/fit_scene.h"
#include "robot/description/load.h"
#include "robot/description/parallel_joints.h"
#include "robot/mjcf/model_writer.h"
#include "robot/mjcf/urdf_text.h"
#include "sim/mujoco/mjcf_world.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"
#include "sim/world/static_equilibrium.h"

namespace twinbus::inline launcher {

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
  const Eigen::VectorXd q = Configuration(model, all.scene.start_pose).q;
  const std::array<double, 2> stiffness = {0.25 * model.soles[0].stiffness, 0.25 * model.soles[1].stiffness};
  all.start = stand(all.model, q, 1.0, stiffness, {0.0, 0.0}, !all.model.floating_base).configuration;
  for (const auto& [name, speed] : all.scene.start_velocity) {
    const int joint = model.find_joint(name);
    if (joint < 0) throw std::runtime_error(all.scene.name + ": start_velocity: there is no joint " + name);
    all.start.qd[joint] = speed;
  }
  return all;
}

WorldConfig world_of(const Scene& scene, double period) {
  WorldConfig config;
  config.step = period;
  config.ground_friction = scene.ground_friction;
  config.obstacles = scene.obstacles;
  config.tiles = scene.tiles;
  config.loose = scene.loose;
  return config;
}

std::string mjcf_of(const Exported& all, ExportedMeshes& meshes) {
  const MjcfWorld world = mjcf_of_world(all.scene.name, all.model, world_of(all.scene, all.model.period()), all.start,
                                        MjcfUse::kExport, meshes);
  if (!world.unbalanced.empty())
    std::printf("no body has the inertia of %s; balanceinertia lets MuJoCo take the mean of its moments\n",
                world.unbalanced.c_str());
  return world.xml;
}

// Ground and obstacles as a URDF to be welded to the world.
std::string world_urdf(const WorldConfig& config) {
  std::string out = "<?xml version=\"1.0\"?>\n<!-- Written by `twinbus export`: weld it to the world. -->\n<robot name=\"world\">\n"
                    "  <link name=\"ground\">\n";
  std::vector<Shape> shapes = shapes_of(config.obstacles);
  const std::vector<Shape> tiles = shapes_of(config.tiles);
  shapes.insert(shapes.end(), tiles.begin(), tiles.end());
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

// What other simulators are not told.
void tell_left_out(const Scene& scene, const Model& model) {
  const auto tell = [](std::size_t count, const char* what) {
    if (count > 0) std::printf("left out: %zu %s\n", count, what);
  };
  std::size_t meshes = 0;
  for (const LooseBody& body : scene.loose) meshes += body.mesh != nullptr ? 1 : 0;
  tell(meshes, "loose bodies that are meshes");
  tell(scene.robots.size(), "further robots");
  tell(scene.loops.size(), "loops");
  tell(parallel_joints_of(model).size(), "pairs of motors with cranks and rods; each of their joints has a servo and a limit of its own");
  tell(scene.grasps.size(), "grasps");
  tell(scene.pushes.size(), "pushes");
  tell(scene.modes.size() + scene.goals.size() + scene.walks.size(), "commands to the controller");
}

}  // namespace

int export_command(const std::vector<std::string>& words) {
  const Arguments arguments({"export", 1, 1, R"(SCENE
Writes the robot of a scene in its start posture, with ground, tiles, obstacles and loose bodies, for another simulator.
mjcf: FOLDER/scene.xml for MuJoCo, with servos by the gains of robot.yaml, an IMU and the keyframe `start`.
urdf: FOLDER/robot.urdf and FOLDER/world.urdf, for Drake and others: rotors as drake:rotor_inertia.
Contacts are another simulator's own: stiffness and damping of soles are not handed over.
  --robot
  --to FORMAT  mjcf or urdf
  --out FOLDER  where to write; default SCENE_mjcf or SCENE_urdf
  --start-pose POSE  of the robot's SRDF; default the scene's
  --seed N  of what the scene draws (tiles); default 1)"}, words);
  const std::string format = arguments.text("--to", "mjcf");
  if (format != "mjcf" && format != "urdf") throw UsageError("export: --to is '" + format + "'; use mjcf or urdf");
  const Exported all = load(arguments);
  const fs::path folder = arguments.text("--out", all.scene.name + "_" + format);
  ExportedMeshes meshes;
  std::string main_file;
  if (format == "mjcf") {
    main_file = (folder / "scene.xml").string();
    write_new(main_file, mjcf_of(all, meshes));
  } else {
    main_file = (folder / "robot.urdf").string();
    write_new(main_file, urdf_of_model(all.model, meshes));
    write_new(folder / "world.urdf", world_urdf(world_of(all.scene, all.model.period())));
  }
  for (const auto& [name, shape] : meshes.all()) write_new(folder / "meshes" / (name + ".obj"), obj_of(shape));
  tell_left_out(all.scene, all.model);
  std::printf("written: %s\n", main_file.c_str());
  return 0;
}

}  // namespace twinbus::launcher
