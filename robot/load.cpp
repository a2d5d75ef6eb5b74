#include "robot/load.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "robot/model_hash.h"
#include "robot/nearest.h"
#include "robot/robot_yaml.h"
#include "robot/srdf.h"
#include "robot/urdf.h"
#include "robot/xml.h"

namespace twinbus {

namespace {

namespace fs = std::filesystem;

// A frame of the URDF, in the link it was merged into.
struct Placed {
  int link = -1;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
};

// Makes a Model from the tree of the URDF: links joined by fixed joints become one.
class Builder {
 public:
  Builder(UrdfTree tree, std::string file) : tree_(std::move(tree)), file_(std::move(file)) {}

  void fix_joints(const std::vector<std::string>& names, const std::string& yaml_file) {
    for (const std::string& name : names) {
      tree_.joints[static_cast<std::size_t>(urdf_joint(name, yaml_file + ": fixed_joints"))].fixed =
          true;
    }
  }

  void build(Model& model) {
    placed_.resize(tree_.links.size());
    model_index_.assign(tree_.joints.size(), -1);
    model.name = tree_.name;
    add_link(model, tree_.root, -1);
    grow(model, tree_.root, 0, Eigen::Isometry3d::Identity());
    model.bus_index.assign(model.joints.size(), -1);
    for (std::size_t i = 0; i < tree_.joints.size(); ++i) {  // the bus has the order of the file
      const int index = model_index_[i];
      if (index < 0 || !tree_.joints[i].mimic.empty()) continue;
      model.bus_index[static_cast<std::size_t>(index)] = model.bus_count();
      model.bus_joints.push_back(index);
    }
    for (std::size_t i = 0; i < tree_.joints.size(); ++i) resolve_mimic(model, i);
    for (Link& link : model.links) finish_mass(model, link);
    if (model.bus_joints.size() > static_cast<std::size_t>(kMaxJoints)) {
      throw std::runtime_error(file_ + ": " + std::to_string(model.bus_joints.size()) +
                               " actuated joints; the bus carries " + std::to_string(kMaxJoints) +
                               ": name some under fixed_joints in robot.yaml");
    }
  }

  Placed frame(const std::string& name, const std::string& where) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < tree_.links.size(); ++i) {
      if (tree_.links[i].name == name) return placed_[i];
      known.push_back(tree_.links[i].name);
    }
    throw std::runtime_error(where + ": there is no link " + name + " in the URDF" +
                             suggestion(name, known));
  }

