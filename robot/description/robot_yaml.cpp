#include "robot/description/robot_yaml.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/guard_defaults.h"

namespace twinbus::inline robot {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const char* const kSides[2] = {"left", "right"};
constexpr double kLeastMargin = 0.001;  // [m]
constexpr double kRounded = 1e-6;       // a finger's place may be off its limit by so much [rad or m]

}  // namespace

Eigen::Isometry3d read_offset(const ConfigNode& node) {
  const std::vector<double> at = node.numbers("at", 3, {0.0, 0.0, 0.0});
  const std::vector<double> rpy = node.numbers("rpy", 3, {0.0, 0.0, 0.0});
  for (const double value : at) {
    if (!(std::abs(value) <= 10.0)) node.fail("at", "must be within 10 m");
  }
  for (const double value : rpy) {
    if (!(std::abs(value) <= 6.3)) node.fail("rpy", "must be within 2 pi");
  }
  Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();
  offset.translation() << at[0], at[1], at[2];
  if (rpy != std::vector<double>{0.0, 0.0, 0.0}) {
    offset.linear() = rotation_from_rpy(rpy[0], rpy[1], rpy[2]);
  }
  return offset;
}

Walking read_walking(const ConfigNode& node) {
  Walking w;
  w.single_support = node.number("single_support", 0.1, 5.0, w.single_support);
  w.double_support = node.number("double_support", 0.01, 5.0, w.double_support);
  w.width = node.number("width", 0.0, 2.0, w.width);
  w.lift = node.number("lift", 0.0, 0.5, w.lift);
  w.com_height = node.number("com_height", 0.0, 5.0, w.com_height);
  w.zmp_forward = node.number("zmp_forward", -0.5, 0.5, w.zmp_forward);
  w.zmp_inward = node.number("zmp_inward", -0.2, 0.2, w.zmp_inward);
  w.fastest = node.number("fastest", 0.0, 10.0, w.fastest);
  w.preview = node.choice("pattern", {"closed_form", "preview"}, 0) == 1;
  w.gait = static_cast<PointGait>(node.choice("gait", {"trot", "crawl", "by_speed"}, 0));
  w.own_attitude = node.choice("attitude", {"imu", "estimated"}, 0) == 1;
  node.finish();
  return w;
}

namespace {

void read_limb(const ConfigNode& node, LimbEntry& entry) {
  entry.present = true;
  entry.frame = node.text("frame");
  entry.sensor = node.text("sensor", entry.frame);
  entry.offset = read_offset(node);
}

SoleEntry read_sole(const ConfigNode& node) {
  SoleEntry entry;
  read_limb(node, entry);
  entry.sole.front = node.number("front", 1e-3, 1.0);
  entry.sole.back = node.number("back", 1e-3, 1.0);
  entry.sole.left = node.number("left", 1e-3, 1.0);
  entry.sole.right = node.number("right", 1e-3, 1.0);
  entry.sole.stiffness = node.number("stiffness", 1e2, 1e9);
  entry.sole.damping = node.number("damping", 0.0, 1e7);
  entry.sole.friction = node.number("friction", 0.0, 10.0);
  node.finish();
  return entry;
}

HandEntry read_hand(const ConfigNode& node) {
  HandEntry entry;
  read_limb(node, entry);
  entry.joints = node.texts("joints");
  entry.carried_by = node.texts("carried_by");
  entry.where = node.where("carried_by");
  node.finish();
  return entry;
}

PlaneBase read_plane(const ConfigNode& node) {
  PlaneBase plane;
  plane.area = node.number("area", 0.1, 100.0, plane.area);
  plane.speed = node.number("speed", 0.01, 5.0, plane.speed);
  plane.turn_speed = node.number("turn_speed", 0.01, 10.0, plane.turn_speed);
  plane.height = node.number("height", -1.0, 5.0, plane.height);
  node.finish();
  return plane;
}

NearPairEntry read_near_pair(const ConfigNode& node) {
  const std::vector<std::string> links = node.texts("links");
  if (links.size() != 2) node.fail("links", "must name two links");
  if (links[0] == links[1]) node.fail("links", "names " + links[0] + " twice; name two links");
  NearPairEntry entry{.links = {links[0], links[1]},
                      .margin = node.number("margin", kLeastMargin, GuardDefaults::kInController),
                      .where = node.where("links")};
  node.finish();
  return entry;
}

Tool read_tool(const ConfigNode& node, const std::string& name) {
  Tool entry{.name = name, .frame = node.text("frame"), .offset = read_offset(node), .where = node.where("frame")};
  node.finish();
  return entry;
}

GripperEntry read_gripper(std::size_t hand, const ConfigNode& node) {
  GripperEntry entry{.hand = hand, .joints = node.texts("joints"), .open{}, .closed{}, .node = node};
  if (entry.joints.empty()) node.fail("joints", "must name at least one joint");
  entry.open = node.numbers("open", entry.joints.size());
  entry.closed = node.numbers("closed", entry.joints.size());
  node.finish();
  return entry;
}

ServoEntry read_servo(const ConfigNode& node) {
  ServoEntry entry{.joints = node.texts("joints"),
                   .kp = node.number("kp", 0.0, 1e7, kNan),
                   .kd = node.number("kd", 0.0, 1e6, kNan),
                   .stop_kp = node.number("stop_kp", 0.0, 1e7, kNan),
                   .stop_kd = node.number("stop_kd", 0.0, 1e6, kNan),
                   .rate = node.number("rate", 1e-3, 1e3, kNan),
                   .rotor_inertia = node.number("rotor_inertia", 0.0, 1e3, kNan),
                   .friction = node.number("friction", 0.0, 1e4, kNan),
                   .damping = node.number("damping", 0.0, 1e5, kNan),
                   .node = node};
  if (entry.joints.empty()) node.fail("joints", "must name at least one joint");
  node.finish();
  return entry;
}

// By their numbers, whether or not the robot has a left and a right one.
std::vector<std::string> hand_names(const RobotYaml& yaml) {
  std::vector<std::string> names{kSides[0], kSides[1]};
  for (const auto& [name, entry] : yaml.more_hands) names.push_back(name);
  return names;
}

PassiveEntry read_passive(const ConfigNode& node) {
  PassiveEntry entry{.joints = node.texts("joints"),
                     .stiffness = node.number("stiffness", 0.0, 1e6, 0.0),
                     .damping = node.number("damping", 0.0, 1e5, kNan),
                     .rest = node.number("rest", -10.0, 10.0, 0.0),
                     .where = node.where("joints")};
  if (entry.joints.empty()) node.fail("joints", "must name at least one joint");
  node.finish();
  return entry;
}

}  // namespace

