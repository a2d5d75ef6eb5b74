#include "sim/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/quantity.h"
#include "common/text/strict_yaml.h"
#include "common/text/xml.h"
#include "robot/description/load.h"
#include "robot/motion/motion_file.h"
#include "sim/objects/rigid_object_mesh.h"
#include "sim/scene/fidelity.h"
#include "sim/scene/scene_obstacle.h"
#include "sim/scene/scene_places.h"
#include "sim/scene/scene_scale.h"
#include "sim/scene/scene_vectors.h"
#include "sim/scene/settings.h"
#include "sim/world/world_origin.h"

namespace twinbus::inline sim {

namespace {

const Eigen::Vector3d kNone = Eigen::Vector3d::Zero();  // where nothing is said

constexpr double kDay = 86400.0;
constexpr double kLeastAccuracy = 1e-9, kMostAccuracy = 0.1;  // [m]
constexpr std::size_t kMaxObstacles = 200;
// Planner and guard leave none of a scene's out.
static_assert(kMaxObstacles <= static_cast<std::size_t>(Collision::kMaxObstacles));
constexpr std::size_t kMaxLoose = 100;
constexpr std::size_t kMaxRobots = 15;

LooseBody read_loose(const ConfigNode& node) {
  LooseBody body;
  body.name = node.text("name");
  constexpr int kMesh = 4;
  const int shape = node.choice("shape", {"box", "sphere", "cylinder", "capsule", "mesh"}, 0);
  const std::size_t numbers[] = {3, 1, 2, 2};
  if (shape != kMesh) {
    body.solid.shape = static_cast<SolidShape>(shape);
    const std::vector<double> size = node.numbers("size", numbers[shape]);
    for (std::size_t i = 0; i < size.size(); ++i) {
      if (!(size[i] >= 1e-3 && size[i] <= 100.0)) node.fail("size", "must be from 0.001 to 100 m");
      body.solid.size[static_cast<Eigen::Index>(i)] = size[i];
    }
  }
  body.mass = node.number("mass", 1e-3, 1e5);
  body.start.pose.translation() = bounded(node, "position", 1000.0, nullptr);
  body.start.pose.linear() = rpy(node).toRotationMatrix();
  if (shape == kMesh) {
    const TriangleMesh mesh = read_mesh(node);
    try {
      give_mesh(mesh, body);
    } catch (const std::runtime_error& error) {
      node.fail("file", error.what());
    }
  }
  body.start.velocity = bounded(node, "velocity", kMaxSpeed, &kNone);
  body.start.angular_velocity = bounded(node, "angular_velocity", 100.0, &kNone);
  body.friction = node.number("friction", 0.0, 10.0, body.friction);
  body.stiffness = node.number("stiffness", 1e2, 1e9, body.stiffness);
  // Half critical for a body on four points.
  body.damping = node.number("damping", 0.0, 1e7, std::sqrt(0.25 * body.stiffness * body.mass));
  node.finish();
  return body;
}

SceneRobot read_robot(const ConfigNode& node, const std::string& own) {
  SceneRobot robot;
  robot.name = node.text("name");
  robot.robot = node.text("robot", own);
  robot.pose = node.text("pose", robot.pose);
  const std::vector<double> at = node.numbers("position", 2);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!(std::abs(at[i]) <= 1000.0)) node.fail("position", "must be within 1000 m");
    robot.place.translation()[static_cast<Eigen::Index>(i)] = at[i];
  }
  const double yaw = node.number("yaw_deg", -360.0, 360.0, 0.0) * kDegree;
  robot.place.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  node.finish();
  return robot;
}

// The point of a link that is held or pushed.
template <class At>
void read_place(const ConfigNode& node, At& at) {
  at.link = node.text("link");
  at.point = bounded(node, "point", 10.0, &kNone);
}

Grasp read_grasp(const ConfigNode& node) {
  Grasp grasp;
  read_place(node, grasp);
  grasp.to = node.text("to");
  grasp.at = node.number("at", 0.0, kDay);
  grasp.until = node.number("until", grasp.at, 1e9, grasp.until);
  grasp.reach = node.number("reach", 1e-3, 1.0, grasp.reach);
  grasp.stiffness = node.number("stiffness", 1e2, 1e10, grasp.stiffness);
  grasp.damping = node.number("damping", 0.0, 1e8, 1e-3 * grasp.stiffness);
  node.finish();
  return grasp;
}

