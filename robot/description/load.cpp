#include "robot/description/load.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <stdexcept>

#include "common/file/beside_program.h"
#include "common/text/closest_name.h"
#include "common/text/xml.h"
#include "robot/description/model_builder.h"
#include "robot/description/model_hash.h"
#include "robot/description/robot_yaml.h"
#include "robot/description/shape_inertia.h"
#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

// share/twinbus/config of the installation that a program outside the tree is linked with; cmake/twinbusConfig.cmake.in
// defines it in that program's project, because only there the prefix is known.  Null elsewhere.
extern "C" [[gnu::weak]] const char* twinbus_installed_config();

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

int need_joint(const Model& model, const std::string& name, const std::string& where) {
  const int index = model.find_joint(name);
  if (index >= 0) return index;
  throw std::runtime_error(where + ": there is no moving joint " + name + suggestion(name, model.joints));
}

void apply_servos(const RobotYaml& yaml, Model& model) {
  std::map<const double*, std::string> said;  // which entry gave a number
  std::string where;
  const auto take = [&](double value, double& into) {
    if (!std::isfinite(value)) return;
    const auto [known, fresh] = said.emplace(&into, where);
    if (!fresh) {
      throw std::runtime_error(where +
                               ": a number of this servo is given a second time, first at " +
                               known->second + "; leave one of them out");
    }
    into = value;
  };
  for (const ServoEntry& entry : yaml.servos) {
    for (const std::string& name : entry.joints) {
      const int index = need_joint(model, name, entry.node.where("joints"));
      Joint& joint = model.joints[static_cast<std::size_t>(index)];
      where = entry.node.where("joints") + ": " + name;
      take(entry.kp, joint.kp);
      take(entry.kd, joint.kd);
      if (std::isfinite(entry.kp)) joint.stop_kp = joint.kp;
      if (std::isfinite(entry.kd)) joint.stop_kd = joint.kd;
      take(entry.stop_kp, joint.stop_kp);
      take(entry.stop_kd, joint.stop_kd);
      take(entry.rate, joint.rate);
      take(entry.rotor_inertia, joint.rotor_inertia);
      take(entry.friction, joint.friction);
      take(entry.damping, joint.damping);
    }
  }
}

void apply_passive(const RobotYaml& yaml, Model& model) {
  for (const PassiveEntry& entry : yaml.passive_joints) {
    for (const std::string& name : entry.joints) {
      Joint& joint = model.joints[static_cast<std::size_t>(need_joint(model, name, entry.where))];
      joint.passive = true;
      joint.spring = entry.stiffness;
      joint.spring_rest = entry.rest;
      if (std::isfinite(entry.damping)) joint.damping = entry.damping;
    }
  }
}

// Where a sole or hand is, and what it feels with.
template <class Limb>
void place_limb(const LimbEntry& entry, const Model& model, const std::string& where, Limb& limb) {
  const Frame& frame = frame_called(model, entry.frame, where);
  const Frame& sensor = frame_called(model, entry.sensor, where);
  if (frame.link != sensor.link)
    throw std::runtime_error(where + ": " + entry.frame + " and " + entry.sensor + " are on different links");
  limb.link = frame.link;
  limb.place = entry.frame;
  limb.frame = frame.in_link * entry.offset;
  limb.sensor = entry.sensor == entry.frame ? limb.frame : sensor.in_link;
}

// Of a base that moves on the plane: as stiff as the weight on it asks [1/s^2, 1/s].
void find_plane_joints(Model& model) {
  constexpr double kStiff = 225.0, kDamped = 21.0, kTurned = 0.15;  // the last: radius of inertia, squared [m^2]
  for (const char* name : kPlaneJoints) {
    const int index = need_joint(model, name, model.folder);
    Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const double mass = model.total_mass() * (joint.kind == JointKind::kPrismatic ? 1.0 : kTurned);
    joint.kp = joint.stop_kp = kStiff * mass;
    joint.kd = joint.stop_kd = kDamped * mass;
    model.plane_joints.push_back(index);
  }
}