RobotYaml parse_robot_yaml(const std::string& text, const std::string& file) {
  const ConfigNode top = ConfigNode::parse(text, file);
  RobotYaml yaml;
  yaml.urdf = top.text("urdf");
  yaml.srdf = top.text("srdf", "");
  if (top.has("packages")) {
    const ConfigNode packages = top.map("packages");
    for (const std::string& name : packages.keys())
      yaml.packages.emplace_back(name, packages.text(name));
  }
  yaml.fixed_joints = top.texts("fixed_joints");
  yaml.inertia_from_shape = top.texts("inertia_from_shape");
  const std::size_t base = static_cast<std::size_t>(top.choice("base", {"floating", "fixed", "planar"}, 0));
  yaml.floating_base = base == 0;
  if (base == 2) yaml.plane = top.has("planar") ? read_plane(top.map("planar")) : PlaneBase();
  else if (top.has("planar")) top.fail("planar", "is of a base that moves on the plane: write base: planar, or leave it out");
  if (top.is_map("imu")) {
    const ConfigNode imu = top.map("imu");
    yaml.imu_frame = imu.text("frame");
    yaml.imu_offset = read_offset(imu);
    imu.finish();
  } else {
    yaml.imu_frame = top.text("imu", "");
  }

  Model& timing = yaml.timing;
  timing.period_ns = static_cast<std::int32_t>(
      std::llround(1e9 * top.number("period", 2e-4, 0.1, timing.period())));
  if (top.has("timeouts")) {
    const ConfigNode timeouts = top.map("timeouts");
    timing.command_timeout = timeouts.number("command", 1e-3, 10.0, timing.command_timeout);
    timing.state_timeout = timeouts.number("state", 1e-3, 10.0, timing.state_timeout);
    timing.guard_timeout = timeouts.number("guard", 1e-3, 10.0, timing.guard_timeout);
    timing.device_timeout = timeouts.number("device", 1e-3, 10.0, timing.device_timeout);
    timeouts.finish();
  }
  timing.blend_s = top.number("blend", 0.0, 10.0, timing.blend_s);
  timing.off_action =
      top.choice("off", {"torque_off", "damp"}, 1) == 0 ? OffAction::kTorqueOff : OffAction::kDamp;

  if (top.has("soles")) {
    const ConfigNode soles = top.map("soles");
    for (std::size_t side = 0; side < 2; ++side) {
      if (soles.has(kSides[side])) yaml.soles[side] = read_sole(soles.map(kSides[side]));
    }
    soles.finish();
    if (yaml.plane) top.fail("soles", "are of a robot that stands on feet: leave them out, or write base: floating");
  }
  if (top.has("hands")) {
    const ConfigNode hands = top.map("hands");
    for (std::size_t side = 0; side < 2; ++side) {
      if (hands.has(kSides[side])) yaml.hands[side] = read_hand(hands.map(kSides[side]));
    }
    for (const std::string& name : hands.keys()) {
      if (name == kSides[0] || name == kSides[1]) continue;
      if (yaml.more_hands.size() + 2 == static_cast<std::size_t>(kMostHands))
        hands.fail(name, "is one too many: beside left and right there may be " + std::to_string(kMostHands - 2));
      yaml.more_hands.emplace_back(name, read_hand(hands.map(name)));
    }
  }
  if (top.has("collision")) top.fail("collision", "is no choice any more: distances are always the robot's own; leave it out");
  if (top.has("walking")) {
    const ConfigNode walking = top.map("walking");
    if (walking.has("gait") && top.has("soles"))
      walking.fail("gait", "is of robots on four point feet, and this one has soles: leave it out");
    yaml.walking = read_walking(walking);
  }
  for (const ConfigNode& node : top.list("loops")) yaml.loops.push_back(read_loop(node));
  for (const ConfigNode& node : top.list("parallel_joints")) yaml.parallel_joints.push_back(read_parallel_joints(node));
  for (const ConfigNode& node : top.list("near_pairs")) yaml.near_pairs.push_back(read_near_pair(node));
  if (top.has("tools")) {
    const ConfigNode tools = top.map("tools");
    for (const std::string& name : tools.keys()) yaml.tools.push_back(read_tool(tools.map(name), name));
  }
  if (top.has("grippers")) {
    const ConfigNode grippers = top.map("grippers");
    for (const std::string& name : grippers.keys()) {
      const std::vector<std::string> names = hand_names(yaml);
      const auto found = std::find(names.begin(), names.end(), name);
      const auto number = static_cast<std::size_t>(found - names.begin());
      if (found == names.end() || (number < 2 && !yaml.hands[number].present))
        grippers.fail(name, "is of a hand that is not under `hands`" + suggestion(name, names));
      yaml.grippers.push_back(read_gripper(number, grippers.map(name)));
    }
  }
  if (top.has("mujoco")) {
    const ConfigNode mujoco = top.map("mujoco");
    yaml.mujoco = read_mujoco_config(mujoco);
    yaml.mujoco_contacts = mujoco.where("contacts");
  }
  yaml.leg_joints = top.texts("leg_joints");
  for (const ConfigNode& node : top.list("servos")) yaml.servos.push_back(read_servo(node));
  for (const ConfigNode& node : top.list("passive_joints")) yaml.passive_joints.push_back(read_passive(node));
  top.finish();
  return yaml;
}