Push read_push(const ConfigNode& node) {
  Push push;
  read_place(node, push);
  // force and for: as ./twinbus push has them.
  const bool by_force = node.has("force");
  if (by_force && node.has("impulse")) node.fail("force", "stands beside impulse: give one of them");
  const bool has_for = node.has("for");
  if (has_for && node.has("duration")) node.fail("for", "stands beside duration, which it means: give one of them");
  push.duration = has_for ? node.number("for", 1e-3, 60.0) : node.number("duration", 1e-3, 60.0, 0.1);
  push.impulse = by_force ? Eigen::Vector3d(push.duration * bounded(node, "force", 1e5, nullptr))
                          : bounded(node, "impulse", 1e4, nullptr);
  push.at = node.number("at", 0.0, kDay);
  node.finish();
  return push;
}

TimedMode read_mode(const ConfigNode& node) {
  TimedMode timed;
  timed.at = node.number("at", 0.0, kDay);
  const int mode = node.choice("mode", {"idle", "hold", "pose", "balance", "walk", "stop"}, -1);
  if (mode < 0) node.fail("mode", "is missing");
  timed.request.mode = static_cast<Mode>(mode + 1);
  timed.request.motion = static_cast<Motion>(node.choice("motion", {"none", "sway", "squat"}, 0));
  timed.request.duration = static_cast<float>(node.number("duration", 0.0, 3600.0, 2.0));
  timed.request.amplitude = static_cast<float>(node.number("amplitude", 0.0, 1.0, 0.0));
  timed.request.frequency = static_cast<float>(node.number("frequency", 0.0, 10.0, 0.0));
  timed.pose = node.text("pose", "");
  if (timed.request.mode == Mode::kPose && timed.pose.empty())
    node.fail("pose", "is missing: mode pose needs a named pose");
  node.finish();
  return timed;
}

TimedGoal read_goal(const ConfigNode& node) {
  TimedGoal timed;
  timed.at = node.number("at", 0.0, kDay);
  timed.hand = node.text("hand", "");
  if (timed.hand.empty()) node.fail("hand", "is missing: left or right, or the name that robot.yaml gives an arm");
  timed.request.side = timed.hand == "left" ? ArmSide::kLeft : timed.hand == "right" ? ArmSide::kRight : ArmSide::kThird;
  timed.request.speed = static_cast<float>(node.number("speed", 0.01, 1.0, 1.0));
  timed.pose = node.text("pose", "");
  if (node.flag("cancel", false)) {
    timed.request.kind = ArmGoalKind::kCancel;
  } else if (!timed.pose.empty()) {
    timed.request.kind = ArmGoalKind::kJoints;
  } else {
    timed.of_reach = node.has("reach");
    if (timed.of_reach) timed.reach = bounded(node, "reach", 1.0, nullptr);
    const Eigen::Vector3d position = bounded(node, "position", 10.0, timed.of_reach ? &kNone : nullptr);
    timed.request.kind = node.has("rpy_deg") ? ArmGoalKind::kPose : ArmGoalKind::kPosition;
    const Eigen::Quaterniond q = rpy(node);
    for (int i = 0; i < 3; ++i) timed.request.position[static_cast<std::size_t>(i)] = position[i];
    timed.request.orientation = {q.w(), q.x(), q.y(), q.z()};
  }
  node.finish();
  return timed;
}

TimedWalk read_walk(const ConfigNode& node) {
  TimedWalk timed;
  timed.at = node.number("at", 0.0, kDay);
  timed.duration = node.number("for", 0.0, kDay);
  timed.request.vx = static_cast<float>(node.number("vx", -2.0, 2.0, 0.0));
  timed.request.vy = static_cast<float>(node.number("vy", -1.0, 1.0, 0.0));
  timed.request.wz = static_cast<float>(node.number("wz", -2.0, 2.0, 0.0));
  timed.request.timeout = 0.1F;
  node.finish();
  return timed;
}

TimedPad read_pad(const ConfigNode& node) {
  TimedPad timed;
  timed.at = node.number("at", 0.0, kDay);
  timed.duration = node.number("for", 0.0, kDay);
  timed.request.connected = timed.request.deadman = true;
  timed.request.left_x = static_cast<float>(node.number("left_x", -1.0, 1.0, 0.0));
  timed.request.left_y = static_cast<float>(node.number("left_y", -1.0, 1.0, 0.0));
  timed.request.right_x = static_cast<float>(node.number("right_x", -1.0, 1.0, 0.0));
  node.finish();
  return timed;
}

TimedSteps read_timed_steps(const ConfigNode& node) {
  TimedSteps timed;
  timed.at = node.number("at", 0.0, kDay);
  timed.request = read_steps(node);
  node.finish();
  return timed;
}