 private:
  int urdf_joint(const std::string& name, const std::string& where) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < tree_.joints.size(); ++i) {
      if (tree_.joints[i].name == name) return static_cast<int>(i);
      known.push_back(tree_.joints[i].name);
    }
    throw std::runtime_error(where + ": there is no joint " + name + suggestion(name, known));
  }

  void add_link(Model& model, int urdf_link, int parent) {
    Link link;
    link.name = tree_.links[static_cast<std::size_t>(urdf_link)].name;
    link.parent = parent;
    model.links.push_back(std::move(link));
  }

  // Puts a URDF link and what hangs on it into model link `body`.  Recursion is as deep as the
  // tree: the number of links is limited by the check.
  void grow(Model& model, int urdf_link, int body, const Eigen::Isometry3d& in_body) {
    placed_[static_cast<std::size_t>(urdf_link)] = {.link = body, .in_link = in_body};
    absorb(model.links[static_cast<std::size_t>(body)],
           tree_.links[static_cast<std::size_t>(urdf_link)], in_body);
    for (std::size_t i = 0; i < tree_.joints.size(); ++i) {
      const UrdfJoint& joint = tree_.joints[i];
      if (joint.parent != urdf_link) continue;
      const Eigen::Isometry3d placement = in_body * joint.origin;
      if (joint.fixed) {
        grow(model, joint.child, body, placement);
        continue;
      }
      const int index = model.joint_count();
      model_index_[i] = index;
      model.joints.push_back(to_joint(joint, body, index, placement));
      add_link(model, joint.child, body);
      grow(model, joint.child, index + 1, Eigen::Isometry3d::Identity());
    }
  }

  static Joint to_joint(const UrdfJoint& from, int parent, int index,
                        const Eigen::Isometry3d& placement) {
    Joint joint;
    joint.name = from.name;
    joint.kind = from.kind;
    joint.parent = parent;
    joint.child = index + 1;
    joint.placement = placement;
    joint.axis = from.axis;
    joint.lower = from.lower;
    joint.upper = from.upper;
    joint.velocity = from.velocity;
    joint.effort = from.effort;
    joint.damping = from.damping;
    joint.friction = from.friction;
    joint.rate = from.velocity;
    return joint;
  }

  // Sums mass, first and second moment about the body's origin; finish_mass turns them into CoM and
  // inertia.
  static void absorb(Link& body, const UrdfLink& part, const Eigen::Isometry3d& in_body) {
    const Eigen::Isometry3d frame = in_body * part.inertial;
    const Eigen::Vector3d c = frame.translation();
    const Eigen::Matrix3d about_com = frame.linear() * part.inertia * frame.linear().transpose();
    body.inertia +=
        about_com + part.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    body.com += part.mass * c;
    body.mass += part.mass;
    for (Shape shape : part.collision) {
      shape.pose = in_body * shape.pose;
      body.collision.push_back(std::move(shape));
    }
  }

  void finish_mass(const Model& model, Link& link) const {
    const bool moves = &link != &model.links.front() || model.floating_base;
    if (!(link.mass > 0.0)) {
      if (!moves) return;
      throw std::runtime_error(file_ + ": link " + link.name +
                               " moves but has no mass; give it an <inertial>");
    }
    const Eigen::Vector3d c = link.com / link.mass;
    link.com = c;
    link.inertia -= link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    link.inertia = 0.5 * (link.inertia + link.inertia.transpose()).eval();
  }

  void resolve_mimic(Model& model, std::size_t urdf_index) const {
    const int index = model_index_[urdf_index];
    if (index < 0) return;
    double multiplier = 1.0;
    double offset = 0.0;
    const UrdfJoint* at = &tree_.joints[urdf_index];
    int followed = -1;
    while (!at->mimic.empty()) {  // the check has made sure that this ends
      offset += multiplier * at->mimic_offset;
      multiplier *= at->mimic_multiplier;
      const int next = urdf_joint(at->mimic, file_);
      followed = model_index_[static_cast<std::size_t>(next)];
      if (followed < 0) {
        fail_at(
            file_, at->line,
            "joint " + at->name + " mimics " + at->mimic + ", which robot.yaml fixes; fix both");
      }
      at = &tree_.joints[static_cast<std::size_t>(next)];
    }
    Joint& joint = model.joints[static_cast<std::size_t>(index)];
    joint.mimic = followed;
    joint.mimic_multiplier = followed < 0 ? 1.0 : multiplier;
    joint.mimic_offset = offset;
  }

  UrdfTree tree_;
  std::string file_;
  std::vector<Placed> placed_;    // per URDF link
  std::vector<int> model_index_;  // per URDF joint, -1 if fixed
};

int need_joint(const Model& model, const std::string& name, const std::string& where) {
  const int index = model.find_joint(name);
  if (index >= 0) return index;
  std::vector<std::string> known;
  for (const Joint& joint : model.joints) known.push_back(joint.name);
  throw std::runtime_error(where + ": there is no moving joint " + name + suggestion(name, known));
}

void apply_servos(const RobotYaml& yaml, Model& model) {
  const auto take = [](double value, double& into) {
    if (std::isfinite(value)) into = value;
  };
  for (const ServoEntry& entry : yaml.servos) {
    for (const std::string& name : entry.joints) {
      const int index = need_joint(model, name, entry.node.where("joints"));
      Joint& joint = model.joints[static_cast<std::size_t>(index)];
      take(entry.kp, joint.kp);
      take(entry.kd, joint.kd);
      joint.stop_kp = joint.kp;
      joint.stop_kd = joint.kd;
      take(entry.stop_kp, joint.stop_kp);
      take(entry.stop_kd, joint.stop_kd);
      take(entry.rate, joint.rate);
      take(entry.rotor_inertia, joint.rotor_inertia);
      take(entry.friction, joint.friction);
      take(entry.damping, joint.damping);
    }
  }
}

