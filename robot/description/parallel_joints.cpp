#include "robot/description/parallel_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/strict_yaml.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

namespace {

constexpr double kMostFar = 10.0;        // [m]
constexpr double kShortest = 1e-3;       // crank or rod [m]
constexpr double kLeastRange = 0.02;     // of a joint [rad]
constexpr double kAnySpeed = 1e3;        // of a joint without a limit of its own [rad/s]
constexpr double kDrawnIn = 1e-3;        // that is worth a word [rad]

Eigen::Vector3d motor_point(const ConfigNode& node, const std::string& key) {
  const std::vector<double> v = node.numbers(key, 3);
  const Eigen::Vector3d point(v[0], v[1], v[2]);
  if (!(point.allFinite() && point.cwiseAbs().maxCoeff() <= kMostFar)) node.fail(key, "must be within 10 m");
  return point;
}

RodMotor read_motor(const ConfigNode& node) {
  RodMotor motor;
  motor.name = node.text("name");
  motor.center = motor_point(node, "crank");
  motor.axis = motor_point(node, "axis");
  if (!(motor.axis.norm() > 1e-6)) node.fail("axis", "must be a direction, as [0, 1, 0]");
  motor.axis.normalize();
  motor.arm = motor_point(node, "arm");
  const Eigen::Vector3d crank = motor.arm - motor.center;
  if (!((crank - crank.dot(motor.axis) * motor.axis).norm() >= kShortest))
    node.fail("arm", "must be at least 1 mm from the motor's axis, which leads through crank");
  motor.rod = motor_point(node, "rod");
  const double reduction = node.number("reduction", 1e-3, 1e4, 1.0);
  motor.torque = reduction * node.number("torque", 1e-3, 1e5);
  motor.speed = node.number("speed", 1e-3, 1e5) / reduction;
  motor.rotor_inertia = reduction * reduction * node.number("rotor_inertia", 0.0, 1e3, 0.0);
  const std::vector<double> range = node.numbers("range", 2);
  motor.lower = range[0];
  motor.upper = range[1];
  if (!(motor.lower <= 0.0 && motor.upper >= 0.0 && motor.lower < motor.upper))
    node.fail("range", "must hold 0, where the crank is at arm");
  if (!(motor.lower >= -std::numbers::pi && motor.upper <= std::numbers::pi)) node.fail("range", "must be within pi");
  node.finish();
  return motor;
}

int driven_joint(const Model& model, const std::string& name, const std::string& where) {
  const int j = model.find_joint(name);
  if (j < 0) throw std::runtime_error(where + ": there is no moving joint " + name + suggestion(name, model.joints));
  if (model.bus_index[static_cast<std::size_t>(j)] < 0)
    throw std::runtime_error(where + ": " + name + " has no motor or follows another joint; name two joints that are driven");
  if (model.joints[static_cast<std::size_t>(j)].kind != JointKind::kRevolute)
    throw std::runtime_error(where + ": " + name + " is no joint of type revolute; rods turn joints that have limits");
  return j;
}

ParallelJoints pair_of(const ParallelEntry& entry, const Model& model) {
  ParallelJoints pair;
  pair.where = entry.where;
  pair.driver_of_motors = entry.driver_of_motors;
  for (std::size_t i = 0; i < 2; ++i) pair.joints[i] = driven_joint(model, entry.joints[i], entry.where);
  const Joint& first = model.joints[static_cast<std::size_t>(pair.joints[0])];
  const Joint& second = model.joints[static_cast<std::size_t>(pair.joints[1])];
  if (second.parent != first.child)
    throw std::runtime_error(entry.where + ": " + second.name + " does not follow " + first.name +
                             "; name two joints in series, from the parent on");
  const Frame& parent = frame_called(model, entry.parent, entry.where + ": parent");
  const Frame& child = frame_called(model, entry.child, entry.where + ": child");
  if (parent.link != first.parent)
    throw std::runtime_error(entry.where + ": parent: " + entry.parent + " does not carry " + first.name +
                             "; name the link that the motors are on");
  if (child.link != second.child)
    throw std::runtime_error(entry.where + ": child: " + entry.child + " is not moved by " + second.name +
                             "; name the link that the rods end on");
  std::array<RodMotor, 2> motors = entry.motors;
  for (RodMotor& motor : motors) {
    motor.center = parent.in_link * motor.center;
    motor.arm = parent.in_link * motor.arm;
    motor.axis = parent.in_link.linear() * motor.axis;
    motor.rod = child.in_link * motor.rod;
  }
  pair.drive = RodDrive(
      {.first = first.placement, .second = second.placement, .first_axis = first.axis, .second_axis = second.axis}, motors);
  for (int i = 0; i < 2; ++i) {
    if (!(pair.drive.rod_length(i) >= kShortest))
      throw std::runtime_error(entry.where + ": the rod of motor " + motors[static_cast<std::size_t>(i)].name +
                               " has no length: arm and rod are one point with the joints at 0; correct one of them");
  }
  pair.box = {{first.lower, second.lower}, {first.upper, second.upper}};
  return pair;
}

// The joints keep, of what the URDF says, what the motors can do.
void take_limits(ParallelJoints& pair, Model& model) {
  std::array<Joint*, 2> joints{};
  for (std::size_t i = 0; i < 2; ++i) joints[i] = &model.joints[static_cast<std::size_t>(pair.joints[i])];
  const JointBox limits = pair.box;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(pair.where + ": " + joints[0]->name + " and " + joints[1]->name + " cannot be driven so: " + why +
                             "; correct the points, the range or the limits of the joints");
  };
  if (const std::string why = not_used_for(pair.drive, middle_of(limits)); !why.empty()) refuse(why);
  const std::optional<JointBox> box = usable_box(pair.drive, limits);
  pair.box = box ? *box : JointBox{};
  if (!((pair.box.upper - pair.box.lower).minCoeff() >= kLeastRange)) refuse("nothing is left of the range of a joint");
  RodPosture rest;
  (void)pair.drive.at(middle_of(limits), rest);
  Eigen::Vector2d speed;
  for (int i = 0; i < 2; ++i) {
    const double own = joints[static_cast<std::size_t>(i)]->velocity;
    // Without a limit of its own: what the motors give it alone.
    const Eigen::Array2d asked(std::abs(rest.jacobian(0, i)), std::abs(rest.jacobian(1, i)));
    const Eigen::Array2d given(pair.drive.motor(0).speed, pair.drive.motor(1).speed);
    speed[i] = own > 0.0 && std::isfinite(own) ? own : std::min(kAnySpeed, (given / asked.max(1e-9)).minCoeff());
  }
  speed = speed_box(pair.drive, {middle_of(limits), middle_of(limits)}, speed);
  const Eigen::Vector2d torque = torque_alone(pair.drive, rest);
  const Eigen::Vector2d rotors(pair.drive.motor(0).rotor_inertia, pair.drive.motor(1).rotor_inertia);
  const Eigen::Vector2d reflected = rest.jacobian.cwiseAbs2().transpose() * rotors;  // diagonal of J^T I J
  for (int i = 0; i < 2; ++i) {
    Joint& joint = *joints[static_cast<std::size_t>(i)];
    if (pair.box.lower[i] > joint.lower + kDrawnIn || pair.box.upper[i] < joint.upper - kDrawnIn) {
      model.notes.push_back(pair.where + ": " + joint.name +
                            formatted(" has a range of %.3f to %.3f rad, of which the motors reach %.3f to %.3f with the other joint "
                                      "anywhere in its own", joint.lower, joint.upper, pair.box.lower[i], pair.box.upper[i]));
    }
    joint.lower = pair.box.lower[i];
    joint.upper = pair.box.upper[i];
    joint.velocity = speed[i];
    joint.effort = torque[i];
    if (rotors.maxCoeff() > 0.0) joint.rotor_inertia = reflected[i];
  }
}

}  // namespace