// The moving joints above the arm, from the outermost that is named on; of a base on the plane all.
void find_carriers(const HandEntry& entry, const Model& model, Hand& hand) {
  std::vector<int> above;  // from the base on
  if (!hand.joints.empty()) {
    for (int link = model.joints[static_cast<std::size_t>(hand.joints.front())].parent; link > 0;
         link = model.links[static_cast<std::size_t>(link)].parent)
      above.insert(above.begin(), link - 1);
  }
  auto first = model.plane_joints.empty() ? above.end() : above.begin();
  for (const std::string& name : entry.carried_by) {
    const auto found = std::find(above.begin(), above.end(), need_joint(model, name, entry.where));
    if (found == above.end()) throw std::runtime_error(entry.where + ": the arm does not hang on joint " + name);
    first = std::min(first, found);
  }
  std::copy_if(first, above.end(), std::back_inserter(hand.carriers),
               [&](int j) { return model.joints[static_cast<std::size_t>(j)].mimic < 0; });
}

Hand hand_from(const HandEntry& entry, const std::string& name, const Model& model, const std::string& file) {
  const std::string where = file + ": hands: " + name;
  Hand hand;
  hand.name = name;
  place_limb(entry, model, where, hand);
  for (const std::string& joint : entry.joints) hand.joints.push_back(need_joint(model, joint, where));
  find_carriers(entry, model, hand);
  return hand;
}

void apply_yaml(const RobotYaml& yaml, const std::string& file, Model& model) {
  model.period_ns = yaml.timing.period_ns;
  model.command_timeout = yaml.timing.command_timeout;
  model.state_timeout = yaml.timing.state_timeout;
  model.guard_timeout = yaml.timing.guard_timeout;
  model.device_timeout = yaml.timing.device_timeout;
  model.blend_s = yaml.timing.blend_s;
  model.off_action = yaml.timing.off_action;
  if (yaml.plane) find_plane_joints(model);
  if (!yaml.imu_frame.empty()) {
    const Frame& imu = frame_called(model, yaml.imu_frame, file + ": imu");
    model.imu_link = imu.link;
    model.imu_place = imu.name;
    model.imu = imu.in_link * yaml.imu_offset;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left" : "right";
    if (const SoleEntry& entry = yaml.soles[side]; entry.present) {
      model.soles[side] = entry.sole;
      place_limb(entry, model, file + ": soles: " + name, model.soles[side]);
    }
    if (const HandEntry& entry = yaml.hands[side]; entry.present) model.hands[side] = hand_from(entry, name, model, file);
  }
  for (const auto& [name, entry] : yaml.more_hands) model.more_hands.push_back(hand_from(entry, name, model, file));
  for (const std::string& joint : yaml.leg_joints) {
    model.leg_joints.push_back(need_joint(model, joint, file + ": leg_joints"));
  }
  const auto grippers = read_grippers(yaml, model);  // of further arms too, which gripper_of reads again
  std::copy_n(grippers.begin(), model.grippers.size(), model.grippers.begin());
  apply_servos(yaml, model);
  apply_passive(yaml, model);
  apply_parallel_joints(yaml.parallel_joints, model);
  model.loops = yaml.loops;
  for (const Loop& loop : yaml.loops) {
    for (const std::string& name : {loop.link, loop.to}) {
      if (name != "world") (void)frame_called(model, name, file + ": loops");
    }
  }
  for (const NearPairEntry& entry : yaml.near_pairs) {
    const NearPair pair{frame_called(model, entry.links[0], entry.where).link,
                        frame_called(model, entry.links[1], entry.where).link, entry.margin};
    if (pair.link_a != pair.link_b) model.near_pairs.push_back(pair);
  }
  model.tools = yaml.tools;
  for (const Tool& tool : yaml.tools) (void)frame_called(model, tool.frame, tool.where);
  model.mujoco = yaml.mujoco;
  for (const MujocoContact& contact : yaml.mujoco.contacts) {
    for (const std::string& name : contact.links) (void)frame_called(model, name, yaml.mujoco_contacts);
  }
  model.walking = yaml.walking;
  model.packages = yaml.packages;
}

