#include "robot/description/model_builder.h"

#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

namespace {

Joint to_joint(const UrdfJoint& from, int parent, int index, const Eigen::Isometry3d& placement) {
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
  joint.rotor_inertia = from.rotor_inertia;
  return joint;
}

// Sums mass, first and second moment about the body's origin; finish_masses turns them into CoM and
// inertia.
void absorb(Link& body, const UrdfLink& part, const Eigen::Isometry3d& in_body) {
  const Eigen::Isometry3d frame = in_body * part.inertial;
  const Eigen::Vector3d c = frame.translation();
  const Eigen::Matrix3d about_com = frame.linear() * part.inertia * frame.linear().transpose();
  body.inertia +=
      about_com + part.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  body.com += part.mass * c;
  body.mass += part.mass;
  const auto add = [&](const std::vector<Shape>& from, std::vector<Shape>& to) {
    for (Shape shape : from) {
      shape.pose = in_body * shape.pose;
      to.push_back(std::move(shape));
    }
  };
  add(part.collision, body.collision);
  add(part.visual, body.visual);
}

void add_link(Model& model, const std::string& name, int parent) {
  Link link;
  link.name = name;
  link.parent = parent;
  model.links.push_back(std::move(link));
}

}  // namespace

void ModelBuilder::fix_joints(const std::vector<std::string>& names, const std::string& yaml_file) {
  for (const std::string& name : names) {
    tree_.joints[static_cast<std::size_t>(urdf_joint(name, yaml_file + ": fixed_joints"))].fixed =
        true;
  }
}

void ModelBuilder::rest_joints(const std::vector<std::string>& names, double angle, const std::string& where) {
  for (const std::string& name : names) {
    UrdfJoint& joint = tree_.joints[static_cast<std::size_t>(urdf_joint(name, where))];
    if (joint.fixed) throw std::runtime_error(where + ": joint " + name + " is fixed too; leave it out here or there");
    if (!joint.mimic.empty()) throw std::runtime_error(where + ": joint " + name + " follows " + joint.mimic + ", or is named twice");
    if (joint.kind != JointKind::kContinuous && !(angle >= joint.lower && angle <= joint.upper))
      throw std::runtime_error(where + ": the rest of " + name + " is outside its limits");
    const UrdfJoint* driven = nullptr;
    for (int link = joint.parent; driven == nullptr;) {
      const int up = tree_.links[static_cast<std::size_t>(link)].parent_joint;
      if (up < 0) throw std::runtime_error(where + ": no joint with a motor carries " + name + "; fix it, or give it a motor");
      const UrdfJoint& above = tree_.joints[static_cast<std::size_t>(up)];
      if (!above.fixed && above.mimic.empty()) driven = &above;
      link = above.parent;
    }
    joint.mimic = driven->name;
    joint.mimic_multiplier = 0.0;
    joint.mimic_offset = angle;
  }
}

std::vector<std::string> ModelBuilder::fix_weightless() {
  std::vector<double> behind(tree_.links.size(), 0.0);
  for (std::size_t i = 0; i < tree_.links.size(); ++i) {
    // Towards the root; the number of links is limited by the check.
    for (int link = static_cast<int>(i); link >= 0;) {
      behind[static_cast<std::size_t>(link)] += tree_.links[i].mass;
      const int up = tree_.links[static_cast<std::size_t>(link)].parent_joint;
      link = up < 0 ? -1 : tree_.joints[static_cast<std::size_t>(up)].parent;
    }
  }
  std::vector<std::string> fixed;
  for (UrdfJoint& joint : tree_.joints) {
    if (joint.fixed || behind[static_cast<std::size_t>(joint.child)] > 0.0) continue;
    joint.fixed = true;
    fixed.push_back(joint.name);
  }
  return fixed;
}