// file: beside the scene, or as it is.
TimedMotion read_timed_motion(const ConfigNode& node, const std::filesystem::path& folder) {
  TimedMotion timed;
  timed.at = node.number("at", 0.0, kDay);
  const auto beside = [&](const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / name, ignored) ? (folder / name).string() : name;
  };
  timed.file = beside(node.text("file"));
  timed.columns = node.text("columns", "");
  if (!timed.columns.empty()) timed.columns = beside(timed.columns);
  timed.rate = node.number("rate", 1.0, 10'000.0, 0.0);
  timed.speed = node.number("speed", 0.05, 1.0, 1.0);
  timed.from = node.number("from", 0.0, 1e6, 0.0);
  timed.until = node.number("until", 0.0, 1e6, 0.0);
  timed.upper_only = node.flag("upper", false);
  node.finish();
  return timed;
}

Terrain read_terrain(const ConfigNode& node) {
  Terrain terrain;
  terrain.tile = node.number("tile", 0.05, 10.0, terrain.tile);
  terrain.height = node.number("height", 0.0, 0.2, terrain.height);
  terrain.slope = kDegree * node.number("slope_deg", 0.0, 20.0, 0.0);
  terrain.ramp = kDegree * node.number("ramp_deg", 0.0, 20.0, 0.0);
  terrain.from = node.number("from", -100.0, 100.0, terrain.from);
  terrain.length = node.number("length", 0.0, 100.0);
  terrain.width = node.number("width", 0.1, 100.0, terrain.width);
  const double tiles =
      std::ceil(terrain.length / terrain.tile) * std::ceil(terrain.width / terrain.tile);
  if (!(tiles <= static_cast<double>(kMaxObstacles)))
    node.fail("length", "makes more than 200 tiles with this width and tile");
  node.finish();
  return terrain;
}

PushRound read_push_round(const ConfigNode& node) {
  PushRound round;
  round.link = node.text("link", "");
  round.at = node.number("at", 0.0, kDay, round.at);
  round.every = node.number("every", 0.1, kDay, round.every);
  round.count = static_cast<int>(node.integer("count", 0, 10000));
  round.phase = node.number("phase", 0.0, 60.0, round.phase);
  round.forward = node.number("forward", 0.0, 10.0, 0.0);
  round.back = node.number("back", 0.0, 10.0, round.forward);
  round.sideways = node.number("sideways", 0.0, 10.0, 0.0);
  round.duration = node.number("duration", 1e-3, 60.0, round.duration);
  node.finish();
  return round;
}

Disturbance read_disturbance(const ConfigNode& node) {
  Disturbance d;
  d.position = node.number("position", 0.0, 1.0, 0.0);
  d.angle = kDegree * node.number("angle_deg", 0.0, 180.0, 0.0);
  d.velocity = node.number("velocity", 0.0, 10.0, 0.0);
  d.spin = node.number("spin", 0.0, 100.0, 0.0);
  d.mass = node.number("mass", 0.0, 0.9, 0.0);
  d.friction = node.number("friction", 0.0, 0.9, 0.0);
  d.joints = node.number("joints", 0.0, 10.0, 0.0);
  node.finish();
  return d;
}

BodyChange read_body(const ConfigNode& node) {
  BodyChange change;
  change.link = node.text("link");
  change.mass = node.number("mass", 0.0, 1000.0, 0.0);
  change.at = bounded(node, "at", 10.0, &kNone);
  change.shift = bounded(node, "shift", 1.0, &kNone);
  node.finish();
  return change;
}

std::string find_scene(const std::string& name_or_file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_regular_file(name_or_file, ignored)) return name_or_file;
  const fs::path folder = fs::path(config_folder()) / "scenes";
  if (name_or_file.find('/') == std::string::npos) {
    const fs::path path = folder / (name_or_file + ".yaml");
    if (fs::is_regular_file(path, ignored)) return path.string();
  }
  throw std::runtime_error("no scene '" + name_or_file + "'" + suggestion(name_or_file, scene_names()) +
                           " (./twinbus scenes lists them; or give a file)");
}

std::vector<double> pose_on_bus(const Scene& scene, const Model& model, const std::string& pose) {
  const int index = model.find_pose(pose);
  if (index < 0) {
    std::string list;
    for (const NamedPose& known : model.poses) list += " " + known.name;
    throw std::runtime_error("scene " + scene.name + ": the robot " + model.name +
                             " has no pose '" + pose + "'; it has" + list);
  }
  std::vector<double> q;
  for (int joint : model.bus_joints) {
    q.push_back(model.poses[static_cast<std::size_t>(index)].q[static_cast<std::size_t>(joint)]);
  }
  return q;
}

}  // namespace