void apply_yaml(const RobotYaml& yaml, const Builder& builder, const std::string& file,
                Model& model) {
  model.period_ns = yaml.timing.period_ns;
  model.command_timeout = yaml.timing.command_timeout;
  model.state_timeout = yaml.timing.state_timeout;
  model.guard_timeout = yaml.timing.guard_timeout;
  model.device_timeout = yaml.timing.device_timeout;
  model.blend_s = yaml.timing.blend_s;
  model.off_action = yaml.timing.off_action;
  if (!yaml.imu_frame.empty()) {
    const Placed imu = builder.frame(yaml.imu_frame, file + ": imu");
    model.imu_link = imu.link;
    model.imu = imu.in_link;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left" : "right";
    if (const SoleEntry& entry = yaml.soles[side]; entry.present) {
      const std::string where = file + ": soles: " + name;
      const Placed frame = builder.frame(entry.frame, where);
      const Placed sensor = builder.frame(entry.sensor, where);
      if (frame.link != sensor.link) {
        throw std::runtime_error(where + ": " + entry.frame + " and " + entry.sensor +
                                 " are on different links");
      }
      model.soles[side] = entry.sole;
      model.soles[side].link = frame.link;
      model.soles[side].frame = frame.in_link;
      model.soles[side].sensor = sensor.in_link;
    }
    if (const HandEntry& entry = yaml.hands[side]; entry.present) {
      const std::string where = file + ": hands: " + name;
      const Placed frame = builder.frame(entry.frame, where);
      const Placed sensor = builder.frame(entry.sensor, where);
      if (frame.link != sensor.link) {
        throw std::runtime_error(where + ": " + entry.frame + " and " + entry.sensor +
                                 " are on different links");
      }
      model.hands[side].link = frame.link;
      model.hands[side].frame = frame.in_link;
      model.hands[side].sensor = sensor.in_link;
      for (const std::string& joint : entry.joints) {
        model.hands[side].joints.push_back(need_joint(model, joint, where));
      }
    }
  }
  for (const std::string& joint : yaml.leg_joints) {
    model.leg_joints.push_back(need_joint(model, joint, file + ": leg_joints"));
  }
  apply_servos(yaml, model);
}

void apply_srdf(const Srdf& srdf, const Builder& builder, const std::string& file, Model& model) {
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
  for (const SrdfPair& pair : srdf.disabled) {
    const std::string where = file + ":" + std::to_string(pair.line) + ": disable_collisions";
    const int a = builder.frame(pair.link_a, where).link;
    const int b = builder.frame(pair.link_b, where).link;
    if (a != b) model.disabled_pairs.push_back({std::min(a, b), std::max(a, b)});
  }
}

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
  std::vector<std::string> known;
  for (const auto& entry : fs::directory_iterator(robots, error))
    known.push_back(entry.path().filename().string());
  throw std::runtime_error("no robot " + name_or_folder + ": neither a folder nor a name under " +
                           robots.string() + suggestion(name_or_folder, known));
}

}  // namespace

std::string config_folder() {
  if (const char* named = std::getenv("TWINBUS_CONFIG"); named != nullptr && *named != '\0')
    return named;
  std::error_code error;
  fs::path at = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int up = 0; !error && up < 4 && at.has_relative_path(); ++up, at = at.parent_path()) {
    if (fs::is_directory(at / "config" / "robots", error)) return (at / "config").string();
    error.clear();
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

  Model model;
  const std::string yaml_file = (folder / "robot.yaml").string();
  model.yaml_text = read_text_file(yaml_file);
  const RobotYaml yaml = parse_robot_yaml(model.yaml_text, yaml_file);
  const std::string urdf_file = in_folder(yaml.urdf, yaml_file + ": urdf");
  model.urdf_text = read_text_file(urdf_file);
  model.floating_base = yaml.floating_base;

  Builder builder(parse_urdf(model.urdf_text, urdf_file,
                             {.folder = folder.string(), .packages = yaml.packages}),
                  urdf_file);
  builder.fix_joints(yaml.fixed_joints, yaml_file);
  builder.build(model);
  model.folder = folder.string();
  apply_yaml(yaml, builder, yaml_file, model);
  if (!yaml.srdf.empty()) {
    const std::string srdf_file = in_folder(yaml.srdf, yaml_file + ": srdf");
    model.srdf_text = read_text_file(srdf_file);
    apply_srdf(parse_srdf(model.srdf_text, srdf_file), builder, srdf_file, model);
  }
  model.hash = model_hash(model);
  return model;
}

}  // namespace twinbus