std::array<Gripper, kMostHands> read_grippers(const RobotYaml& yaml, const Model& model) {
  std::array<Gripper, kMostHands> grippers;
  for (const GripperEntry& entry : yaml.grippers) {
    Gripper& gripper = grippers[entry.hand];
    gripper.open = entry.open;
    gripper.closed = entry.closed;
    for (std::size_t i = 0; i < entry.joints.size(); ++i) {
      const std::string& name = entry.joints[i];
      const int j = model.find_joint(name);
      if (j < 0) entry.node.fail("joints", "there is no moving joint '" + name + "'" + suggestion(name, model.joints));
      if (model.bus_index[at(j)] < 0) entry.node.fail("joints", name + " follows another joint: name that one");
      if (std::count(gripper.joints.begin(), gripper.joints.end(), j) != 0) entry.node.fail("joints", "names " + name + " twice");
      const Joint& joint = model.joints[at(j)];
      for (const auto& [key, place] : {std::pair<const char*, double&>{"open", gripper.open[i]}, {"closed", gripper.closed[i]}}) {
        if (!(place >= joint.lower - kRounded && place <= joint.upper + kRounded))
          entry.node.fail(key, name + formatted(" at %.6g is outside its limits, %.6g to %.6g", place, joint.lower, joint.upper));
        place = std::clamp(place, joint.lower, joint.upper);
      }
      gripper.joints.push_back(j);
    }
  }
  return grippers;
}

}  // namespace twinbus::robot