void apply_srdf(const Srdf& srdf, const std::string& file, Model& model) {
  model.notes.insert(model.notes.end(), srdf.notes.begin(), srdf.notes.end());
  for (const SrdfPose& pose : srdf.poses) {
    NamedPose named;
    named.name = pose.name;
    named.q.assign(model.joints.size(), 0.0);
    for (const auto& [joint_name, value] : pose.joints) {
      const std::string where = file + ":" + std::to_string(pose.line) + ": pose " + pose.name;
      const int index = need_joint(model, joint_name, where);
      const Joint& joint = model.joints[static_cast<std::size_t>(index)];
      if (!(value >= joint.lower && value <= joint.upper)) {
        throw std::runtime_error(where + ": joint " + joint_name + " is outside its limits");
      }
      named.q[static_cast<std::size_t>(index)] = value;
    }
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const Joint& joint = model.joints[i];
      if (joint.mimic >= 0) {
        named.q[i] = joint.mimic_multiplier * named.q[static_cast<std::size_t>(joint.mimic)] +
                     joint.mimic_offset;
      }
    }
    model.poses.push_back(std::move(named));
  }
  for (const SrdfRotor& rotor : srdf.rotors) {
    const std::string where = file + ":" + std::to_string(rotor.line) + ": rotor_params";
    model.joints[static_cast<std::size_t>(need_joint(model, rotor.joint, where))].rotor_inertia =
        rotor.reflected_inertia;
  }
  for (const SrdfPair& pair : srdf.disabled) {
    const std::string where = file + ":" + std::to_string(pair.line) + ": disable_collisions";
    const int a = frame_called(model, pair.link_a, where).link;
    const int b = frame_called(model, pair.link_b, where).link;
    if (a != b) model.disabled_pairs.push_back({std::min(a, b), std::max(a, b)});
  }
}

Model build_robot(const RobotTexts& texts, const RobotYaml& yaml, const std::string& yaml_file) {
  const fs::path folder = texts.folder;
  Model model;
  model.yaml_text = texts.yaml;
  const std::string urdf_file = (folder / yaml.urdf).string();
  model.urdf_text = yaml.plane ? with_plane_joints(texts.urdf, urdf_file, *yaml.plane) : texts.urdf;
  model.floating_base = yaml.floating_base;

  ModelBuilder builder(parse_urdf(model.urdf_text, urdf_file,
                                  {.folder = folder.string(), .packages = yaml.packages}),
                       urdf_file);
  builder.fix_joints(yaml.fixed_joints, yaml_file);
  for (const PassiveEntry& entry : yaml.passive_joints) builder.rest_joints(entry.joints, entry.rest, entry.where);
  builder.build(model);
  model.folder = folder.string();
  for (const std::string& name : yaml.inertia_from_shape) {
    const std::string where = yaml_file + ": inertia_from_shape";
    take_inertia_from_shape(model.links[static_cast<std::size_t>(frame_called(model, name, where).link)]);
  }
  if (!yaml.srdf.empty()) {
    const std::string srdf_file = (folder / yaml.srdf).string();
    model.srdf_text = texts.srdf;
    apply_srdf(parse_srdf(model.srdf_text, srdf_file), srdf_file, model);
  }
  apply_yaml(yaml, yaml_file, model);  // wins over the SRDF
  model.hash = model_hash(model);
  return model;
}

}  // namespace

std::string robot_folder(const std::string& name_or_folder) {
  if (name_or_folder.empty())
    throw std::runtime_error("the name of the robot is empty; name a folder of config/robots");
  std::error_code error;
  const bool plain_name = name_or_folder.find('/') == std::string::npos && name_or_folder != "." &&
                          name_or_folder != "..";
  const fs::path robots = fs::path(config_folder()) / "robots";
  if (plain_name && fs::is_directory(robots / name_or_folder, error))
    return (robots / name_or_folder).string();
  if (fs::is_directory(name_or_folder, error)) return name_or_folder;
  const std::string kind = fs::path(name_or_folder).extension().string();
  if (kind == ".urdf" || kind == ".xml" || kind == ".mjcf")
    throw std::runtime_error(name_or_folder + (fs::exists(name_or_folder, error) ? ": a file, and a robot is a folder: ./twinbus check FILE --propose FOLDER makes one"
                                                                                : ": no such file"));
  std::vector<std::string> known;
  for (const auto& entry : fs::directory_iterator(robots, error)) {
    if (entry.is_directory(error)) known.push_back(entry.path().filename().string());
  }
  throw std::runtime_error("no robot " + name_or_folder + ": neither a folder nor a name under " +
                           robots.string() +
                           (known.empty() ? "; TWINBUS_CONFIG names the folder that has robots/, scenes/ and stacks/"
                                          : suggestion(name_or_folder, known)));
}