ParallelEntry read_parallel_joints(const ConfigNode& node) {
  ParallelEntry entry;
  entry.where = node.where("joints");
  const std::vector<std::string> joints = node.texts("joints");
  if (joints.size() != 2) node.fail("joints", "must name two joints in series, from the parent on");
  if (joints[0] == joints[1]) node.fail("joints", "names " + joints[0] + " twice; name two joints");
  entry.joints = {joints[0], joints[1]};
  entry.parent = node.text("parent");
  entry.child = node.text("child");
  const std::vector<ConfigNode> motors = node.list("motors");
  if (motors.size() != 2) node.fail("motors", "must be two");
  for (std::size_t i = 0; i < 2; ++i) entry.motors[i] = read_motor(motors[i]);
  if (entry.motors[0].name == entry.motors[1].name) motors[1].fail("name", "is that of the first motor too");
  entry.driver_of_motors = node.choice("driver", {"joints", "motors"}, 0) == 1;
  node.finish();
  return entry;
}

void apply_parallel_joints(const std::vector<ParallelEntry>& entries, Model& model) {
  std::vector<ParallelJoints> pairs;
  for (const ParallelEntry& entry : entries) {
    ParallelJoints pair = pair_of(entry, model);
    for (const int j : pair.joints) {
      if (pair_with(pairs, j) != nullptr)
        throw std::runtime_error(entry.where + ": " + model.joints[static_cast<std::size_t>(j)].name +
                                 " is in another pair already; leave one of them out");
    }
    take_limits(pair, model);
    pairs.push_back(pair);
  }
}

std::vector<ParallelJoints> parallel_joints_of(const Model& model) {
  std::vector<ParallelJoints> pairs;
  if (model.yaml_text.find("parallel_joints") == std::string::npos) return pairs;
  const ConfigNode top = ConfigNode::parse(model.yaml_text, model.folder + "/robot.yaml");
  for (const ConfigNode& node : top.list("parallel_joints")) {
    const ParallelEntry entry = read_parallel_joints(node);
    const bool moves = model.find_joint(entry.joints[0]) >= 0 && model.find_joint(entry.joints[1]) >= 0;
    if (moves) pairs.push_back(pair_of(entry, model));
  }
  return pairs;
}

}  // namespace twinbus::robot