void ModelBuilder::build(Model& model, bool for_bus) {
  frames_.resize(tree_.links.size());
  model_index_.assign(tree_.joints.size(), -1);
  model.name = tree_.name;
  add_link(model, tree_.links[static_cast<std::size_t>(tree_.root)].name, -1);
  grow(model, tree_.root, 0, Eigen::Isometry3d::Identity());
  model.frames = frames_;
  model.notes = tree_.notes;
  model.bus_index.assign(model.joints.size(), -1);
  for (std::size_t i = 0; i < tree_.joints.size(); ++i) {  // the bus has the order of the file
    const int index = model_index_[i];
    if (index < 0 || !tree_.joints[i].mimic.empty()) continue;
    model.bus_index[static_cast<std::size_t>(index)] = model.bus_count();
    model.bus_joints.push_back(index);
  }
  for (std::size_t i = 0; i < tree_.joints.size(); ++i) resolve_mimic(model, i);
  finish_masses(model);
  if (for_bus && model.bus_joints.size() > static_cast<std::size_t>(kMaxJoints)) {
    throw std::runtime_error(file_ + ": " + std::to_string(model.bus_joints.size()) +
                             " actuated joints; the bus carries " + std::to_string(kMaxJoints) +
                             ": name some under fixed_joints in robot.yaml");
  }
}

int ModelBuilder::urdf_joint(const std::string& name, const std::string& where) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < tree_.joints.size(); ++i) {
    if (tree_.joints[i].name == name) return static_cast<int>(i);
    known.push_back(tree_.joints[i].name);
  }
  throw std::runtime_error(where + ": there is no joint " + name + suggestion(name, known));
}

// Puts a URDF link and what hangs on it into model link `body`.  Recursion is as deep as the tree:
// the number of links is limited by the check.
void ModelBuilder::grow(Model& model, int urdf_link, int body, const Eigen::Isometry3d& in_body) {
  const UrdfLink& link = tree_.links[static_cast<std::size_t>(urdf_link)];
  frames_[static_cast<std::size_t>(urdf_link)] = {
      .name = link.name, .link = body, .in_link = in_body};
  absorb(model.links[static_cast<std::size_t>(body)], link, in_body);
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
    add_link(model, tree_.links[static_cast<std::size_t>(joint.child)].name, body);
    grow(model, joint.child, index + 1, Eigen::Isometry3d::Identity());
  }
}

// A link without mass may stand between two joints, as long as something behind it has mass.
void ModelBuilder::finish_masses(Model& model) const {
  std::vector<double> behind(model.links.size(), 0.0);
  for (std::size_t i = model.links.size(); i-- > 0;) {
    Link& link = model.links[i];
    behind[i] += link.mass;
    if (link.parent >= 0) behind[static_cast<std::size_t>(link.parent)] += behind[i];
    if (!(behind[i] > 0.0) && (i > 0 || model.floating_base)) {
      throw std::runtime_error(file_ + ": link " + link.name + " moves but has no mass" +
                               (i == 0 ? "; give it an <inertial>"
                                       : "; give it an <inertial>, or name joint " +
                                             model.joints[i - 1].name +
                                             " under fixed_joints in robot.yaml"));
    }
    if (!(link.mass > 0.0)) continue;
    const Eigen::Vector3d c = link.com / link.mass;
    link.com = c;
    link.inertia -= link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    link.inertia = 0.5 * (link.inertia + link.inertia.transpose()).eval();
  }
}

void ModelBuilder::resolve_mimic(Model& model, std::size_t urdf_index) const {
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
      fail_at(file_, at->line,
              "joint " + at->name + " mimics " + at->mimic + ", which robot.yaml fixes; fix both");
    }
    at = &tree_.joints[static_cast<std::size_t>(next)];
  }
  Joint& joint = model.joints[static_cast<std::size_t>(index)];
  joint.mimic = followed;
  joint.mimic_multiplier = followed < 0 ? 1.0 : multiplier;
  joint.mimic_offset = offset;
}

}  // namespace twinbus::robot