std::string config_folder() {
  if (const char* named = std::getenv("TWINBUS_CONFIG"); named != nullptr && *named != '\0')
    return named;
  // A program of somebody else that uses this library: what lies beside that program is not ours.
  std::error_code error;
  if (twinbus_installed_config != nullptr && fs::is_directory(twinbus_installed_config(), error))
    return twinbus_installed_config();
  if (const std::string robots = beside_program("config/robots"); !robots.empty())
    return fs::path(robots).parent_path().string();
  for (const char* folder : {TWINBUS_CONFIG_FOLDER, "/usr/local/share/twinbus/config", "/usr/share/twinbus/config"}) {
    if (fs::is_directory(folder, error)) return folder;
  }
  return TWINBUS_CONFIG_FOLDER;
}

Model load_robot(const std::string& name_or_folder) {
  const fs::path folder = robot_folder(name_or_folder);
  const auto in_folder = [&](const std::string& name, const std::string& who) {
    if (name.find('/') != std::string::npos || name == "..") {
      throw std::runtime_error(who + ": " + name + " must be a file of the robot's folder");
    }
    return (folder / name).string();
  };
  const std::string yaml_file = (folder / "robot.yaml").string();
  RobotTexts texts{.folder = folder.string(), .yaml = read_text_file(yaml_file), .urdf{}, .srdf{}};
  const RobotYaml yaml = parse_robot_yaml(texts.yaml, yaml_file);
  texts.urdf = read_text_file(in_folder(yaml.urdf, yaml_file + ": urdf"));
  if (!yaml.srdf.empty()) texts.srdf = read_text_file(in_folder(yaml.srdf, yaml_file + ": srdf"));
  return build_robot(texts, yaml, yaml_file);
}

Model load_robot_texts(const RobotTexts& texts) {
  const std::string yaml_file = (fs::path(texts.folder) / "robot.yaml").string();
  return build_robot(texts, parse_robot_yaml(texts.yaml, yaml_file), yaml_file);
}

Model load_urdf(const std::string& urdf_file,
                const std::vector<std::pair<std::string, std::string>>& packages,
                bool floating_base) {
  Model model;
  model.folder = fs::absolute(urdf_file).parent_path().string();
  model.urdf_text = read_text_file(urdf_file);
  model.floating_base = floating_base;
  ModelBuilder(
      parse_urdf(model.urdf_text, urdf_file, {.folder = model.folder, .packages = packages}),
      urdf_file)
      .build(model);
  model.hash = model_hash(model);
  return model;
}

Model load_repaired_urdf(const std::string& text, const std::string& file,
                         const std::vector<std::pair<std::string, std::string>>& packages,
                         UrdfRepairs& repairs) {
  Model model;
  model.folder = fs::absolute(file).parent_path().string();
  model.urdf_text = text;
  ModelBuilder builder(parse_urdf(text, file, {.folder = model.folder, .packages = packages}),
                       file);
  builder.fix_joints(repairs.fixed_joints, file);
  for (const std::string& name : builder.fix_weightless()) repairs.fixed_joints.push_back(name);
  repairs.inertia_from_shape.clear();
  builder.build(model, false);
  for (Link& link : model.links) {
    if (!lacks_inertia(link)) continue;
    repairs.inertia_from_shape.push_back(link.name);
    take_inertia_from_shape(link);
  }
  model.hash = model_hash(model);
  return model;
}

}  // namespace twinbus::robot