double metres_of(const std::string& text) {
  constexpr Unit kLengths[] = {{"", 1.0}, {"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};
  const double metres = quantity_of(text, kLengths);
  return std::isfinite(metres) && metres > 0.0 ? metres : 0.0;
}

std::string read_accuracy(const std::string& text, double& metres) {
  metres = metres_of(text);
  if (!(metres > 0.0)) return "must be a length such as 0.001 or 1mm, not '" + text + "'";
  if (metres >= kLeastAccuracy && metres <= kMostAccuracy) return "";
  return formatted("is %g m, and must be from 1e-9 to 0.1 m; millimetres are written %gmm", metres,
                   std::strtod(text.c_str(), nullptr));
}

std::vector<std::string> scene_names() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::vector<std::string> names;
  for (const auto& entry :
       fs::directory_iterator(fs::path(config_folder()) / "scenes", ignored)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scene load_scene(const std::string& name_or_file) {
  const std::string file = find_scene(name_or_file);
  Scene scene;
  scene.name = std::filesystem::path(file).stem().string();
  scene.text = read_text_file(file);
  const ConfigNode top = ConfigNode::parse(scene.text, file);
  scene.about = top.text("about", "");
  scene.robot = top.text("robot", scene.robot);
  const int engine = top.choice("engine", {std::begin(kEngineNames), std::end(kEngineNames)}, 0);
  scene.engine = kEngineNames[engine];
  scene.contact = kContactNames[top.choice("contact", {std::begin(kContactNames), std::end(kContactNames)}, 0)];
  scene.duration = top.number("duration", 0.01, kDay, scene.duration);
  scene.step = top.number("step", 1e-5, 0.1, scene.step);
  if (top.has("accuracy")) {
    const std::string problem = read_accuracy(top.text("accuracy"), scene.accuracy);
    if (!problem.empty()) top.fail("accuracy", problem);
  }
  scene.fidelity = kFidelityNames[top.choice("fidelity", {std::begin(kFidelityNames), std::end(kFidelityNames)}, 0)];
  scene.held = top.texts("held");
  scene.rigid = top.texts("rigid");
  scene.aloft = top.texts("aloft");
  scene.untouched = top.texts("untouched");
  scene.start_pose = top.text("start_pose", scene.start_pose);
  if (top.has("start_velocity")) {
    const ConfigNode speeds = top.map("start_velocity");
    for (const std::string& joint : speeds.keys())
      scene.start_velocity.emplace_back(joint, speeds.number(joint, -kMaxSpeed, kMaxSpeed));
    speeds.finish();
  }
  if (top.has("origin")) {
    const std::vector<double> origin = top.numbers("origin", 2);
    for (std::size_t i = 0; i < 2; ++i) {
      if (!(std::abs(origin[i]) <= kMostOrigin)) top.fail("origin", "must be within 100000 m");
      scene.origin[static_cast<Eigen::Index>(i)] = origin[i];
    }
  }
  scene.in_arm_lengths = top.choice("lengths", {"metres", "arm"}, 0) == 1;
  scene.fixed_base = top.choice("base", {"floating", "fixed"}, 0) == 1;
  if (top.has("ground")) {
    const ConfigNode ground = top.map("ground");
    scene.ground_friction = ground.number("friction", 0.0, 10.0, scene.ground_friction);
    ground.finish();
  }
  for (const ConfigNode& node : top.list("obstacles"))
    read_obstacle(node, scene.obstacles);
  if (scene.obstacles.size() > kMaxObstacles)
    top.fail("obstacles", "at most 200, and these are " + std::to_string(scene.obstacles.size()) +
                              "; of meshes, points and height maps a larger `cell` makes fewer");
  for (const ConfigNode& node : top.list("pushes")) scene.pushes.push_back(read_push(node));
  for (const ConfigNode& node : top.list("modes")) scene.modes.push_back(read_mode(node));
  for (const ConfigNode& node : top.list("goals")) scene.goals.push_back(read_goal(node));
  for (const ConfigNode& node : top.list("walks")) scene.walks.push_back(read_walk(node));
  for (const ConfigNode& node : top.list("pads")) scene.pads.push_back(read_pad(node));
  for (const ConfigNode& node : top.list("footsteps"))
    scene.steps.push_back(read_timed_steps(node));
  for (const ConfigNode& node : top.list("motions"))
    scene.motions.push_back(read_timed_motion(node, std::filesystem::path(file).parent_path()));
  for (const ConfigNode& node : top.list("bodies")) scene.bodies.push_back(read_body(node));
  for (const ConfigNode& node : top.list("loose")) {
    scene.loose.push_back(read_loose(node));
    scene.loose_at.push_back(node.where("name"));
    for (std::size_t i = 0; i + 1 < scene.loose.size(); ++i) {
      if (scene.loose[i].name != scene.loose.back().name) continue;
      node.fail("name", "two loose bodies are called '" + scene.loose[i].name + "'");
    }
  }
  if (scene.loose.size() > kMaxLoose) top.fail("loose", "at most 100");
  for (const ConfigNode& node : top.list("robots")) {
    scene.robots.push_back(read_robot(node, scene.robot));
    for (std::size_t i = 0; i + 1 < scene.robots.size(); ++i) {
      if (scene.robots[i].name != scene.robots.back().name) continue;
      node.fail("name", "two robots are called '" + scene.robots[i].name + "'");
    }
  }
  if (scene.robots.size() > kMaxRobots) top.fail("robots", "at most 15");
  scene.self_contact = top.flag("self_contact", false);
  scene.asleep = top.flag("asleep", false);
  for (const ConfigNode& node : top.list("loops")) scene.loops.push_back(read_loop(node));
  for (const ConfigNode& node : top.list("grasps")) scene.grasps.push_back(read_grasp(node));
  if (scene.loops.size() + scene.grasps.size() > kMaxLoose) {
    top.fail("loops", "at most 100 loops and grasps");
  }
  if (top.has("terrain")) scene.terrain = read_terrain(top.map("terrain"));
  if (top.has("push_round")) scene.push_round = read_push_round(top.map("push_round"));
  scene.robust = top.flag("robust", false);
  if (top.has("disturbance")) scene.disturbance = read_disturbance(top.map("disturbance"));
  if (top.has("criteria")) {
    std::vector<std::string> loose, robots;
    for (const LooseBody& body : scene.loose) loose.push_back(body.name);
    for (const SceneRobot& robot : scene.robots) robots.push_back(robot.name);
    scene.criteria = read_criteria(top.map("criteria"), loose, robots);
  }
  if (top.has("settings")) {
    const ConfigNode settings = top.map("settings");
    for (const std::string& key : settings.keys()) {
      SimSettings scratch;
      const std::string value = settings.text(key);
      const std::string complaint = apply_setting(key, value, 0.002, scratch);
      if (!complaint.empty()) settings.fail(key, complaint);
      scene.settings.emplace_back(key, value);
    }
    settings.finish();
  }
  top.finish();
  return scene;
}

void start_in(const std::string& pose, const Model& model, Scene& scene) {
  if (pose != scene.start_pose && model.find_pose(pose) < 0)
    throw std::runtime_error(model.name + " has no pose '" + pose + "'" + suggestion(pose, model.poses) + ", to begin in");
  scene.start_pose = pose;
}

MotionClip clip_of(const TimedMotion& timed, const Scene& scene, const Model& model) {
  MotionFormat format;
  format.rate = timed.rate;
  if (!timed.columns.empty()) format.columns = motion_columns(timed.columns);
  format.from = timed.from;
  format.until = timed.until;
  const MotionOptions options{.speed = timed.speed, .stand = scene.start_pose, .upper_only = timed.upper_only};
  return {model, read_motion(timed.file, format), options};
}

void resolve_poses(Scene& scene, const Model& model) {
  for (TimedMotion& timed : scene.motions) {
    const MotionClip clip = clip_of(timed, scene, model);
    timed.period = clip.period();
    timed.pieces = clip.pieces(1);
  }
  scale_to(scene, model);
  name_places(scene, model);
  add_floor(scene, model);
  for (TimedMode& timed : scene.modes) {
    if (timed.pose.empty()) continue;
    const std::vector<double> q = pose_on_bus(scene, model, timed.pose);
    std::copy(q.begin(), q.end(), timed.request.q.begin());
    timed.request.joint_mask = static_cast<std::int64_t>((std::uint64_t{1} << q.size()) - 1);
  }
  for (TimedGoal& timed : scene.goals) {
    if (timed.pose.empty()) continue;
    const std::vector<double> q = pose_on_bus(scene, model, timed.pose);
    const Hand* hand = hand_of(model, number_of(timed.request.side));
    if (hand == nullptr) continue;
    std::copy(q.begin(), q.end(), timed.request.q.begin());
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      if (std::find(hand->joints.begin(), hand->joints.end(), model.bus_joints[k]) !=
          hand->joints.end()) {
        timed.request.joint_mask |= std::int64_t{1} << k;
      }
    }
  }
}

}  // namespace twinbus::sim
